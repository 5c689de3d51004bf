#include "harness/comparing/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "harness/base/record_fields.hpp"
#include "harness/comparing/compare_answers.hpp"
#include "harness/tables/table_entries.hpp"

namespace gcs {
namespace {

std::string limit_text(const std::optional<double>& seconds) {
  return seconds ? duration_text(*seconds) : "none";
}

std::string made_by(const RunFile& run) {
  if (run.sessions.empty()) return "started " + run.started;
  return fmt::format("started {} by `{}`", run.started, fmt::join(run.sessions.front().arguments, " "));
}

/// What the run was made with, by names for a person.
std::vector<std::pair<std::string, std::string>> setup_of(const RunFile& run) {
  std::vector<std::pair<std::string, std::string>> setup;
  visit_environment(run.environment, [&](const std::string& name, const auto& value) {
    setup.emplace_back(name, fmt::format("{}", value));
  });
  setup.emplace_back("seed", std::to_string(run.seed));
  if (run.sessions.empty()) return setup;
  const RunSession& last = run.sessions.back();
  setup.emplace_back("sessions", std::to_string(run.sessions.size()));
  setup.emplace_back("load average, 1 minute",
                     last.load_average ? fmt::format("{:.2f}", last.load_average->front()) : "not known");
  setup.emplace_back("repetitions asked for",
                     last.repetitions ? std::to_string(*last.repetitions) : "as time allows");
  setup.emplace_back("limit of one solve", limit_text(last.cell_limit_s));
  setup.emplace_back("limit of a session", limit_text(last.total_limit_s));
  return setup;
}

const InstanceSummary* find_instance(const RunFile& run, const std::string& id) {
  const auto found = std::find_if(run.instances.begin(), run.instances.end(),
                                  [&](const InstanceSummary& instance) { return instance.id == id; });
  return found == run.instances.end() ? nullptr : &*found;
}

std::vector<Changed> changed_setup(const RunFile& before, const RunFile& after) {
  std::vector<Changed> changes;
  const auto now = setup_of(after);
  for (const auto& [name, then] : setup_of(before))
    for (const auto& [other, value] : now)
      if (name == other && then != value) changes.push_back({name, then, value});
  for (const InstanceSummary& then : before.instances) {
    const InstanceSummary* other = find_instance(after, then.id);
    if (other == nullptr) continue;
    if (then.fingerprint != other->fingerprint)
      changes.push_back(
          {"content of " + then.id + " (its cells are not compared)", then.fingerprint, other->fingerprint});
    else if (then.reference != other->reference)
      changes.push_back({"reference of " + then.id, then.reference, other->reference});
  }
  return changes;
}

/// Solved, or refused by the strategy; not left out for want of time or interrupted.
bool is_measured(const CellRecord& cell) {
  const bool was_run = cell.claim.has_value() || cell.status != RunStatus::timed_out;
  return was_run && cell.status != RunStatus::interrupted;
}

/// The cell of that spec if it was measured.
const CellRecord* find_measured(const RunFile& run, const CellSpec& spec) {
  const CellRecord* cell = run.find(spec);
  return cell != nullptr && is_measured(*cell) ? cell : nullptr;
}

std::vector<CellSpec> only_in_first(const RunFile& first, const RunFile& second) {
  std::vector<CellSpec> only;
  for (const CellRecord& cell : first.cells)
    if (is_measured(cell) && find_measured(second, cell.spec) == nullptr) only.push_back(cell.spec);
  return only;
}

struct Pair {
  const CellRecord& before;
  const CellRecord& after;
  bool have_one_reference = false;
};

std::vector<Pair> pairs_of(const RunFile& before, const RunFile& after) {
  std::vector<Pair> pairs;
  for (const CellRecord& cell : before.cells) {
    const CellRecord* other = find_measured(after, cell.spec);
    if (!is_measured(cell) || other == nullptr) continue;
    const InstanceSummary* then = find_instance(before, cell.spec.instance);
    const InstanceSummary* now = find_instance(after, cell.spec.instance);
    if (then != nullptr && now != nullptr && then->fingerprint == now->fingerprint)
      pairs.push_back({cell, *other, then->reference == now->reference});
  }
  return pairs;
}

/// Work counters and the strategy's own counts, as text by name.
std::vector<std::pair<std::string, std::string>> work_of(const CellRecord& cell) {
  std::vector<std::pair<std::string, std::string>> work;
  visit_work(cell.work, [&](const std::string& name, const auto& value) {
    if constexpr (requires { value.has_value(); })
      work.emplace_back(name, value ? number_text(static_cast<double>(*value)) : "–");
    else
      work.emplace_back(name, std::to_string(value));
  });
  for (const Particular& particular : cell.particulars)
    work.emplace_back(particular.name, std::to_string(particular.value));
  return work;
}

/// How far a solve came before its time was up is chance, and not compared.
void compare_work(const Pair& pair, std::vector<WorkChange>& changes) {
  if (pair.before.status == RunStatus::timed_out || pair.after.status == RunStatus::timed_out) return;
  const auto now = work_of(pair.after);
  for (const auto& [name, then] : work_of(pair.before))
    for (const auto& [other, value] : now)
      if (name == other && then != value) changes.push_back({pair.before.spec, {name, then, value}});
}

std::vector<double> seconds_of(const CellRecord& cell) {
  std::vector<double> seconds;
  for (const Timing& repetition : cell.repetitions) seconds.push_back(repetition.total_s());
  return seconds;
}

/// The same, with what the processor did in solve.
double processor_median_s(const CellRecord& cell) {
  std::vector<double> seconds;
  for (const Timing& repetition : cell.repetitions)
    seconds.push_back(repetition.prepare_s + repetition.cpu_s + repetition.refine_s);
  return median_interval(std::move(seconds)).median;
}

/// A time that grows while the processor's does not is spent waiting for other processes.
Pace pace_of(const TimeChange& change, double wanted, double margin) {
  const double more = 1 + margin, less = 1 / more;
  const MedianRatio& ratio = change.together;
  if (ratio.confidence < wanted) return Pace::too_few_runs;
  if (ratio.low > more && change.processor > more) return Pace::slower;
  if (ratio.high < less && change.processor < less) return Pace::faster;
  return ratio.low >= less && ratio.high <= more ? Pace::alike : Pace::undecided;
}

std::vector<TimeChange> compare_times(const std::vector<Pair>& pairs, const CompareSettings& settings) {
  std::vector<Pair> timed;
  for (const Pair& pair : pairs)
    if (!pair.before.repetitions.empty() && !pair.after.repetitions.empty()) timed.push_back(pair);
  const double share =
      (1 - settings.confidence) / static_cast<double>(std::max<std::size_t>(1, timed.size()));
  std::vector<TimeChange> changes;
  for (const Pair& pair : timed) {
    const std::vector<double> then = seconds_of(pair.before);
    const std::vector<double> now = seconds_of(pair.after);
    TimeChange change{pair.before.spec,
                      median_interval(then),
                      median_interval(now),
                      median_ratio(then, now, 0.95),
                      median_ratio(then, now, 1 - share),
                      processor_median_s(pair.after) / processor_median_s(pair.before)};
    change.pace = pace_of(change, 1 - share, settings.margin);
    changes.push_back(std::move(change));
  }
  return changes;
}

bool was_busy(const RunFile& run) {
  return std::any_of(run.sessions.begin(), run.sessions.end(), [](const RunSession& session) {
    return session.load_average && session.load_average->front() >= 1;
  });
}

}  // namespace

std::string_view word(Pace pace) {
  constexpr std::array<std::string_view, 5> words{"alike", "slower", "faster", "undecided", "too few runs"};
  return words[static_cast<std::size_t>(pace)];
}

bool Comparison::has_regressed() const {
  const auto is_worse = [](const AnswerChange& change) { return change.verdict == ChangeVerdict::worse; };
  const auto is_slower = [](const TimeChange& change) { return change.pace == Pace::slower; };
  return std::any_of(answers.begin(), answers.end(), is_worse) ||
         (is_same_machine && std::any_of(times.begin(), times.end(), is_slower));
}

Comparison compare_runs(const RunFile& before, const RunFile& after, const CompareSettings& settings) {
  Comparison comparison;
  comparison.settings = settings;
  comparison.before_made = made_by(before);
  comparison.after_made = made_by(after);
  comparison.setup = changed_setup(before, after);
  comparison.is_same_machine = before.environment.cpu == after.environment.cpu &&
                               before.environment.threads == after.environment.threads;
  comparison.was_busy = was_busy(before) || was_busy(after);
  comparison.only_before = only_in_first(before, after);
  comparison.only_after = only_in_first(after, before);
  const std::vector<Pair> pairs = pairs_of(before, after);
  comparison.compared = static_cast<int>(pairs.size());
  for (const Pair& pair : pairs) {
    for (AnswerChange& change : compare_answers(pair.before, pair.after, pair.have_one_reference))
      comparison.answers.push_back(std::move(change));
    compare_work(pair, comparison.work);
  }
  comparison.times = compare_times(pairs, settings);
  return comparison;
}

}  // namespace gcs
