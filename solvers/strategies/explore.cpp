/// Takes one value away after the other and walks along what is left.
///
/// Without one of its equations a scene that is rigid moves along a curve, which is closed where only distances hold it,
/// and each point at which the missing value fits again is a solution. Solutions are the nodes of a graph, the curves its
/// edges; they are walked from every solution that is found, for every value, each once. That two solutions of generic
/// values are joined by a chain of such curves is not known: where single values leave several components, another one
/// needs a start of its own, which random starts give (exploring/random_starts.hpp).
///
/// It starts from the solutions on S, or from that of Newton's method from the sketch, or from random starts. Curves are
/// followed by Taylor series (tracking/series_tracker.hpp on tracking/released_curve.hpp).
///
/// In mode=certified curves are followed by tubes too (proven_paths/certified_tracker.hpp): of each that closes it is proven
/// that it does, and how many crossings it has, in which order. Others are followed as in mode=fast, and not proven. Where all
/// curves from all solutions are, it claims all real solutions of this component: no other is joined to one of these by such
/// curves. There may be several components, of which a start is in each that is known.
///
/// Otherwise it claims some real solutions. Fails where none is found that is not singular, and is partial where a curve could not be
/// followed. A curve that crosses itself or another ends there, from both sides, and its record says so.
///
/// Of a gradient's components in the place of values: Diener, Trajectory nets connecting all critical points of a smooth
/// function, 1986.

#include "solvers/strategies/explore.hpp"

#include "solvers/exploring/exploration.hpp"

namespace gcs {
namespace {

class ExploreStrategy final : public Strategy {
 public:
  explicit ExploreStrategy(const Explore& asked) : limits_{asked.curves, asked.starts, asked.unseen} {
    walks_.proves = asked.mode == Explore::Mode::certified;
    walks_.tracking.order = asked.order;
    walks_.tracking.tolerance = asked.tolerance;
    walks_.tracking.max_steps = asked.max_steps;
    walks_.tracking.step_max_far = 0.1;
    walks_.tracking.kept_points = asked.samples;
  }

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    return why_not_explored(request.scene);
  }

  SolveReport solve(const SolveRequest& request) override {
    return Exploration(request, walks_, limits_).run();
  }

 private:
  ExplorationLimits limits_;
  WalkOptions walks_;
};

}  // namespace

StrategyEntry explore_entry() {
  StrategyEntry entry = entry_of<ExploreStrategy, Explore>();
  entry.summary = "walks from solution to solution along curves with one value released: some real solutions";
  entry.citation = "Diener 1986 (trajectory nets); Moré 1978 for random starts";
  entry.accuracy_settings = {{{"tolerance", "1e-9"}}};
  entry.knows_general_scenes = true;
  entry.keeps_journal = true;
  return entry;
}

}  // namespace gcs
