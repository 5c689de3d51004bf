#include "solvers/homotopies/general_report.hpp"

#include <algorithm>

#include "solvers/homotopies/complex_report.hpp"
#include "solvers/homotopies/distinct_ends.hpp"
#include "solvers/homotopies/shortcomings.hpp"

namespace gcs {
namespace {

/// How far from the reals the end of a path may be, relative to 1 + its largest |x_i|, for its real part to be tried.
constexpr double nearly_real = 1e-6;
/// How far from there Newton's method may find the solution that the end is.
constexpr double same_solution = 1e-9;

double distance_from_reals(const ComplexVectorX& x) {
  double distance = 0;
  for (const std::complex<double>& value : x) distance = std::max(distance, std::abs(value.imag()));
  return distance / (1 + largest(x));
}

/// The real solution that a finite end is, if it is one.
std::optional<ComplexVectorX> real_solution(const GeneralEquations& equations, const ComplexVectorX& x,
                                            bool is_singular) {
  if (distance_from_reals(x) > (is_singular ? singular_uncertainty : nearly_real)) return std::nullopt;
  ComplexVectorX real = x;
  for (std::complex<double>& value : real) value = value.real();
  if (is_singular) return real;
  if (!newton(equations.system, equations.coefficients, real)) return std::nullopt;
  if (distance(real, x) > same_solution * (1 + largest(x))) return std::nullopt;
  return real;
}

void count_lost(const std::vector<PathEnd>& ends, Shortcomings& missing) {
  for (const PathEnd& end : ends)
    if (end.kind == PathEnd::Kind::failed) ++missing.lost[end.cause].count;
}

}  // namespace

SolveReport general_report(const SceneSystem& scene, const GeneralEquations& equations,
                           const std::vector<PathEnd>& ends, const WorkCounters& work,
                           std::mt19937_64& random) {
  SolveReport report;
  report.claim = Claim::all_complex;
  report.work = work;
  const DistinctEnds distinct(ends, equations.signs, random);
  Shortcomings missing;
  missing.jumps = distinct.jumps();
  for (int i = 0; i < distinct.size(); ++i) {
    missing.lonely += !distinct.has_conjugate(i);
    const bool is_singular = distinct.is_singular(i);
    const std::optional<ComplexVectorX> real = real_solution(equations, distinct[i], is_singular);
    report.candidates.push_back(
        {scene.figure(real.value_or(distinct[i]), real.has_value()), is_singular ? distinct.paths(i) : 1});
  }
  count_lost(ends, missing);
  for (const PathEnd& end : ends) report.paths.push_back(path_record(end));
  const bool stopped =
      std::ranges::any_of(ends, [](const PathEnd& end) { return end.kind == PathEnd::Kind::stopped; });
  report.reason = stopped ? "stopped on the way" : missing.in_words();
  report.status = stopped                 ? SolveStatus::stopped
                  : report.reason.empty() ? SolveStatus::complete
                                          : SolveStatus::partial;
  return report;
}

}  // namespace gcs
