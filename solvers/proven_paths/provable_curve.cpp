#include "solvers/proven_paths/provable_curve.hpp"

#include <utility>

#include "solvers/proven_paths/general_path_data.hpp"
#include "solvers/tracking/distance_curve.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

namespace gcs {
namespace {

std::unique_ptr<ProvableCurve> curve_of_distances(const Scene& scene, int order, double tolerance) {
  const DistanceSystem system(scene);
  ProvableEquations exact{distance_equations(system), enclose_path_data(scene, system)};
  exact.far = times_far_away(scene.length_paths());
  if (!exact.data.is_finite())
    exact.no_start =
        "the sketch does not determine the frame: its reference points are not in general position";
  return std::make_unique<FollowedCurve<DistanceCurve>>(
      std::move(exact), DistanceCurve(scene, order, tolerance),
      [system](const Eigen::VectorXd& y) { return system.figure(y.head(system.unknowns())); });
}

}  // namespace

std::unique_ptr<ProvableCurve> provable_curve_of_elements(const Scene& scene, int order, double tolerance) {
  const auto system = std::make_shared<const SceneSystem>(scene);
  const auto sketched = sketched_unknowns(scene, *system);
  const Eigen::VectorXd start =
      sketched ? sketched->x : Eigen::VectorXd(Eigen::VectorXd::Zero(system->equations().unknowns));
  GeneralFamily family(scene, *system, start, order);
  ProvableEquations exact{general_equations(*system, family.values()),
                          enclose_path_data(scene, *system, family.values(), start),
                          system->equations().mirror, times_far_away(bounding_lengths(family.values()))};
  if (!sketched)
    exact.no_start = too_far_from_incidences;
  else if (!exact.data.is_finite())
    exact.no_start = "no figure beside the sketch is proven to meet the constraints without a value";
  return std::make_unique<FollowedCurve<GeneralCurve>>(
      std::move(exact), GeneralCurve(std::move(family), tolerance), [system](const Eigen::VectorXd& y) {
        return system->figure(ComplexValues(y.begin(), y.end() - 1), true);
      });
}

std::unique_ptr<ProvableCurve> provable_curve(const Scene& scene, int order, double tolerance) {
  return is_path_of_elements(scene) ? provable_curve_of_elements(scene, order, tolerance)
                                    : curve_of_distances(scene, order, tolerance);
}

}  // namespace gcs
