#include "solvers/scanning/scan_report.hpp"

#include <algorithm>
#include <sstream>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/figures/residual_and_condition.hpp"

namespace gcs {
namespace {

/// More ranges than this nobody reads; the others are counted.
constexpr std::size_t most_named = 20;

/// One range for each angle, in radians.
using Ranges = std::vector<std::array<double, 2>>;

/// Whether the two meet, or nearly so: neighbours are rounded outwards or inwards.
bool touch(const Ranges& a, const Ranges& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double slack = std::max(a[i][1] - a[i][0], b[i][1] - b[i][0]);
    if (a[i][0] > b[i][1] + slack || b[i][0] > a[i][1] + slack) return false;
  }
  return true;
}

void widen(Ranges& hull, const Ranges& other) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    hull[i] = {std::min(hull[i][0], other[i][0]), std::max(hull[i][1], other[i][1])};
}

/// Pieces that touch as one. They come in the order of the scan, so that neighbours are close in it: only the
/// latest ranges are looked at, and hundreds of thousands of pieces take no time.
std::vector<Ranges> joined(const std::vector<UndecidedPiece>& pieces) {
  constexpr std::size_t latest = 100;
  std::vector<Ranges> hulls;
  for (const UndecidedPiece& piece : pieces) {
    const auto end = hulls.rbegin() + static_cast<std::ptrdiff_t>(std::min(hulls.size(), latest));
    const auto hull =
        std::find_if(hulls.rbegin(), end, [&](const Ranges& known) { return touch(known, piece.ranges); });
    if (hull == end)
      hulls.push_back(piece.ranges);
    else
      widen(*hull, piece.ranges);
  }
  return hulls;
}

std::string in_words(const std::vector<Ranges>& all) {
  std::ostringstream words;
  words.precision(15);
  for (std::size_t k = 0; k < std::min(all.size(), most_named); ++k) {
    words << (k == 0 ? "" : ", ");
    for (std::size_t i = 0; i < all[k].size(); ++i)
      words << (i == 0 ? "" : " x ") << "[" << all[k][i][0] << ", " << all[k][i][1] << "]";
  }
  if (all.size() > most_named) words << " and " << all.size() - most_named << " more";
  return words.str();
}

std::string what_is_missing(const ScanOutcome& outcome) {
  std::string reason;
  if (outcome.end == ScanOutcome::End::stopped) reason = "stopped on request";
  if (outcome.end == ScanOutcome::End::too_many_cells) {
    std::ostringstream words;
    words.precision(2);
    words << "more cells than max_cells allows, when a share of about " << outcome.share << " was decided";
    reason = words.str();
  }
  if (outcome.end == ScanOutcome::End::too_many_undecided)
    reason = "so many pieces are undecided that the solutions are unlikely to be isolated";
  if (outcome.undecided.empty()) return reason;
  if (!reason.empty()) reason += "; ";
  const std::string count = std::to_string(outcome.undecided.size());
  if (outcome.undecided.front().ranges.empty())
    return reason + count + " of the branches undecided: solutions there are multiple, or nearly so";
  return reason + count + " of the finest pieces undecided, at angles (radians) " +
         in_words(joined(outcome.undecided)) + ": solutions there are multiple, or nearly so";
}

SolveStatus status_of(const ScanOutcome& outcome) {
  if (outcome.end == ScanOutcome::End::stopped) return SolveStatus::stopped;
  if (outcome.end != ScanOutcome::End::complete) return SolveStatus::gave_up;
  return outcome.undecided.empty() ? SolveStatus::complete : SolveStatus::partial;
}

}  // namespace

SolveReport scan_report(const Scene& scene, std::size_t angles, const ScanOutcome& outcome) {
  SolveReport report;
  report.claim = Claim::all_real;
  report.status = status_of(outcome);
  report.reason = what_is_missing(outcome);
  for (const auto& [figure, multiplicity, error] : outcome.solutions) {
    report.candidates.push_back({figure, multiplicity});
    if (multiplicity == 1) report.candidates.back().error = error;
  }
  if (outcome.is_counted && report.status == SolveStatus::complete &&
      !are_different_classes(scene, report.candidates)) {
    report.status = SolveStatus::partial;
    report.reason = too_near;
  }
  for (const UndecidedPiece& piece : outcome.undecided)
    if (relative_residual(scene, piece.figure) <= double_root_residual)
      report.candidates.push_back({piece.figure});
  report.work.evaluations = outcome.cells;
  report.work.newton_iterations = outcome.newton_iterations;
  report.particulars = {{"driving_parameters", static_cast<std::int64_t>(angles)},
                        {"cells", outcome.cells},
                        {"boxes_tested", outcome.boxes},
                        {"undecided_pieces", static_cast<std::int64_t>(outcome.undecided.size())}};
  return report;
}

}  // namespace gcs
