#include "solvers/exploring/explored_scene.hpp"

#include <numeric>

#include "solvers/elements/general_structure.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/tracking/general_path.hpp"

namespace gcs {
namespace {

/// Adds sign · coordinate `axis` of a point.
void add_coordinate(const DistanceSystem& system, int point, int axis, double sign, LinearForm& form) {
  if (const int unknown = system.unknown(point, axis); unknown >= 0)
    form.terms.push_back({unknown, exactly(sign)});
}

/// |p_a − p_b|² = a², of a point and the line y² + z² = a². The frame gives no coordinate but 0.
QuadraticSystem exact_distances(const Scene& scene, const DistanceSystem& system) {
  QuadraticSystem result{system.unknowns(), {}, mirror_axes(scene, system)};
  for (int e = 0; e < system.equations(); ++e) {
    const auto [a, b] = system.edges()[static_cast<std::size_t>(e)];
    QuadraticEquation& equation = result.equations.emplace_back();
    equation.given = given_square(scene, e);
    for (int axis = system.is_line(b) ? 1 : 0; axis < system.dimension(); ++axis) {
      LinearForm difference;
      add_coordinate(system, a, axis, 1, difference);
      if (!system.is_line(b)) add_coordinate(system, b, axis, -1, difference);
      if (!difference.terms.empty()) equation.products.push_back({difference, difference});
    }
  }
  return result;
}

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
      : ExploredScene(exact_distances(scene, system)), scene_(scene), system_(system) {
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
