#include "solvers/counting/cross_ratios.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "solvers/counting/bits.hpp"

namespace gcs {
namespace {

/// Quadruples with a mark each, none with the same.
class Matching {
 public:
  explicit Matching(const CrossRatios& ratios) : quadruples_(ratios.quadruples) { owner_.fill(none); }

  /// Finds a mark for a quadruple, if it has one already another one. False where that is impossible.
  bool add(std::size_t quadruple) {
    tried_ = 0;
    return augment(quadruple);
  }

 private:
  static constexpr std::size_t none = most_marks;

  bool augment(std::size_t quadruple) {
    for (MarkSet left = quadruples_[quadruple] & ~tried_; left != 0;
         left = quadruples_[quadruple] & ~tried_) {
      const std::size_t mark = first_place(left);
      tried_ |= single_bit(mark);
      if (owner_[mark] != none && !augment(owner_[mark])) continue;
      owner_[mark] = quadruple;
      return true;
    }
    return false;
  }

  const std::vector<MarkSet>& quadruples_;
  std::array<std::size_t, most_marks> owner_{};
  MarkSet tried_ = 0;
};

/// By Hall's theorem the condition of `simplified` says that the quadruples, any one of them taken four times, have
/// marks of their own.
bool has_independent_values(const CrossRatios& ratios) {
  Matching matching(ratios);
  for (std::size_t q = 0; q < ratios.quadruples.size(); ++q)
    if (!matching.add(q)) return false;
  for (std::size_t q = 0; q < ratios.quadruples.size(); ++q) {
    Matching more = matching;
    for (int copy = 0; copy < 3; ++copy)
      if (!more.add(q)) return false;
  }
  return true;
}

MarkSet without_mark(MarkSet marks, std::size_t mark) {
  const MarkSet below = marks & (single_bit(mark) - 1);
  return below | ((marks >> 1) & ~(single_bit(mark) - 1));
}

/// Leaves out a mark that is in one quadruple only. False where there is none.
bool drop_mark(CrossRatios& ratios) {
  MarkSet once = 0, more = 0;
  for (const MarkSet quadruple : ratios.quadruples) {
    more |= once & quadruple;
    once |= quadruple;
  }
  if ((once & ~more) == 0) return false;
  const std::size_t mark = first_place(once & ~more);
  std::erase_if(ratios.quadruples, [&](MarkSet quadruple) { return (quadruple & single_bit(mark)) != 0; });
  for (MarkSet& quadruple : ratios.quadruples) quadruple = without_mark(quadruple, mark);
  --ratios.marks;
  return true;
}

using MarkColours = std::vector<std::uint64_t>;  ///< of each mark

/// Colour refinement, as in bigraph.cpp.
MarkColours refined(const CrossRatios& ratios, const MarkColours& colours) {
  MarkColours next = colours;
  for (const MarkSet quadruple : ratios.quadruples) {
    std::uint64_t sum = 0;
    for (MarkSet left = quadruple; left != 0; left &= left - 1) sum += mixed_bits(colours[first_place(left)]);
    for (MarkSet left = quadruple; left != 0; left &= left - 1) next[first_place(left)] += mixed_bits(sum);
  }
  for (std::uint64_t& colour : next) colour = mixed_bits(colour);
  return next;
}

/// The marks in the order of their colours. Where some have the same colour, one of them is given another.
std::vector<std::size_t> ordered_marks(const CrossRatios& ratios) {
  constexpr int rounds = 3;
  MarkColours colours(static_cast<std::size_t>(ratios.marks), 1);
  std::vector<std::size_t> order(colours.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (;;) {
    for (int round = 0; round < rounds; ++round) colours = refined(ratios, colours);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return colours[a] != colours[b] ? colours[a] < colours[b] : a < b;
    });
    const auto twin = std::adjacent_find(
        order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return colours[a] == colours[b]; });
    if (twin == order.end()) return order;
    colours[*twin] = mixed_bits(colours[*twin] + 1);
  }
}

}  // namespace

std::optional<CrossRatios> simplified(CrossRatios ratios) {
  if (static_cast<int>(ratios.quadruples.size()) != ratios.marks - 3 || !has_independent_values(ratios))
    return std::nullopt;
  while (drop_mark(ratios)) continue;
  return ratios;
}

CrossRatios canonical(const CrossRatios& ratios) {
  const std::vector<std::size_t> order = ordered_marks(ratios);
  std::vector<std::size_t> name(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) name[order[i]] = i;
  CrossRatios result{ratios.marks, {}};
  for (const MarkSet quadruple : ratios.quadruples) {
    MarkSet& renamed = result.quadruples.emplace_back(0);
    for (MarkSet left = quadruple; left != 0; left &= left - 1)
      renamed |= single_bit(name[first_place(left)]);
  }
  std::sort(result.quadruples.begin(), result.quadruples.end());
  return result;
}

}  // namespace gcs
