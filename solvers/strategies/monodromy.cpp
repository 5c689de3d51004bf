/// All complex solutions, from nothing but the constraint graph.
///
/// A random complex placement is a solution for its own lengths. Monodromy finds the other solutions for
/// these lengths (complex_tracking/monodromy_search.hpp), and one homotopy in the squared lengths leads from
/// them to the given lengths, where each path ends with a name: regular, singular, at infinity
/// (complex_tracking/endgame.hpp). Everything is done modulo reflections in the planes of the frame. The list
/// is complete when the search has met the theoretical count or bound (counting/theoretical_counts.hpp) and
/// every path has a decided end. Where no count is known, or every loop leads to known solutions before the
/// bound is met, a trace test decides (complex_tracking/trace_test.hpp): strong evidence that nothing is
/// missing, and no proof. Without it (trace=off) the report says that the list is as found.
///
/// Where positions are given beside a line the scene is restated without (model/released_scene.hpp), and the
/// solutions are carried back. It fails on scenes with several lines. The solutions for random
/// lengths are found in prepare, since they serve all lengths. They can be kept (save_start) and read in the
/// place of a search (start); what is read is as complete as the search was that found it. Duff, Hill,
/// Jensen, Lee, Leykin, Sommars, Solving polynomial systems via homotopy continuation and monodromy, IMA J.
/// Numer. Anal. 39 (2019).

#include <limits>
#include <memory>
#include <stdexcept>

#include "solvers/complex_tracking/complex_report.hpp"
#include "solvers/complex_tracking/monodromy_search.hpp"
#include "solvers/complex_tracking/released_report.hpp"
#include "solvers/complex_tracking/start_store.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/options.hpp"

namespace gcs {
namespace {

constexpr std::string_view instruction_sets = "auto|portable|avx2|avx512";

InstructionSet read_instruction_set(const OptionMap& options) {
  const int choice = choice_option(options, "instructions", instruction_sets);
  if (choice == 0) return widest_instruction_set();
  const auto set = static_cast<InstructionSet>(choice - 1);
  if (!is_available(set))
    throw OptionError("option instructions=" + options.find("instructions")->second +
                      ": this machine does not have them; auto takes the widest that it has");
  return set;
}

/// The number of classes at generic lengths, or at most so many; nothing where nobody knows, or where no list
/// could be that long.
std::optional<std::uint64_t> most_classes(const Scene& scene) {
  const TheoreticalCounts counts = theoretical_counts(scene.problem());
  const SolutionCount* limit = counts.upper_limit();
  if (!limit) return std::nullopt;
  const Natural classes = limit->up_to_reflection();
  if (classes > Natural(std::numeric_limits<std::uint32_t>::max())) return std::nullopt;
  return static_cast<std::uint64_t>(classes.approximate());
}

/// The squared lengths that the file gives.
ComplexVectorX given_squares(const Scene& scene) {
  ComplexVectorX squares;
  for (const DoubleDouble& square : target_squares(scene)) squares.push_back(square.value());
  return squares;
}

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

/// How the search for a list ended that was read: a count decides now as it would have done then.
SearchEnd end_of_stored(const GenericSolutions& generic, const std::optional<std::uint64_t>& count) {
  if (count && generic.solutions.size() == *count) return SearchEnd::complete;
  if (count && generic.solutions.size() > *count) return SearchEnd::inconsistent;
  return generic.end == SearchEnd::complete ? SearchEnd::quiet : generic.end;
}

/// What all lengths of one scene's graph share. Heap-allocated, since trackers refer to the system.
struct Prepared {
  explicit Prepared(const SolveRequest& request, const TrackingOptions& options, InstructionSet set)
      : random(request.seed),
        coordinates(request.scene),
        system(square_system(coordinates)),
        elimination(order_elimination(system, random)),
        tracking(system, elimination, {options, set, request.threads, request.journal}),
        limit(most_classes(request.scene)) {}

  std::mt19937_64 random;
  DistanceSystem coordinates;
  SquareSystem system;
  Elimination elimination;
  LegTracking tracking;
  std::optional<std::uint64_t> limit;
  GenericSolutions generic;
  std::optional<TraceTest> trace;  ///< where the limit was not met
  bool is_stored = false;          ///< the two above come from an earlier search
  WorkCounters work;
};

class Monodromy final : public Strategy {
 public:
  explicit Monodromy(const OptionMap& options)
      : with_trace_(choice_option(options, "trace", "on|off") == 0),
        instruction_set_(read_instruction_set(options)) {
    tracking_.order = static_cast<int>(integer_option(options, "order", 4, 40));
    tracking_.tolerance = number_option(options, "tolerance", 1e-12, 1e-3);
    search_.arcs = static_cast<int>(integer_option(options, "arcs", 2, 1000));
    start_ = file_option(options, "start");
    save_start_ = file_option(options, "save_start");
    if (start_ && save_start_)
      throw OptionError("options start=" + *start_ + " and save_start=" + *save_start_ +
                        ": give one of them; what is read is not written again");
  }

  std::optional<std::string> why_unsupported(const Scene& scene) const override {
    if (scene.problem().lines.size() > 1) return "it places one line at most";
    if (is_released(scene)) return why_not_released(scene);
    if (scene.has_lines() && scene.reference().line < 0)
      return "it puts the line on the x-axis, which a reference of points does not allow";
    return std::nullopt;
  }

  void prepare(const SolveRequest& request) override {
    if (!is_released(request.scene)) {
      prepared_ = read_or_search(request);
      return;
    }
    const ReleasedScene released(request.scene);
    prepared_ = read_or_search(request_on(released.scene(), request));
  }

  SolveReport solve(const SolveRequest& request) override {
    if (!is_released(request.scene)) return solve_free(request);
    const ReleasedScene released(request.scene);
    return carried_back(released, request.scene, solve_free(request_on(released.scene(), request)));
  }

 private:
  static bool is_released(const Scene& scene) { return scene.has_lines() && scene.is_anchored(); }

  static SolveRequest request_on(const Scene& scene, const SolveRequest& request) {
    return {scene, request.seed, request.threads, request.stop, request.monitor, request.journal, request.starts};
  }

  /// What was prepared serves the same equations: which ones a restated scene has depends on the positions.
  bool is_prepared_for(const Scene& scene) const {
    return prepared_ && prepared_->coordinates.edges() == DistanceSystem(scene).edges();
  }

  SolveReport solve_free(const SolveRequest& request) const {
    const std::unique_ptr<Prepared> fresh = is_prepared_for(request.scene) ? nullptr : read_or_search(request);
    Prepared& prepared = fresh ? *fresh : *prepared_;
    const auto stopped = [&] { return request.stop.stop_requested(); };
    WorkCounters work = prepared.work;
    std::mt19937_64 random(request.seed);
    const std::vector<PathEnd> ends = follow_to_end(
        prepared.tracking, prepared.generic.solutions, prepared.generic.squares, given_squares(request.scene),
        stopped, [&](double fraction) { Monodromy::report(request, "paths to the given lengths", fraction); },
        work);
    SolveReport report = complex_report(request.scene, prepared.coordinates, ends, work, random);
    add_search(prepared, report);
    return report;
  }

  std::unique_ptr<Prepared> read_or_search(const SolveRequest& request) const {
    if ((start_ || save_start_) && !request.starts)
      throw std::invalid_argument("start systems cannot be kept here");
    if (start_) return read(request);
    if (save_start_) request.starts->reserve(*save_start_);
    std::unique_ptr<Prepared> prepared = search(request);
    if (save_start_ && !request.stop.stop_requested())
      request.starts->write(*save_start_, family(request, *prepared), {prepared->generic, prepared->trace});
    return prepared;
  }

  static Family family(const SolveRequest& request, const Prepared& prepared) {
    return all_lengths(prepared.system, mirror_axes(request.scene, prepared.coordinates));
  }

  std::unique_ptr<Prepared> read(const SolveRequest& request) const {
    auto prepared = std::make_unique<Prepared>(request, tracking_, instruction_set_);
    StartSystem start = request.starts->read(*start_, family(request, *prepared));
    start.generic.end = end_of_stored(start.generic, prepared->limit);
    prepared->generic = std::move(start.generic);
    prepared->trace = start.trace;
    prepared->is_stored = true;
    return prepared;
  }

  std::unique_ptr<Prepared> search(const SolveRequest& request) const {
    auto prepared = std::make_unique<Prepared>(request, tracking_, instruction_set_);
    const std::vector<int> axes = mirror_axes(request.scene, prepared->coordinates);
    const auto stopped = [&] { return request.stop.stop_requested(); };
    const double most = prepared->limit ? static_cast<double>(*prepared->limit) : 0;
    prepared->generic = search_by_monodromy(
        all_lengths(prepared->system, axes), prepared->tracking, {prepared->limit, nullptr}, search_,
        prepared->random, stopped,
        [&](int found) { report(request, "solutions at random lengths", most > 0 ? found / most : -1); },
        prepared->work);
    for (int i = 0; with_trace_ && i < most_trace_tests && !why_not_all(*prepared).empty(); ++i)
      prepared->trace = test(request, *prepared, axes);
    return prepared;
  }

  TraceTest test(const SolveRequest& request, Prepared& prepared, const std::vector<int>& axes) const {
    MonodromyOptions options;
    options.bend = trace_bend;
    options.arcs = 2 * search_.arcs;
    return test_trace(
        prepared.system, axes, tracking_, instruction_set_, request.threads, request.journal, options,
        prepared.random, [&] { return request.stop.stop_requested(); },
        [&](int) { report(request, "points for the trace test", -1); }, prepared.work);
  }

  static std::string why_not_all(const Prepared& prepared) {
    return gcs::why_not_all(prepared.generic, prepared.trace,
                            prepared.is_stored ? "the stored start has" : "found");
  }

  static void report(const SolveRequest& request, std::string_view stage, double fraction) {
    if (request.monitor) request.monitor->progress(stage, fraction);
  }

  static void add_search(const Prepared& prepared, SolveReport& report) {
    const GenericSolutions& generic = prepared.generic;
    if (prepared.is_stored)
      report.particulars.push_back({"stored_solutions", static_cast<std::int64_t>(generic.solutions.size())});
    report.particulars.push_back({"loop_paths", generic.legs});
    report.particulars.push_back({"lost_loop_paths", generic.lost_legs});
    report.particulars.push_back({"arcs", generic.arcs_used});
    if (prepared.trace) {
      report.particulars.push_back({"trace_points", prepared.trace->points});
      report.particulars.push_back({"trace_solutions", prepared.trace->solutions});
    }
    const std::string missing = why_not_all(prepared);
    if (missing.empty()) {
      report.generic = generic.solutions.size();
      return;
    }
    report.reason = missing + (report.reason.empty() ? "" : "; " + report.reason);
    if (report.status != SolveStatus::stopped)
      report.status = generic.end == SearchEnd::stopped ? SolveStatus::stopped : SolveStatus::partial;
  }

  /// A test may fail for want of arcs or by rounding, and another random one does not.
  static constexpr int most_trace_tests = 3;
  /// Its parameters have no common factor to turn by, which leaves the mixing to the arcs' bends.
  static constexpr double trace_bend = 8;

  bool with_trace_;
  std::optional<std::string> start_;       ///< the start system to read
  std::optional<std::string> save_start_;  ///< or where to keep the one found
  InstructionSet instruction_set_;
  TrackingOptions tracking_;
  MonodromyOptions search_;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace

StrategyEntry monodromy_entry() {
  StrategyEntry entry;
  entry.name = "monodromy";
  entry.summary = "finds all complex solutions at random lengths by loops and follows them to the given ones";
  entry.citation = "Duff, Hill, Jensen, Lee, Leykin, Sommars 2019";
  entry.options = {
      {"order", "14", "whole number from 4 to 40", "of the Taylor predictor"},
      {"tolerance", "1e-6", "number from 1e-12 to 1e-3",
       "error of a prediction, relative to how far the path goes until its series diverges"},
      {"arcs", "12", "whole number from 2 to 1000", "ways between the two sets of random lengths, at most"},
      {"trace", "on", "on|off", "test completeness by a trace where no count is met"},
      {"start", "none", "FILE, or none", "start with the solutions at random lengths that save_start wrote"},
      {"save_start", "none", "FILE, or none",
       "write the solutions at random lengths, for this graph with any lengths", false, false},
      {"instructions", "auto", instruction_sets, "SIMD instructions; the result does not depend on them",
       false, false}};
  entry.keeps_journal = true;
  entry.make = [](const OptionMap& options) -> std::unique_ptr<Strategy> {
    return std::make_unique<Monodromy>(options);
  };
  return entry;
}

}  // namespace gcs
