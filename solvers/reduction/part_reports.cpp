#include "solvers/reduction/part_reports.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/certificates/proven_error.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {

void add(const std::vector<Particular>& more, std::vector<Particular>& particulars) {
  for (const Particular& particular : more) {
    const auto same = std::find_if(particulars.begin(), particulars.end(),
                                   [&](const Particular& other) { return other.name == particular.name; });
    if (same == particulars.end())
      particulars.push_back(particular);
    else
      same->value += particular.value;
  }
}

bool claims_all(Claim claim) { return claim == Claim::all_real || claim == Claim::all_complex; }

SolveStatus common_status(const std::vector<SolveReport>& reports, bool is_empty) {
  const auto any = [&](SolveStatus status) {
    return std::any_of(reports.begin(), reports.end(),
                       [&](const SolveReport& r) { return r.status == status; });
  };
  if (any(SolveStatus::stopped)) return SolveStatus::stopped;
  if (is_empty) return SolveStatus::complete;
  for (const SolveStatus status : {SolveStatus::gave_up, SolveStatus::infinite, SolveStatus::partial})
    if (any(status)) return status;
  return SolveStatus::complete;
}

Claim common_claim(const std::vector<SolveReport>& reports) {
  Claim claim = Claim::all_complex;
  for (const SolveReport& report : reports)
    if (report.claim != Claim::all_complex && claim != Claim::some_real) claim = report.claim;
  return claim;
}

bool is_own_mirror_image(const Scene& scene, const Figure& representative, double error) {
  constexpr double rounding = 1e-9;
  if (scene.has_lines() || std::isfinite(error)) return false;
  const double height = complex_points(representative).row(scene.dimension() - 1).cwiseAbs().maxCoeff();
  return height <= rounding * scene.size() &&
         !std::isfinite(proven_error(scene, target_squares(scene), representative));
}

ReflectionClasses classes_told_apart(const Scene& scene, const std::vector<Figure>& figures,
                                     std::vector<SolutionAccuracy>& accuracies) {
  constexpr std::size_t most_proven = 1000;  // a second or so
  ReflectionClasses classes = solution_classes(scene, figures, accuracies);
  const bool are_all_different = classes.first.size() == figures.size();
  if (are_all_different || figures.size() > most_proven || why_not_certified(scene)) return classes;
  const SceneEquations equations(scene);
  const Certifier certifier(equations.system());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const double error = certified_error(equations, certifier, scene.in_frame(figures[i]));
    accuracies[i].error = std::min(accuracies[i].error, error);
  }
  return solution_classes(scene, figures, accuracies);
}

}  // namespace gcs
