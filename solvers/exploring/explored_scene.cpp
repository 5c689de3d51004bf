#include "solvers/exploring/explored_scene.hpp"

#include <numeric>

#include "solvers/elements/general_structure.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/model/distance_equations.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/tracking/general_path.hpp"

namespace gcs {
namespace {

/// Points, and a line that the frame puts on the x-axis.
class ExploredDistances final : public ExploredScene {
 public:
  explicit ExploredDistances(const Scene& scene)
      : ExploredDistances(scene, DistanceSystem(scene, wide_reference(scene))) {}

  Eigen::VectorXd unknowns(const Figure& figure) const override {
    return system_.coordinates(scene_.in_frame(figure, system_.reference()));
  }

 private:
  ExploredDistances(const Scene& scene, const DistanceSystem& system)
      : ExploredScene(distance_equations(scene, system)), scene_(scene), system_(system) {
    value_of_.resize(static_cast<std::size_t>(system_.equations()));
    std::iota(value_of_.begin(), value_of_.end(), 0);
    target_ = target_distances(
        scene, [this](const Eigen::VectorXd& y) { return system_.figure(y.head(system_.unknowns())); });
  }

  const Scene& scene_;
  const DistanceSystem system_;
};

class ExploredElements final : public ExploredScene {
 public:
  explicit ExploredElements(const Scene& scene)
      : ExploredScene(SceneSystem(scene).equations()), scene_(scene), system_(scene) {
    value_of_ = system_.value_of();
    target_ = target_values(system_);
  }

  Eigen::VectorXd unknowns(const Figure& figure) const override {
    const ComplexValues values = system_.coordinates(scene_.in_frame(figure));
    return Eigen::VectorXd::NullaryExpr(
        equations_.unknowns, [&](Eigen::Index i) { return values[static_cast<std::size_t>(i)].real(); });
  }

 private:
  const Scene& scene_;
  const SceneSystem system_;
};

}  // namespace

bool is_explored_by_elements(const Scene& scene) {
  return has_element_equations(scene.problem()) || scene.is_anchored() || scene.problem().lines.size() > 1;
}

std::optional<std::string> why_not_explored(const Scene& scene) {
  return is_explored_by_elements(scene) ? why_not_general(scene) : std::nullopt;
}

std::unique_ptr<ExploredScene> explored_scene(const Scene& scene) {
  if (is_explored_by_elements(scene)) return std::make_unique<ExploredElements>(scene);
  return std::make_unique<ExploredDistances>(scene);
}

}  // namespace gcs
