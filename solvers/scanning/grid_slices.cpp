#include "solvers/scanning/grid_slices.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <sstream>
#include <utility>

#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

using ScanSlice = std::function<GridSlice(std::int64_t)>;

/// What is reported of a grid that is refused; nothing of any other.
std::optional<SolveReport> refused_grid(const GridScan& asked) {
  double points = 1;
  for (const AngleGrid& grid : asked.angles) points *= static_cast<double>(grid.count);
  if (points > 0 && points <= static_cast<double>(asked.max_points)) return std::nullopt;
  std::ostringstream reason;
  if (points == 0)
    reason << "the grid is empty: an angle's range ends before its first value";
  else
    reason << "the grid has " << points << " points, more than max_points allows; a wider step makes fewer";
  SolveReport report;
  report.claim = Claim::some_real;
  report.status = SolveStatus::gave_up;
  report.reason = reason.str();
  return report;
}

/// Takes slices in their order.
class SlicesInOrder {
 public:
  SlicesInOrder(const SolveRequest& request, const GridScan& asked, const RefinedSolutions& none)
      : request_(request), angles_(asked.angles), all_{none} {
    if (!angles_.empty()) slices_ = angles_.front().count;
  }

  void run(const ScanSlice& scan) {
    const auto threads = static_cast<int>(std::min<std::int64_t>(slices_, request_.threads));
    run_on_threads(std::max(1, threads), [&](int) {
      for (std::int64_t number = begun_++; number < slices_; number = begun_++) {
        if (request_.stop.stop_requested()) break;
        bring(number, scan(number));
      }
    });
  }

  const RefinedSolutions& refined() const { return all_.refined; }

  SolveReport report(std::vector<Candidate> candidates) const {
    SolveReport report;
    report.claim = Claim::some_real;
    report.status = SolveStatus::complete;
    if (request_.stop.stop_requested()) {
      report.status = SolveStatus::stopped;
      report.reason = "stopped on request";
    }
    report.work.evaluations = taken_;
    for (std::size_t i = 1; i < angles_.size(); ++i) report.work.evaluations *= angles_[i].count;
    report.work.newton_iterations = all_.newton_iterations;
    report.particulars = {{"driving_parameters", static_cast<std::int64_t>(angles_.size())},
                          {"coarse_solutions", all_.coarse},
                          {"coarse_without_solution", all_.diverged},
                          {"refined_solutions", static_cast<std::int64_t>(candidates.size())}};
    report.candidates = std::move(candidates);
    return report;
  }

 private:
  void bring(std::int64_t number, GridSlice slice) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(number, std::move(slice));
    for (auto next = waiting_.begin(); next != waiting_.end() && next->first == taken_;
         next = waiting_.erase(next), ++taken_)
      take(next->second);
    if (request_.monitor != nullptr)
      request_.monitor->progress("scanning", static_cast<double>(taken_) / static_cast<double>(slices_));
  }

  void take(const GridSlice& slice) {
    all_.coarse += slice.coarse;
    all_.diverged += slice.diverged;
    all_.newton_iterations += slice.newton_iterations;
    for (const Eigen::VectorXd& x : slice.refined.list()) all_.refined.take(x);
  }

  const SolveRequest& request_;
  const std::vector<AngleGrid>& angles_;
  std::int64_t slices_ = 1;
  std::atomic<std::int64_t> begun_{0};
  std::mutex mutex_;  ///< of all below
  std::map<std::int64_t, GridSlice> waiting_;
  std::int64_t taken_ = 0;
  GridSlice all_;
};

}  // namespace

double AngleGrid::at(std::int64_t i) const {
  return (first + static_cast<double>(i) * step) * std::numbers::pi / 180;
}

AngleGrid grid_over(const std::array<double, 2>& range, double start, double step) {
  constexpr double degree = std::numbers::pi / 180;
  const double width = (range[1] - range[0]) / degree - start;
  const double steps = std::ceil(width / step * (1 - 1e-12));
  return {range[0] / degree + start, step, static_cast<std::int64_t>(std::max(0.0, steps))};
}

SolveReport scan_slices(const SolveRequest& request, const GridScan& asked, const RefinedSolutions& none,
                        const ScanSlice& scan,
                        const std::function<std::vector<Candidate>(const RefinedSolutions&)>& candidates) {
  if (auto refused = refused_grid(asked)) return *std::move(refused);
  SlicesInOrder slices(request, asked, none);
  slices.run(scan);
  return slices.report(candidates(slices.refined()));
}

}  // namespace gcs
