#include "harness/drawings/reduced_path.hpp"

#include <cmath>

#include "solvers/construction/derive.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {
namespace {

/// Figures of the path in the frame in which the plan builds.
class PlanView {
 public:
  PlanView(const Scene& scene, const Plan& plan) : scene_(scene), plan_(plan) {}

  Figure in_plan(const Figure& figure) const {
    return in_plan_frame(scene_, plan_, scene_.in_scene_unit(figure));
  }

  /// Of every instruction that has two intersections to choose from.
  std::string branch(const Figure& figure) const {
    std::string signs;
    for (const Instruction& instruction : plan_.instructions())
      if (chooses(instruction)) signs += side_of(instruction, figure.points) > 0 ? "+" : "−";
    return signs;
  }

  double driving_parameter(const Figure& figure) const {
    const auto& [instruction, sphere] = driven();
    return std::ldexp((figure.points.col(instruction->place) - sphere->reference).norm(),
                      scene_.unit_exponent());
  }

  std::pair<const Instruction*, const PlanSphere*> driven() const {
    for (const Instruction& instruction : plan_.instructions())
      for (int i = 0; i < instruction.count; ++i)
        if (const PlanSphere& sphere = instruction.spheres[static_cast<std::size_t>(i)]; sphere.is_driven())
          return {&instruction, &sphere};
    return {nullptr, nullptr};
  }

  /// Between two corners, for every instruction whose side is not the same at both; bisected on the segment.
  std::vector<BoundaryPlace> between(const PathCorner& from, const PathCorner& to) const {
    std::vector<BoundaryPlace> places;
    for (std::size_t i = 0; i < plan_.instructions().size(); ++i) {
      const Instruction& instruction = plan_.instructions()[i];
      const auto side_at = [&](double part) {
        return side_of(instruction, in_plan(mean(from, to, part)).points);
      };
      if (!chooses(instruction) || side_at(0) == side_at(1)) continue;
      double low = 0, high = 1;
      for (int halving = 0; halving < 40; ++halving) {
        const double middle = (low + high) / 2;
        (side_at(middle) == side_at(0) ? low : high) = middle;
      }
      const Figure figure = in_plan(mean(from, to, low));
      places.push_back(
          {scene_.in_file_unit(figure), (1 - low) * from.t + low * to.t, driving_parameter(figure), i});
    }
    return places;
  }

 private:
  static constexpr int plane = 2;

  static bool chooses(const Instruction& instruction) { return instruction.count == plane; }

  static Figure mean(const PathCorner& from, const PathCorner& to, double part) {
    return {(1 - part) * from.figure.points + part * to.figure.points, {}};
  }

  const Scene& scene_;
  const Plan& plan_;
};

}  // namespace

std::optional<ReducedPath> reduced_path(const StoredScene& stored) {
  const Scene scene = stored.record.instance;
  if (!stored.path || scene.dimension() != 2 || why_no_path(scene) || why_no_plan(scene)) return std::nullopt;
  ReducedPath reduced;
  reduced.plan = first_plan(scene, {});
  if (reduced.plan.driving_parameters() != 1) return std::nullopt;
  const PlanView view(scene, reduced.plan);
  reduced.driven_place = view.driven().first->place;
  reduced.driven_from = view.driven().second->center;
  const std::vector<PathCorner>& corners = stored.path->corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Figure figure = view.in_plan(corners[i].figure);
    reduced.k.push_back(view.driving_parameter(figure));
    reduced.branches.push_back(view.branch(figure));
    if (i == 0) continue;
    for (BoundaryPlace& place : view.between(corners[i - 1], corners[i]))
      reduced.boundaries.push_back(std::move(place));
  }
  return reduced;
}

}  // namespace gcs
