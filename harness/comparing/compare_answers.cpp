#include "harness/comparing/compare_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "harness/base/record_fields.hpp"
#include "harness/tables/table_entries.hpp"

namespace gcs {
namespace {

/// `more` and `less` are what a greater and a smaller value mean.
template <typename Value>
ChangeVerdict verdict_of(const Value& before, const Value& after, ChangeVerdict more) {
  if (more == ChangeVerdict::different) return ChangeVerdict::different;
  const ChangeVerdict less = more == ChangeVerdict::better ? ChangeVerdict::worse : ChangeVerdict::better;
  return before < after ? more : less;
}

/// Collects what differs in one cell.
class Changes {
 public:
  explicit Changes(CellSpec cell) : cell_(std::move(cell)) {}

  void add(const std::string& what, std::string before, std::string after, ChangeVerdict verdict) {
    changes_.push_back({cell_, {what, std::move(before), std::move(after)}, verdict});
  }

  /// An empty value is less than any other: nothing is known.
  template <typename Value, typename Text>
  void compare(const std::string& what, const std::optional<Value>& before, const std::optional<Value>& after,
               ChangeVerdict more, Text text) {
    if (before == after) return;
    const auto words = [&](const std::optional<Value>& value) { return value ? text(*value) : "not known"; };
    add(what, words(before), words(after), verdict_of(before, after, more));
  }

  std::vector<AnswerChange> take() { return std::move(changes_); }

 private:
  CellSpec cell_;
  std::vector<AnswerChange> changes_;
};

std::string count_text(const Natural& count) { return count.decimal(); }
std::string whole_text(std::uint64_t count) { return std::to_string(count); }

/// A wrong answer is worse than none.
int rank(const CellRecord& cell) {
  if (cell.is_flawed()) return 0;
  if (cell.status == RunStatus::complete || cell.status == RunStatus::infinite) return 3;
  return cell.status == RunStatus::partial ? 2 : 1;
}

std::string status_text(const CellRecord& cell) {
  std::string text(word(cell.status));
  if (cell.is_flawed()) text += ", wrong";
  const std::string& cause = cell.difference.empty() ? cell.reason : cell.difference;
  return cause.empty() ? text : text + ": " + cause;
}

void compare_status(const CellRecord& before, const CellRecord& after, Changes& changes) {
  if (before.status == after.status && before.is_flawed() == after.is_flawed()) return;
  const ChangeVerdict verdict = rank(before) == rank(after)
                                    ? ChangeVerdict::different
                                    : verdict_of(rank(before), rank(after), ChangeVerdict::better);
  changes.add("status", status_text(before), status_text(after), verdict);
}

/// On the path of the core, of the whole scene and of a component are different claims, and none is stronger.
int strength(Claim claim) {
  constexpr std::array strengths{0, 1, 1, 1, 2, 3};
  return strengths[static_cast<std::size_t>(claim)];
}

void compare_claim(const CellRecord& before, const CellRecord& after, Changes& changes) {
  if (!before.claim || !after.claim || before.claim == after.claim) return;
  const int then = strength(*before.claim), now = strength(*after.claim);
  changes.add("claim", std::string(word(*before.claim)), std::string(word(*after.claim)),
              then == now ? ChangeVerdict::different : verdict_of(then, now, ChangeVerdict::better));
}

/// What more of a count means.
ChangeVerdict meaning_of_more(std::string_view count) {
  if (count == "failed_paths") return ChangeVerdict::worse;
  const bool is_neutral = count == "paths" || count == "at_infinity" || count == "singular";
  return is_neutral ? ChangeVerdict::different : ChangeVerdict::better;
}

/// Of a wrong answer no count is better or worse than another.
void compare_counts(const Counts& before, const Counts& after, bool is_any_flawed, Changes& changes) {
  const auto compare = [&](const std::string& name, const auto& then, const auto& now) {
    const ChangeVerdict more = is_any_flawed ? ChangeVerdict::different : meaning_of_more(name);
    if constexpr (std::is_same_v<decltype(then), const std::optional<Natural>&>)
      changes.compare(name, then, now, more, count_text);
    else
      changes.compare(name, then, now, more, whole_text);
  };
  visit_counts(before, [&](const std::string& name, const auto& then) {
    visit_counts(after, [&](const std::string& other, const auto& now) {
      if constexpr (std::is_same_v<decltype(then), decltype(now)>)
        if (name == other) compare(name, then, now);
    });
  });
}

/// One member of what both or either may lack.
template <typename Record, typename Member>
auto member_of(const std::optional<Record>& record, Member Record::*member) {
  return record ? std::optional((*record).*member) : std::nullopt;
}

void compare_proofs(const CellRecord& before, const CellRecord& after, Changes& changes) {
  const auto compare = [&](const std::string& what, auto RecordedProofs::*member, auto text) {
    changes.compare(what, member_of(before.proofs, member), member_of(after.proofs, member),
                    ChangeVerdict::better, text);
  };
  const auto yes_or_no = [](bool holds) { return std::string(holds ? "yes" : "no"); };
  compare("classes proven", &RecordedProofs::classes, whole_text);
  compare("real classes proven", &RecordedProofs::real, whole_text);
  compare("all complex proven", &RecordedProofs::is_complete, yes_or_no);
  compare("all real proven", &RecordedProofs::decides_real, yes_or_no);
}

/// Only where both were held against a reference.
void compare_accuracy(const CellRecord& before, const CellRecord& after, Changes& changes) {
  if (!before.accuracy || !after.accuracy) return;
  const Accuracy &then = *before.accuracy, &now = *after.accuracy;
  const auto compare = [&](const std::string& what, std::uint64_t first, std::uint64_t second,
                           ChangeVerdict more) {
    changes.compare(what, std::optional(first), std::optional(second), more, whole_text);
  };
  compare("reference solutions met", then.met, now.met, ChangeVerdict::better);
  if (then.missed && now.missed) compare("solutions missed", *then.missed, *now.missed, ChangeVerdict::worse);
  compare("spurious solutions", then.spurious, now.spurious, ChangeVerdict::worse);
  const bool was_explained = then.largest_quotient <= explained_quotient;
  const bool is_explained = now.largest_quotient <= explained_quotient;
  if (was_explained == is_explained) return;
  changes.add("largest error, relative to the scene's size", fmt::format("{:.2g}", then.largest_error),
              fmt::format("{:.2g}", now.largest_error),
              is_explained ? ChangeVerdict::better : ChangeVerdict::worse);
}

}  // namespace

std::vector<AnswerChange> compare_answers(const CellRecord& before, const CellRecord& after,
                                          bool have_one_reference) {
  Changes changes(before.spec);
  compare_status(before, after, changes);
  // How far a solve came before its time was up is chance.
  if (before.status == RunStatus::timed_out || after.status == RunStatus::timed_out) return changes.take();
  compare_claim(before, after, changes);
  compare_counts(before.counts, after.counts, before.is_flawed() || after.is_flawed(), changes);
  compare_proofs(before, after, changes);
  if (have_one_reference) compare_accuracy(before, after, changes);
  return changes.take();
}

}  // namespace gcs
