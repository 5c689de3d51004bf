#include "solvers/counting/cross_ratio_count.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "solvers/counting/bits.hpp"

namespace gcs {
namespace {

/// The marks on either line.
using Distribution = std::array<MarkSet, 2>;

MarkSet lowest(MarkSet marks) { return marks & -marks; }

/// The quadruple that degenerates, and how.
struct Degeneration {
  std::size_t quadruple = 0;
  Distribution start{};
};

/// The one that leaves least to choose: most other quadruples have one of its two pairs.
Degeneration degeneration_of(const CrossRatios& ratios) {
  Degeneration best;
  int most = -1;
  for (std::size_t q = 0; q < ratios.quadruples.size(); ++q) {
    const MarkSet all = ratios.quadruples[q], a = lowest(all);
    for (MarkSet left = all & ~a; left != 0; left &= left - 1) {
      const Distribution start{a | lowest(left), all & ~(a | lowest(left))};
      int having = 0;
      for (const MarkSet other : ratios.quadruples)
        for (const MarkSet pair : start)
          if ((other & pair) == pair) ++having;
      if (having > most) best = {q, start};
      most = std::max(most, having);
    }
  }
  return best;
}

/// Finds all distributions that leave each line as many cross ratios as its marks have freedoms.
class DistributionSearch {
 public:
  DistributionSearch(const CrossRatios& ratios, std::size_t without, StepsLeft& steps)
      : ratios_(ratios),
        without_(without),
        all_(single_bit(static_cast<std::size_t>(ratios.marks)) - 1),
        steps_(steps) {}

  std::vector<Distribution> run(const Distribution& start) {
    search(start);
    return std::move(found_);
  }

 private:
  /// Places marks of quadruples of which two are on one line and one on the other. False where two are on each.
  bool settle(Distribution& placed) const {
    for (bool changes = true; changes;) {
      changes = false;
      for (std::size_t q = 0; q < ratios_.quadruples.size(); ++q) {
        if (q == without_) continue;
        const MarkSet marks = ratios_.quadruples[q], open = marks & ~(placed[0] | placed[1]);
        const std::array on{std::popcount(marks & placed[0]), std::popcount(marks & placed[1])};
        if (on[0] >= 2 && on[1] >= 2) return false;
        if (on[0] + on[1] != 3 || on[0] == 3 || on[1] == 3) continue;
        placed[on[0] == 2 ? 0 : 1] |= open;
        changes = true;
      }
    }
    return true;
  }

  /// A mark to place next: of a quadruple with as many placed ones as possible.
  MarkSet next_open(const Distribution& placed) const {
    MarkSet best = lowest(all_ & ~(placed[0] | placed[1]));
    int most = 0;
    for (const MarkSet quadruple : ratios_.quadruples) {
      const MarkSet open = quadruple & ~(placed[0] | placed[1]);
      const int count = 4 - std::popcount(open);
      if (open == 0 || count <= most) continue;
      most = count;
      best = lowest(open);
    }
    return best;
  }

  /// With the mark in which the lines meet there is a freedom for each of a line's marks but two.
  bool has_right_numbers(const Distribution& placed) const {
    int quadruples = 0;
    for (std::size_t q = 0; q < ratios_.quadruples.size(); ++q)
      if (q != without_ && std::popcount(ratios_.quadruples[q] & placed[0]) >= 3) ++quadruples;
    return quadruples == std::popcount(placed[0]) - 2;
  }

  void search(Distribution placed) {
    if (!steps_.take() || !settle(placed)) return;
    if ((placed[0] | placed[1]) == all_) {
      if (has_right_numbers(placed)) found_.push_back(placed);
      return;
    }
    const MarkSet next = next_open(placed);
    for (const int line : {0, 1}) {
      Distribution longer = placed;
      longer[line] |= next;
      search(longer);
    }
  }

  const CrossRatios& ratios_;
  std::size_t without_;
  MarkSet all_;
  StepsLeft& steps_;
  std::vector<Distribution> found_;
};

/// What is on a line with those marks, and where it meets the other one.
CrossRatios on_line(const CrossRatios& ratios, std::size_t without, MarkSet marks) {
  std::array<MarkSet, most_marks> name{};
  CrossRatios result;
  for (MarkSet left = marks; left != 0; left &= left - 1)
    name[first_place(left)] = single_bit(static_cast<std::size_t>(result.marks++));
  const MarkSet meeting = single_bit(static_cast<std::size_t>(result.marks++));
  for (std::size_t q = 0; q < ratios.quadruples.size(); ++q) {
    const MarkSet here = ratios.quadruples[q] & marks;
    if (q == without || std::popcount(here) < 3) continue;
    MarkSet& renamed = result.quadruples.emplace_back(std::popcount(here) == 3 ? meeting : 0);
    for (MarkSet left = here; left != 0; left &= left - 1) renamed |= name[first_place(left)];
  }
  return result;
}

}  // namespace

std::optional<std::uint64_t> CrossRatioCounter::count(const CrossRatios& ratios) {
  const std::uint64_t result = number(ratios);
  return steps_.are_exceeded() ? std::nullopt : std::optional(result);
}

std::uint64_t CrossRatioCounter::number(const CrossRatios& ratios) {
  const auto simple = simplified(ratios);
  if (!simple) return 0;
  if (simple->quadruples.empty()) return 1;
  CrossRatios key = canonical(*simple);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const std::uint64_t result = sum_over_distributions(key);
  known_.emplace(std::move(key), result);
  return result;
}

std::uint64_t CrossRatioCounter::sum_over_distributions(const CrossRatios& ratios) {
  const auto [quadruple, start] = degeneration_of(ratios);
  std::uint64_t sum = 0;
  for (const Distribution& marks : DistributionSearch(ratios, quadruple, steps_).run(start)) {
    if (steps_.are_exceeded()) break;
    const std::uint64_t first = number(on_line(ratios, quadruple, marks[0]));
    if (first != 0) sum += first * number(on_line(ratios, quadruple, marks[1]));
  }
  return sum;
}

}  // namespace gcs
