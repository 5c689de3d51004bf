#include "solvers/homotopies/released_report.hpp"

#include <utility>

#include "solvers/certificates/proven_error.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tangents/scene_spheres.hpp"

namespace gcs {

SolveReport carried_back(const ReleasedScene& released, const Scene& given, SolveReport report) {
  const std::optional<FourSpheres> spheres = spheres_of(given);
  const std::vector<DoubleDouble> squares = target_squares(given);
  const std::vector<Candidate> candidates = std::exchange(report.candidates, {});
  for (const Candidate& candidate : candidates) {
    std::optional<Figure> figure = released.carried_back(candidate.figure);
    if (!figure) continue;
    if (spheres) {
      const ComplexLine line = polished(*spheres, complex_lines(*figure).front(), figure->is_real(),
                                        candidate.multiplicity, report.work);
      figure = figure_of(complex_points(*figure), {line}, figure->is_real());
    }
    const double error = candidate.multiplicity > 1 ? candidate.error : proven_error(given, squares, *figure);
    report.candidates.push_back({*figure, candidate.multiplicity, error});
  }
  if (report.generic) *report.generic >>= released.doublings();
  report.generic_member.reset();
  report.escaping.clear();
  return report;
}

}  // namespace gcs
