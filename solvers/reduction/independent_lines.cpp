#include "solvers/reduction/independent_lines.hpp"

#include <algorithm>
#include <utility>

#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/reduction/part_reports.hpp"

namespace gcs {
namespace {

bool seeks_lines_alone(const ProblemStatement& problem) {
  if (problem.is_general() || problem.lines.size() < 2) return false;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_point(entity) != problem.is_fixed(entity)) return false;
  return true;
}

/// The number of the line that a constraint is of.
int line_of(const ProblemStatement& problem, const DistanceConstraint& constraint) {
  return problem.line_of(std::max(constraint.between[0], constraint.between[1]));
}

ProblemStatement problem_of_line(const ProblemStatement& whole, int line) {
  const auto index = static_cast<std::size_t>(line);
  ProblemStatement part = whole;
  part.lines = {whole.lines[index]};
  part.fixed_lines = {std::nullopt};
  part.interpolation = {};
  part.constraints.clear();
  for (DistanceConstraint constraint : whole.constraints) {
    if (line_of(whole, constraint) != line) continue;
    for (int& end : constraint.between)
      if (whole.is_line(end)) end = static_cast<int>(whole.points.size());
    part.constraints.push_back(std::move(constraint));
  }
  if (part.sketch) part.sketch->lines = {whole.sketch->lines[index]};
  return part;
}

/// The line of a candidate of a part in the whole scene's unit, its multiplicity and its error.
struct PlacedLine {
  ComplexLine line;
  bool is_real = true;
  int multiplicity = 1;
  double error = 0;
};

std::vector<PlacedLine> placed_lines(const Scene& whole, const Scene& part, const SolveReport& report) {
  const double unit = std::ldexp(1.0, part.unit_exponent() - whole.unit_exponent());
  std::vector<PlacedLine> lines;
  for (const Candidate& candidate : report.candidates) {
    const Figure figure = candidate.figure.scaled(part.unit_exponent() - whole.unit_exponent());
    lines.push_back(
        {complex_lines(figure).front(), figure.is_real(), candidate.multiplicity, candidate.error * unit});
  }
  return lines;
}

ComplexPoints given_points(const Scene& whole) {
  ComplexPoints points(3, whole.point_count());
  for (int point = 0; point < whole.point_count(); ++point)
    points.col(point) = whole.fixed_point(point)->cast<std::complex<double>>();
  return points;
}

/// Combination `number` of the lines' solutions, the first line's running fastest.
Candidate combination(const ComplexPoints& points, const std::vector<std::vector<PlacedLine>>& lines,
                      std::size_t number) {
  Candidate candidate;
  candidate.error = 0;
  std::vector<ComplexLine> chosen;
  bool is_real = true;
  for (const std::vector<PlacedLine>& of_line : lines) {
    const PlacedLine& line = of_line[number % of_line.size()];
    number /= of_line.size();
    chosen.push_back(line.line);
    is_real = is_real && line.is_real;
    candidate.multiplicity *= line.multiplicity;
    candidate.error = std::max(candidate.error, line.error);
  }
  candidate.figure = figure_of(points, chosen, is_real);
  return candidate;
}

std::optional<Natural> generic_product(const std::vector<SolveReport>& reports) {
  Natural product(1);
  for (const SolveReport& report : reports) {
    if (!report.generic) return std::nullopt;
    product = product * Natural(*report.generic);
  }
  return product;
}

}  // namespace

std::vector<ProblemStatement> problems_of_lines(const ProblemStatement& problem) {
  std::vector<ProblemStatement> parts;
  if (!seeks_lines_alone(problem)) return parts;
  for (int line = 0; line < static_cast<int>(problem.lines.size()); ++line) {
    parts.push_back(problem_of_line(problem, line));
    if (parts.back().constraints.size() != 4) return {};
  }
  return parts;
}

SolveReport product_of_lines(const Scene& whole, const std::vector<Scene>& lines,
                             std::vector<SolveReport> reports, std::size_t most_listed) {
  SolveReport report;
  std::vector<std::vector<PlacedLine>> placed;
  Natural all(1), real(1);
  std::size_t listed = 1;
  bool is_empty = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    placed.push_back(placed_lines(whole, lines[i], reports[i]));
    const auto reals =
        std::ranges::count_if(placed.back(), [](const PlacedLine& line) { return line.is_real; });
    all = all * Natural(placed.back().size());
    real = real * Natural(static_cast<std::uint64_t>(reals));
    listed = std::min(most_listed, listed * placed.back().size());
    is_empty = is_empty || (placed.back().empty() && claims_all(reports[i].claim) &&
                            reports[i].status == SolveStatus::complete);
    if (!reports[i].reason.empty())
      report.reason +=
          (report.reason.empty() ? "" : "; ") + lines[i].problem().lines.front() + ": " + reports[i].reason;
    report.paths.insert(report.paths.end(), reports[i].paths.begin(), reports[i].paths.end());
    add(reports[i].work, report.work);
    add(reports[i].particulars, report.particulars);
  }
  report.status = common_status(reports, is_empty);
  report.claim = common_claim(reports);
  const ComplexPoints points = given_points(whole);
  for (std::size_t number = 0; number < listed; ++number)
    report.candidates.push_back(combination(points, placed, number));
  SolutionTotals& totals = report.totals.emplace();
  if (claims_all(report.claim)) totals.real = real;
  if (report.claim == Claim::all_complex) totals.complex = all;
  totals.generic = generic_product(reports);
  return report;
}

}  // namespace gcs
