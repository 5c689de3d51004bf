#include "solvers/solving/unoriented_scene.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "solvers/elements/scene_system.hpp"
#include "solvers/elements/stated_signs.hpp"

namespace gcs {
namespace {

void reflect(LinePosition& line, Eigen::Index axis) {
  line.point[axis] = -line.point[axis];
  line.direction[axis] = -line.direction[axis];
}
void reflect(PlanePosition& plane, Eigen::Index axis) { plane.normal[axis] = -plane.normal[axis]; }

Figure mirror_image(Figure figure, Eigen::Index axis) {
  for (Eigen::Matrix3Xd* points : {&figure.points, &figure.imaginary}) points->row(axis) *= -1;
  for (auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (LinePosition& line : *lines) reflect(line, axis);
  for (auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (PlanePosition& plane : *planes) reflect(plane, axis);
  return figure;
}

/// Numbers of classes are others up to motion. Where not all that were counted are listed, nobody knows how many.
void leave_out_counts(SolveReport& report) {
  report.generic.reset();
  report.generic_member.reset();
  if (!report.totals) return;
  const Natural listed(report.candidates.size());
  const std::optional<Natural>& all = report.totals->complex ? report.totals->complex : report.totals->real;
  const bool lists_all = all && *all == listed;
  report.totals.reset();
  if (lists_all || report.status != SolveStatus::complete) return;
  report.status = SolveStatus::partial;
  report.reason = "of the solutions that are counted without orientations not all are listed";
}

}  // namespace

std::optional<Scene> unoriented(const Scene& scene) {
  if (scene.is_anchored() || why_no_system(scene)) return std::nullopt;
  auto problem = without_orientations(scene.problem());
  return problem ? std::optional(Scene::unchecked(*std::move(problem))) : std::nullopt;
}

SolveReport with_mirror_images(SolveReport report, const Scene& unoriented, const Scene& scene) {
  leave_out_counts(report);
  const int larger = unoriented.unit_exponent() - scene.unit_exponent();  // by this power of two
  const Eigen::Index axis = scene.dimension() - 1;
  const std::size_t count = report.candidates.size();
  report.candidates.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    Candidate& candidate = report.candidates[i];
    candidate = {candidate.figure.scaled(larger), candidate.multiplicity,
                 std::ldexp(candidate.error, larger)};
    report.candidates.push_back(
        {mirror_image(candidate.figure, axis), candidate.multiplicity, candidate.error});
  }
  return report;
}

}  // namespace gcs
