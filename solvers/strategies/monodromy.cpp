/// All complex solutions, from nothing but the constraint graph.
///
/// A random complex placement is a solution for its own lengths. Monodromy finds the other solutions for
/// these lengths (homotopies/monodromy_search.hpp), and one homotopy in the squared lengths leads from
/// them to the given lengths, where each path ends with a name: regular, singular, at infinity
/// (homotopies/endgame.hpp). Everything is done modulo reflections in the planes of the frame. The list
/// is complete when the search has met the theoretical count or bound (counting/theoretical_counts.hpp) and
/// every path has a decided end. Where no exact count is known, and every loop leads to known solutions before a
/// bound is met, a trace test decides (homotopies/trace_test.hpp): strong evidence that nothing is
/// missing, and no proof. Without it (trace=off) the report says that the list is as found.
///
/// It fails on scenes with several lines (homotopies/complex_strategy.hpp). The solutions for random
/// lengths are found in prepare, since they serve all lengths. They can be kept (save_start) and read in the
/// place of a search (start); what is read is as complete as the search was that found it. Duff, Hill,
/// Jensen, Lee, Leykin, Sommars, Solving polynomial systems via homotopy continuation and monodromy, IMA J.
/// Numer. Anal. 39 (2019).

#include "solvers/strategies/monodromy.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "solvers/homotopies/complex_strategy.hpp"
#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/general_trace.hpp"
#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/homotopies/start_store.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

bool agrees(const TraceTest& trace, const GenericSolutions& generic) {
  return trace.passed() && trace.solutions == static_cast<std::int64_t>(generic.solutions.size());
}

/// `verb`: how they came about.
std::string why_not_all(const GenericSolutions& generic, const std::optional<TraceTest>& trace,
                        const std::string& verb) {
  const std::string found =
      verb + " " + std::to_string(generic.solutions.size()) + " classes at random lengths";
  if (generic.end == SearchEnd::stopped) return "stopped: " + found;
  if (generic.end == SearchEnd::inconsistent)
    return found + ", which contradict each other: a step has jumped";
  if (generic.end == SearchEnd::complete || (trace && agrees(*trace, generic))) return "";
  if (trace && trace->end == SearchEnd::stopped) return "stopped in the trace test: " + found;
  if (!trace) return found + ", and every loop leads back to them; whether these are all was not tested";
  if (!trace->passed()) return found + ", and the trace test did not succeed in showing that these are all";
  return found + ", where the trace test finds " + std::to_string(trace->solutions);
}

std::optional<std::uint64_t> classes_of(const std::optional<ClassCount>& count, int images = 1) {
  return count ? std::optional(count->classes * static_cast<std::uint64_t>(images)) : std::nullopt;
}

/// How the search for a list ended that was read: a count decides now as it would have done then.
SearchEnd end_of_stored(const GenericSolutions& generic, const std::optional<ClassCount>& count) {
  if (count && generic.solutions.size() == count->classes) return SearchEnd::complete;
  if (count && generic.solutions.size() > count->classes) return SearchEnd::inconsistent;
  return generic.end == SearchEnd::complete ? SearchEnd::quiet : generic.end;
}

void add_particulars(const StartSystem& found, std::vector<Particular>& particulars) {
  particulars.push_back({"loop_paths", found.generic.legs});
  particulars.push_back({"lost_loop_paths", found.generic.lost_legs});
  particulars.push_back({"arcs", found.generic.arcs_used});
  if (!found.trace) return;
  particulars.push_back({"trace_points", found.trace->points});
  particulars.push_back({"trace_solutions", found.trace->solutions});
}

/// What all lengths of one scene's graph share.
class Found final : public GenericStart {
 public:
  Found(const SolveRequest& request, const TrackingSetup& setup)
      : GenericStart(request.scene, request.seed, setup), axes(mirror_axes(request.scene, coordinates)) {}

  const ComplexVectorX& squares() const override { return generic.squares; }
  const std::vector<ComplexVectorX>& solutions() const override { return generic.solutions; }
  HomotopyFamily family() const { return all_lengths(system, axes); }
  StartFamily lengths() const { return start_family(system, axes); }
  bool is_stopped() const override { return generic.end == SearchEnd::stopped; }
  std::string missing() const override {
    if (generic.end == SearchEnd::quiet && limit && limit->is_exact)
      return verb() + " " + std::to_string(generic.solutions.size()) + " of " +
             std::to_string(limit->classes) + " classes at random lengths, to which every loop leads back";
    return why_not_all(generic, trace, verb());
  }
  std::string verb() const { return is_stored ? "the stored start has" : "found"; }
  std::vector<Particular> particulars() const override {
    std::vector<Particular> counts;
    if (is_stored)
      counts.push_back({"stored_solutions", static_cast<std::int64_t>(generic.solutions.size())});
    add_particulars({generic, trace}, counts);
    return counts;
  }

  std::optional<ClassCount> limit;
  std::vector<int> axes;
  GenericSolutions generic;
  std::optional<TraceTest> trace;  ///< where the limit was not met
  bool is_stored = false;          ///< the two above come from an earlier search
};

class MonodromyStrategy final : public ComplexStrategy {
 public:
  /// Throws OptionError for a start system to read and one to write.
  explicit MonodromyStrategy(const Monodromy& asked)
      : ComplexStrategy(asked.tracking),
        with_trace_(asked.trace),
        start_(asked.start),
        save_start_(asked.save_start) {
    search_.arcs = asked.arcs;
    if (start_ && save_start_)
      throw OptionError("options start=" + *start_ + " and save_start=" + *save_start_ +
                        ": give one of them; what is read is not written again");
  }

 private:
  std::unique_ptr<GenericStart> solve_at_random_lengths(const SolveRequest& request,
                                                        const ClassLimit& limit) const override {
    require_store(request);
    auto found = std::make_unique<Found>(request, setup_for(request));
    if (start_) {
      read(request, limit, *found);
      return found;
    }
    if (save_start_) request.starts->reserve(*save_start_);
    found->limit = limit();
    search(request, *found);
    if (save_start_ && !request.stop.stop_requested())
      request.starts->write(*save_start_, found->lengths(), {found->generic, found->trace});
    return found;
  }

  std::optional<std::string> why_no_general_scenes() const override { return std::nullopt; }

  void solve_random_member(const SolveRequest& request, const ClassLimit& limit,
                           GeneralStart& start) const override {
    require_store(request);
    if (save_start_) request.starts->reserve(*save_start_);
    const std::optional<ClassCount> most = limit();
    StartSystem found = start_ ? request.starts->read(*start_, start_family(start.equations))
                               : search_member(request, most, start);
    if (start_) {
      found.generic.end = end_of_stored(found.generic, most);
      found.generic.squares = with_values(start.equations, found.generic.squares);
      start.particulars.push_back({"stored_solutions", std::ssize(found.generic.solutions)});
    }
    start.missing = why_not_all(found.generic, found.trace, start_ ? "the stored start has" : "found");
    start.is_stopped = found.generic.end == SearchEnd::stopped || request.stop.stop_requested();
    add_particulars(found, start.particulars);
    start.parameters = found.generic.squares;
    start.solutions = found.generic.solutions;
    if (!save_start_ || start.is_stopped) return;
    found.generic.squares = values_of(start.equations, start.parameters);
    request.starts->write(*save_start_, start_family(start.equations), found);
  }

  /// Values have no common factor to turn by, which leaves the mixing to the arcs' bends and number: with two large ones
  /// random platforms are found along a third of the paths. Where the trace test says that some are missing, more arcs are
  /// tried, which go further out: a point that is 1/δ away has its branch points some 1/δ² away.
  StartSystem search_member(const SolveRequest& request, const std::optional<ClassCount>& most,
                            GeneralStart& start) const {
    const auto stopped = [&] { return request.stop.stop_requested(); };
    const auto progress = [&](const char* stage) {
      return [&request, stage](int) { report_progress(request, stage, -1); };
    };
    MonodromyOptions search = search_;
    search.bend = 16;
    search.has_two_bends = true;
    StartSystem found;
    bool is_done = false;
    for (int i = 0; i < most_trace_tests && !is_done && !stopped(); ++i) {
      search.arcs *= 2;
      if (i > 0) search.bend *= 4;
      if (!found.trace || found.trace->solutions != std::ssize(found.generic.solutions))
        found.generic =
            search_by_monodromy(start.family, start.tracking, {classes_of(most), nullptr}, search,
                                start.random, stopped, progress("solutions at random values"), start.work);
      if (with_trace_ && found.generic.end != SearchEnd::complete)
        found.trace = test_trace(start.equations, setup_for(request), search, start.random, stopped,
                                 progress("points for the trace test"), start.work);
      is_done = !with_trace_ || why_not_all(found.generic, found.trace, "").empty();
    }
    if (!is_done && most && !stopped())
      search_coefficients(request, *classes_of(most), search, start, found.generic);
    return found;
  }

  /// Next to special shapes of bodies solutions are so far away that no loop of values comes near them. Among all
  /// coefficients the shapes are special, too, but random ones are not: from their zeros paths lead to all of the shapes'.
  static void search_coefficients(const SolveRequest& request, std::uint64_t most,
                                  const MonodromyOptions& options, GeneralStart& start,
                                  GenericSolutions& found) {
    const auto stopped = [&] { return request.stop.stop_requested(); };
    const GenericSolutions zeros = search_by_monodromy(
        family_of_coefficients(start.equations), start.tracking, {std::nullopt, nullptr}, options,
        start.random, stopped, [&](int) { report_progress(request, "solutions at random coefficients", -1); },
        start.work);
    const std::vector<PathEnd> ends = follow_to_end(
        start.tracking, zeros.solutions, zeros.squares, found.squares,
        [&](const ComplexVectorX& x) { return is_zero_at(start.equations.system, found.squares, x); },
        stopped, [&](double fraction) { report_progress(request, "paths to random values", fraction); },
        start.work);
    SolutionSet classes(start.equations.signs, start.random);
    for (const ComplexVectorX& x : found.solutions) classes.insert(x, regular_uncertainty);
    for (const PathEnd& end : ends)
      if (end.kind == PathEnd::Kind::regular) classes.insert(end.x, regular_uncertainty);
    found.solutions = classes.solutions();
    found.legs += zeros.legs;
    found.lost_legs += zeros.lost_legs;
    found.arcs_used += zeros.arcs_used;
    if (found.solutions.size() == most) found.end = SearchEnd::complete;
    if (found.solutions.size() > most) found.end = SearchEnd::inconsistent;
  }

  /// For start systems, where options name them.
  void require_store(const SolveRequest& request) const {
    if ((start_ || save_start_) && !request.starts)
      throw OptionError("options start and save_start: nothing keeps start systems here");
  }

  void read(const SolveRequest& request, const ClassLimit& limit, Found& found) const {
    StartSystem start;
    const int threads = std::min(2, request.threads);
    // What may throw comes first: that is the thread of the caller.
    run_on_threads(threads, [&](int part) {
      if (part == 0) start = request.starts->read(*start_, found.lengths());
      if (part == threads - 1) found.limit = limit();
    });
    start.generic.end = end_of_stored(start.generic, found.limit);
    found.generic = std::move(start.generic);
    found.trace = start.trace;
    found.is_stored = true;
  }

  void search(const SolveRequest& request, Found& found) const {
    const auto stopped = [&] { return request.stop.stop_requested(); };
    const int images = follows_mirror_images() ? image_count(found.axes) : 1;
    const double most = found.limit ? static_cast<double>(*classes_of(found.limit, images)) : 0;
    const auto progress = [&](int count) {
      report_progress(request, "solutions at random lengths", most > 0 ? count / most : -1);
    };
    MonodromyOptions options = search_;
    const auto search_in = [&](const HomotopyFamily& family, const std::optional<std::uint64_t>& all) {
      return search_by_monodromy(family, found.tracking, {all, nullptr}, options, found.random, stopped,
                                 progress, found.work);
    };
    const auto all_found = [&] {
      if (!follows_mirror_images()) return search_in(found.family(), classes_of(found.limit));
      const auto all = classes_of(found.limit, images);
      GenericSolutions generic = search_in(all_lengths(found.system, divided_by_none(found.axes)), all);
      generic.solutions = one_of_each_class(generic.solutions, found.axes, found.random);
      return generic;
    };
    found.generic = all_found();
    for (int i = 0; with_trace_ && i < most_trace_tests && !found.missing().empty() && !stopped(); ++i) {
      // Where so many are missing, no test needs to say it.
      if (!found.limit || !found.limit->is_exact) found.trace = test(request, found);
      options.arcs *= 2;
      if (!found.missing().empty() && !stopped()) found.generic = all_found();
    }
  }

  /// Its parameters have no common factor either: bends as above, tried on five points with a line, find along half the
  /// paths what one of 8 does, and miss a few points in one test of sixty where that did in one of six.
  TraceTest test(const SolveRequest& request, Found& found) const {
    MonodromyOptions options;
    options.bend = 32;
    options.has_two_bends = true;
    options.arcs = 2 * search_.arcs;
    return test_trace(
        found.system, found.axes, setup_for(request), options, found.random,
        [&] { return request.stop.stop_requested(); },
        [&](int) { report_progress(request, "points for the trace test", -1); }, found.work);
  }

  /// A test may fail for want of arcs or by rounding, and another random one does not; so may a search.
  static constexpr int most_trace_tests = 3;

  bool with_trace_;
  std::optional<std::string> start_;       ///< the start system to read
  std::optional<std::string> save_start_;  ///< or where to keep the one found
  MonodromyOptions search_;
};

}  // namespace

StrategyEntry monodromy_entry() {
  StrategyEntry entry = entry_of<MonodromyStrategy, Monodromy>();
  entry.summary = "finds all complex solutions at random lengths by loops and follows them to the given ones";
  entry.citation = "Duff, Hill, Jensen, Lee, Leykin, Sommars 2019";
  entry.accuracy_settings = tracking_accuracy_settings();
  entry.keeps_journal = true;
  entry.knows_general_scenes = true;
  return entry;
}

}  // namespace gcs
