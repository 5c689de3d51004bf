#include "solvers/solving/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "solvers/answers/certify.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/counting/scene_analysis.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/solving/unoriented_scene.hpp"

namespace gcs {
namespace {

std::optional<std::string> why_not_as_it_is(const StrategyEntry& entry, const Strategy& strategy,
                                            const SolveRequest& request) {
  if (auto reason = strategy.why_unsupported(request)) return reason;
  if (entry.needs_sketch && !request.scene.sketch())
    return "it starts at a sketch, and the instance gives none";
  return std::nullopt;
}

/// How a strategy can do a scene, if it can.
struct Suitability {
  std::optional<std::string> why_not;
  std::optional<Scene> unoriented;  ///< in the place of the scene, where that is not what it can do
};

Suitability suitability(const StrategyEntry& entry, const Strategy& strategy, const SolveRequest& request) {
  Suitability found{why_not_as_it_is(entry, strategy, request), {}};
  if (!found.why_not) return found;
  found.unoriented = unoriented(request.scene);
  if (found.unoriented && !why_not_as_it_is(entry, strategy, request.on(*found.unoriented)))
    found.why_not.reset();
  return found;
}

/// Hands progress on to a function.
class ProgressCall final : public Monitor {
 public:
  explicit ProgressCall(const std::function<void(std::string_view, double)>& call) : call_(call) {}
  void progress(std::string_view stage, double fraction) override { call_(stage, fraction); }

 private:
  const std::function<void(std::string_view, double)>& call_;
};

/// Of complex solutions where these are counted, else of real ones.
const std::optional<Natural>& largest_total(const SolutionTotals& totals) {
  return totals.complex ? totals.complex : totals.real;
}

/// Of so many candidates what a strategy leaves behind is worth the look through all that was freed.
constexpr std::size_t many = 4096;

/// glibc keeps what was freed in small pieces, of which larger ones cannot be made.
void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

class Solve {
 public:
  Solve(const Scene& scene, const SolveSettings& settings, const SolveSurroundings& surroundings)
      : scene_(scene),
        settings_(settings),
        analysis_(scene.problem()),
        surroundings_(surroundings),
        progress_(surroundings.progress),
        monitor_(surroundings.progress ? &progress_ : nullptr) {}

  Answer run(const StrategyEntry& entry, const OptionMap& given) {
    require_allowed();
    answer_.strategy = entry.name;
    answer_.options = complete_options(entry, given);
    answer_.seed = settings_.seed;
    answer_.threads = settings_.threads;
    auto strategy = entry.make(answer_.options);
    const SolveRequest request = asked();
    Suitability suitable = suitability(entry, *strategy, request);
    if (suitable.why_not) {
      answer_.status = RunStatus::unsupported;
      answer_.reason = *std::move(suitable.why_not);
      return std::move(answer_);
    }
    const std::optional<Scene>& plain = suitable.unoriented;
    SolveReport report = ask(*strategy, plain ? request.on(*plain) : request);
    if (plain) report = with_mirror_images(std::move(report), *plain, scene_);
    strategy.reset();  // with what it prepared, which may be as large as its report
    if (!settings_.certify) report.generic_member.reset();  // likewise
    if (report.candidates.size() >= many) return_freed_memory();
    enter(SolveStage::assessing);
    const std::optional<GenericMember> generic = std::move(report.generic_member);
    const std::size_t candidates = report.candidates.size();
    take(std::move(report));
    if (settings_.checks_counts || settings_.certify) hold_against_counts(generic);
    enter(SolveStage::listing);
    list(candidates);
    if (settings_.digits > 0) refine();
    enter(SolveStage::done);
    return std::move(answer_);
  }

 private:
  void require_allowed() const {
    if (settings_.threads < 1)
      throw OptionError(fmt::format("threads={}: needs a whole number of at least 1", settings_.threads));
    if (settings_.digits < 0)
      throw OptionError(fmt::format("digits={}: needs a whole number of at least 0", settings_.digits));
  }

  void enter(SolveStage stage) const {
    if (surroundings_.entered) surroundings_.entered(stage);
  }

  bool is_stopped() const { return surroundings_.stop.stop_requested(); }

  SolveRequest asked() const {
    return {scene_,
            {.seed = settings_.seed,
             .threads = settings_.threads,
             .stop = surroundings_.stop,
             .monitor = monitor_,
             .journal = surroundings_.journal,
             .crew = surroundings_.crew,
             .starts = surroundings_.starts,
             .most_listed = settings_.max_solutions},
            &analysis_};
  }

  /// A strategy that throws has a defect, or the machine has no memory left; neither may end a series of solves.
  /// What is wrong with the user's files and options does.
  SolveReport ask(Strategy& strategy, const SolveRequest& request) {
    try {
      enter(SolveStage::preparing);
      strategy.prepare(request);
      enter(SolveStage::solving);
      return strategy.solve(request);
    } catch (const UserError&) {
      throw;
    } catch (const std::bad_alloc&) {
      SolveReport report;
      report.reason = "there is not enough memory";
      return report;
    } catch (const std::exception& error) {
      answer_.has_failed = true;
      SolveReport report;
      report.reason = fmt::format("the strategy failed with an exception: {}", error.what());
      return report;
    }
  }

  void set_stopped(SolveStage stage) {
    StopCause cause = surroundings_.why_stopped ? surroundings_.why_stopped(stage) : StopCause();
    answer_.status = cause.status;
    answer_.reason = std::move(cause.reason);
  }

  void set_status(const SolveReport& report) {
    answer_.reason = report.reason;
    switch (report.status) {
      case SolveStatus::complete:
        answer_.status = RunStatus::complete;
        return;
      case SolveStatus::partial:
        answer_.status = RunStatus::partial;
        return;
      case SolveStatus::infinite:
        answer_.status = RunStatus::infinite;
        return;
      case SolveStatus::gave_up:
        answer_.status = RunStatus::gave_up;
        return;
      case SolveStatus::stopped:
        if (is_stopped()) return set_stopped(SolveStage::solving);
        answer_.status = RunStatus::gave_up;
        answer_.reason = "the strategy stopped without being asked to";
        return;
    }
  }

  /// Candidates of complete lists that doubles take for the same are told apart by proven errors.
  void take(SolveReport report) {
    set_status(report);
    answer_.claim = report.claim;
    answer_.work = report.work;
    answer_.particulars = std::move(report.particulars);
    const std::size_t candidates = report.candidates.size();
    const bool is_product = report.totals.has_value();
    const bool lists_all = answer_.status == RunStatus::complete &&
                           (report.claim == Claim::all_real || report.claim == Claim::all_complex);
    std::size_t different = 0;
    const auto errors_of = [&](const std::vector<Figure>& figures) {
      if (!lists_all || !may_be_proven(candidates)) return std::vector<double>();
      ProvenErrors proven = prove_errors(
          scene_, {.threads = settings_.threads, .stop = surroundings_.stop, .crew = surroundings_.crew},
          figures);
      different = proven.different;
      return std::move(proven.errors);
    };
    static_cast<Assessment&>(answer_) = assess(scene_, std::move(report), settings_.threads, errors_of);
    const std::size_t listed = answer_.solutions.size();
    if (lists_all && listed < candidates && !may_be_proven(candidates))
      set_unlisted(Natural(candidates), "doubles do not tell all apart, certificates may");
    else if (!is_product && different > listed)
      set_unlisted(Natural(different), "doubles do not tell all apart");
  }

  /// Where certificates are not asked for, long lists are not proven, and may lack some that doubles do not tell apart.
  bool may_be_proven(std::size_t candidates) const {
    constexpr std::size_t most = 1000;  // a second or so
    return settings_.certify || candidates <= most;
  }

  void set_unlisted(const Natural& all, std::string_view why) {
    answer_.status = RunStatus::partial;
    answer_.reason =
        fmt::format("{} of the {} solutions are listed; {}", answer_.solutions.size(), readable(all), why);
  }

  void hold_against_counts(const std::optional<GenericMember>& generic) {
    const TheoreticalCounts& counts = analysis_.counts();
    if (settings_.checks_counts) check_counts(counts);
    if (settings_.certify) prove(counts, generic);
  }

  /// No isolated solutions are more than the theoretical count, and at generic lengths they are as many as the
  /// exact one. Only of complete answers: others say themselves what is wrong with them.
  void check_counts(const TheoreticalCounts& limits) {
    const SolutionCount* limit = limits.upper_limit();
    if (limit == nullptr || answer_.status != RunStatus::complete) return;
    const Natural most = limit->up_to_reflection();
    const auto fail = [&](std::string_view what, const Natural& count) {
      answer_.failed_checks.push_back(
          {"count", fmt::format("{} {} up to reflection, and the {} is {}", count.decimal(), what,
                                limits.exact ? "exact number" : "upper bound", most.decimal())});
    };
    const std::optional<Natural>& generic = answer_.counts.generic;
    const bool is_right = !generic || (limits.exact ? *generic == most : *generic <= most);
    if (!is_right) fail("solutions at generic lengths", *generic);
    Natural solutions;
    for (const AssessedSolution& solution : answer_.solutions)
      solutions += Natural(static_cast<std::uint64_t>(solution.multiplicity));
    if (answer_.totals) solutions = std::max(solutions, answer_.totals->complex.value_or(solutions));
    if (most < solutions) fail("solutions, counted with multiplicities,", solutions);
  }

  /// Of a solve that was stopped, all that it found is certified, and its monitor has heard the last of it.
  void prove(const TheoreticalCounts& counts, const std::optional<GenericMember>& generic) {
    enter(SolveStage::proving);
    const bool was_stopped = is_stopped();
    const std::stop_token stop =
        was_stopped ? std::stop_token() : surroundings_.stop_proofs.value_or(surroundings_.stop);
    certify(scene_, counts, generic,
            {.threads = settings_.threads,
             .monitor = was_stopped ? nullptr : monitor_,
             .stop = stop,
             .crew = surroundings_.crew},
            answer_);
    if (!stop.stop_requested()) return believe_proofs();
    set_stopped(SolveStage::proving);
    answer_.reason += " while solutions were proven";
  }

  /// Where as many solutions are proven as there can be, none is missing, whatever the strategy doubts.
  void believe_proofs() {
    const Proofs& proofs = *answer_.proofs;
    const bool are_proven = proofs.classes + proofs.clusters - proofs.multiple == answer_.solutions.size();
    if (answer_.status != RunStatus::partial || answer_.claim != Claim::all_complex) return;
    if (!are_proven || !proofs.are_complete()) return;
    answer_.status = RunStatus::complete;
    answer_.reason.clear();
  }

  void list(std::size_t candidates) {
    const bool are_distinct = answer_.solutions.size() == candidates;
    if (settings_.only_real) leave_out_complex();
    if (settings_.max_solutions) limit_solutions(*settings_.max_solutions);
    note_unlisted(are_distinct);
  }

  /// What is left of all complex solutions are all real ones.
  void leave_out_complex() {
    keep_real(answer_);
    if (answer_.claim == Claim::all_complex) answer_.claim = Claim::all_real;
  }

  void limit_solutions(std::size_t limit) {
    const std::size_t found = answer_.solutions.size();
    if (found <= limit) return;
    keep_first(answer_, limit);
    if (answer_.status != RunStatus::complete) return;
    answer_.status = RunStatus::partial;
    answer_.reason = fmt::format("{} of the {} solutions found are kept, as asked", limit, found);
  }

  /// Of a product, not all are listed. `are_distinct`: in doubles, what is listed is.
  void note_unlisted(bool are_distinct) {
    const std::optional<SolutionTotals>& totals = answer_.totals;
    if (!totals || answer_.status != RunStatus::complete) return;
    const std::optional<Natural>& all = largest_total(*totals);
    if (!all || *all == Natural(answer_.solutions.size())) return;
    set_unlisted(*all, are_distinct ? "max_solutions lists more" : "doubles do not tell all apart");
  }

  /// Where certificates do not reach the scene nothing is refined.
  void refine() {
    if (why_not_certified(scene_)) return;
    enter(SolveStage::refining);
    std::vector<Figure> figures;
    for (const AssessedSolution& solution : answer_.solutions) figures.push_back(solution.figure);
    answer_.refined = decimal_figures(SceneEquations(scene_), scene_, figures, settings_.digits,
                                      settings_.threads, surroundings_.stop);
    if (is_stopped()) set_stopped(SolveStage::refining);
  }

  const Scene& scene_;
  const SolveSettings& settings_;
  SceneAnalysis analysis_;
  const SolveSurroundings& surroundings_;
  ProgressCall progress_;
  Monitor* monitor_;
  Answer answer_;
};

const StrategyEntry& named(std::string_view name) {
  std::vector<std::string> names;
  for (const StrategyEntry& entry : all_strategies()) {
    if (entry.name == name) return entry;
    names.emplace_back(entry.name);
  }
  throw OptionError(
      fmt::format("there is no strategy '{}'; did you mean '{}'?", name, nearest_name(name, names)));
}

}  // namespace

std::optional<std::string> why_not(const StrategyEntry& entry, const Strategy& strategy,
                                   const SolveRequest& request) {
  return suitability(entry, strategy, request).why_not;
}

Answer solve(const Scene& scene, const StrategyEntry& entry, const OptionMap& given,
             const SolveSettings& settings, const SolveSurroundings& surroundings) {
  return Solve(scene, settings, surroundings).run(entry, given);
}

Answer solve(const Scene& scene, std::string_view strategy, const OptionMap& given,
             const SolveSettings& settings, const SolveSurroundings& surroundings) {
  return solve(scene, named(strategy), given, settings, surroundings);
}

}  // namespace gcs
