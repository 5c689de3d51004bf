#include "harness/tests/contract/report_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "solvers/figures/reflection_classes.hpp"

namespace gcs::contract {
namespace {

/// The classes of two reports' candidates under common numbers.
struct CommonClasses {
  std::vector<int> of_a, of_b;  ///< by candidate
};

CommonClasses common_classes(const Scene& scene, const SolveReport& a, const SolveReport& b) {
  std::vector<Figure> figures;
  for (const SolveReport* report : {&a, &b})
    for (const Candidate& candidate : report->candidates) figures.push_back(candidate.figure);
  const std::vector<int> all = reflection_classes(scene, figures, agreement_tolerance).class_of;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(a.candidates.size());
  return {{all.begin(), middle}, {middle, all.end()}};
}

/// Class and direction of every crossing in the order met.
using Round = std::vector<std::pair<int, int>>;

Round round_of(const SolveReport& report, const std::vector<int>& class_of) {
  Round round;
  for (const PathRecord& path : report.paths)
    for (const Crossing& crossing : path.crossings)
      round.emplace_back(class_of[crossing.candidate], crossing.direction);
  return round;
}

Round reversed(Round round) {
  std::reverse(round.begin(), round.end());
  for (auto& [number, direction] : round) direction = -direction;
  return round;
}

bool is_rotation(const Round& a, const Round& b) {
  if (a.size() != b.size()) return false;
  if (a.empty()) return true;
  Round twice = a;
  twice.insert(twice.end(), a.begin(), a.end());
  return std::search(twice.begin(), twice.end(), b.begin(), b.end()) != twice.end();
}

std::string in_words(const Round& round) {
  std::string words;
  for (const auto& [number, direction] : round)
    words += fmt::format(" {}{}", direction > 0 ? '+' : '-', number);
  return words;
}

std::optional<std::string> different_rounds(const SolveReport& a, const SolveReport& b,
                                            const CommonClasses& classes) {
  const Round round_a = round_of(a, classes.of_a), round_b = round_of(b, classes.of_b);
  if (is_rotation(round_a, round_b) || is_rotation(round_a, reversed(round_b))) return std::nullopt;
  return fmt::format("one path meets the classes{}, the other{}", in_words(round_a), in_words(round_b));
}

/// The first candidate that `claim` covers and whose class is not among the others.
std::optional<std::string> missing(const SolveReport& report, const std::vector<int>& classes,
                                   const std::vector<int>& others, Claim claim) {
  const std::set<int> known(others.begin(), others.end());
  for (std::size_t i = 0; i < classes.size(); ++i)
    if (known.count(classes[i]) == 0 &&
        (claim == Claim::all_complex || report.candidates[i].figure.is_real()))
      return fmt::format("candidate {} of one report is of a class that the other does not hold", i);
  return std::nullopt;
}

/// True for the claims that leave no real solution out.
bool is_exhaustive(Claim claim) { return claim == Claim::all_real || claim == Claim::all_complex; }

}  // namespace

std::optional<std::string> contradiction(const Scene& scene, const SolveReport& a, const SolveReport& b) {
  if (a.status != SolveStatus::complete || b.status != SolveStatus::complete) return std::nullopt;
  const CommonClasses classes = common_classes(scene, a, b);
  if (a.claim == Claim::on_path && b.claim == Claim::on_path) return different_rounds(a, b, classes);
  std::optional<std::string> found;
  if (is_exhaustive(a.claim)) found = missing(b, classes.of_b, classes.of_a, a.claim);
  if (!found && is_exhaustive(b.claim)) found = missing(a, classes.of_a, classes.of_b, b.claim);
  return found;
}

std::optional<std::string> outsider(const Scene& scene, const SolveReport& part, const SolveReport& whole) {
  const CommonClasses classes = common_classes(scene, part, whole);
  return missing(part, classes.of_a, classes.of_b, Claim::all_complex);
}

}  // namespace gcs::contract
