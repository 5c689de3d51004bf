/// Newton's method, damped, from many random starts: the baseline that every other strategy has to beat.
///
/// A start is followed to a solution or a local minimum as exploring/random_starts.hpp says.
///
/// Nothing tells how many solutions there are. But from how often the ends are of one class follows an estimate of how many
/// are unseen (exploring/unseen_classes.hpp), and no more starts are made when that is below `unseen`. It is an estimate and
/// proves nothing: a solution in whose basin hardly a start lies is missed, however small it is. What an orientation leaves
/// out is counted among the classes.
///
/// Hence it claims some real solutions. It fails, and says so, where no start ends at a solution, which does
/// not prove that there is none, and at multiple solutions and scenes that move, whose ends it counts only. Simple solutions
/// next to a fold are proven.

#include "solvers/strategies/newton_multistart.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/exploring/explored_scene.hpp"
#include "solvers/exploring/random_starts.hpp"
#include "solvers/exploring/unseen_classes.hpp"

namespace gcs {
namespace {

/// Starts between two looks at `unseen`: no fewer are made, and their number does not depend on the threads.
constexpr int batch = 64;

class NewtonMultistartStrategy final : public Strategy {
 public:
  explicit NewtonMultistartStrategy(const NewtonMultistart& asked)
      : most_starts_(asked.starts), unseen_(asked.unseen) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    return why_not_explored(request.scene);
  }

  SolveReport solve(const SolveRequest& request) override {
    Tally tally;
    ProvenNeighbours neighbours(request.scene);
    int started = 0;
    do {
      if (request.monitor != nullptr)
        request.monitor->progress("random starts", static_cast<double>(started) / most_starts_);
      const int next = std::min(started + batch, most_starts_);
      for (StartEnd& end : ends_of_starts(request, started, next, neighbours)) tally.take(std::move(end));
      tally.classes = solution_classes(request.scene, tally.figures, tally.accuracies);
      started = next;
    } while (started < most_starts_ && !request.stop.stop_requested() && tally.expects(unseen_));
    return report(request, started, tally);
  }

 private:
  /// The ends at solutions so far, and their classes.
  struct Tally {
    std::vector<Figure> figures;
    std::vector<SolutionAccuracy> accuracies;
    ReflectionClasses classes;
    int singular = 0;  ///< ends
    WorkCounters work;

    void take(StartEnd end) {
      add(end.work, work);
      singular += end.is_singular ? 1 : 0;
      if (!end.is_solution) return;
      figures.push_back(std::move(end.figure));
      accuracies.push_back(end.accuracy);
    }

    std::optional<double> unseen() const { return unseen_classes(std::ssize(figures), classes.count()); }
    bool expects(double more) const { return !unseen() || *unseen() >= more; }
  };

  static SolveReport report(const SolveRequest& request, int started, const Tally& tally) {
    SolveReport report;
    report.claim = Claim::some_real;
    for (const int first : tally.classes.first) {
      const auto i = static_cast<std::size_t>(first);
      report.candidates.push_back({tally.figures[i], 1, tally.accuracies[i].error});
    }
    report.work = tally.work;
    report.particulars = {{"starts", started},
                          {"ends_at_solutions", static_cast<std::int64_t>(tally.figures.size())},
                          {"singular_ends", tally.singular}};
    if (const auto unseen = tally.unseen()) {
      Particular& estimate = report.particulars.emplace_back();
      estimate.name = "estimated_unseen_classes";
      estimate.value = std::llround(*unseen);
    }
    const std::string of_all = " of " + std::to_string(started) + " random starts ";
    if (request.stop.stop_requested()) {
      report.status = SolveStatus::stopped;
      report.reason = "stopped on request";
    } else if (tally.singular > static_cast<int>(tally.figures.size())) {  // fewer are accidents
      report.status = report.candidates.empty() ? SolveStatus::gave_up : SolveStatus::partial;
      report.reason =
          std::to_string(tally.singular) + of_all +
          "end where the Jacobian is singular: at solutions that are multiple or not isolated, or "
          "near none";
    } else if (report.candidates.empty()) {
      report.status = SolveStatus::gave_up;
      report.reason = "none" + of_all + "ends at a solution";
    } else {
      report.status = SolveStatus::complete;
    }
    return report;
  }

  int most_starts_;
  double unseen_;
};

}  // namespace

StrategyEntry newton_multistart_entry() {
  StrategyEntry entry = entry_of<NewtonMultistartStrategy, NewtonMultistart>();
  entry.summary = "Levenberg-Marquardt from random starts: some real solutions, the baseline";
  entry.citation = "Moré 1978; Boender, Rinnooy Kan 1987 for when to stop";
  entry.accuracy_settings = {{{"starts", "64"}}};
  entry.knows_general_scenes = true;
  return entry;
}

}  // namespace gcs
