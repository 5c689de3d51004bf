#include "solvers/scanning/scan_report.hpp"

#include <sstream>

#include "solvers/model/quality.hpp"
#include "solvers/options.hpp"

namespace gcs {
namespace {

/// More finest pieces than this are a curve of solutions and not the surroundings of a few multiple ones,
/// each of which takes about 1e-8 / finest in the direction in which it is multiple.
constexpr std::int64_t max_undecided = 200'000;

std::string in_words(const UndecidedPiece& piece) {
  std::ostringstream words;
  words.precision(15);
  for (std::size_t i = 0; i < piece.ranges.size(); ++i)
    words << (i == 0 ? "" : " x ") << "[" << piece.ranges[i][0] << ", " << piece.ranges[i][1] << "]";
  return words.str();
}

std::string what_is_missing(const ScanOutcome& outcome) {
  std::string reason;
  if (outcome.end == ScanOutcome::End::stopped) reason = "stopped on request";
  if (outcome.end == ScanOutcome::End::too_many_cells) reason = "more cells than max_cells allows";
  if (outcome.end == ScanOutcome::End::too_many_undecided)
    reason = "so many pieces are undecided that the solutions are unlikely to be isolated";
  if (outcome.undecided.empty()) return reason;
  if (!reason.empty()) reason += "; ";
  return reason + std::to_string(outcome.undecided.size()) +
         " of the finest pieces undecided, the first at angles (radians) " +
         in_words(outcome.undecided.front());
}

SolveStatus status_of(const ScanOutcome& outcome) {
  if (outcome.end == ScanOutcome::End::stopped) return SolveStatus::stopped;
  if (outcome.end != ScanOutcome::End::complete) return SolveStatus::gave_up;
  return outcome.undecided.empty() ? SolveStatus::complete : SolveStatus::partial;
}

}  // namespace

std::vector<OptionSpec> scan_option_specs() {
  return {{"finest", "1e-12", "number from 1e-14 to 1e-2",
           "half the width, in radians, below which a piece is named as undecided"},
          {"max_cells", "100000000", "whole number from 1 to 1e12", "cells after which the scan gives up"}};
}

ScanLimits read_scan_limits(const OptionMap& options) {
  return {number_option(options, "finest", 1e-14, 1e-2),
          integer_option(options, "max_cells", 1, 1'000'000'000'000), max_undecided};
}

SolveReport scan_report(const Scene& scene, const ScanPlan& plan, const ScanOutcome& outcome) {
  SolveReport report;
  report.claim = Claim::all_real;
  report.status = status_of(outcome);
  report.reason = what_is_missing(outcome);
  for (const Figure& figure : outcome.solutions) report.candidates.push_back({figure});
  for (const UndecidedPiece& piece : outcome.undecided)
    if (relative_residual(scene, piece.figure) <= double_root_residual)
      report.candidates.push_back({piece.figure});
  report.work.evaluations = outcome.cells;
  report.work.newton_iterations = outcome.newton_iterations;
  report.particulars = {{"driving_parameters", plan.angles()},
                        {"cells", outcome.cells},
                        {"boxes_tested", outcome.boxes},
                        {"undecided_pieces", static_cast<std::int64_t>(outcome.undecided.size())}};
  return report;
}

}  // namespace gcs
