#include "solvers/counting/bigraph_count.hpp"

#include <utility>

#include "solvers/counting/bits.hpp"
#include "solvers/counting/simplified_bigraph.hpp"
#include "solvers/counting/split_search.hpp"

namespace gcs {

std::size_t BigraphHash::operator()(const Bigraph& bigraph) const {
  std::uint64_t hash = bigraph.size();
  for (const Biedge& edge : bigraph)
    for (const auto& ends : edge.ends) hash = mixed_bits(hash ^ (std::uint64_t{ends[0]} << 8 | ends[1]));
  return hash;
}

std::optional<std::uint64_t> BigraphCounter::count(const Bigraph& bigraph) {
  const std::uint64_t result = lam(bigraph);
  return steps_.are_exceeded() ? std::nullopt : std::optional(result);
}

std::uint64_t BigraphCounter::lam(const Bigraph& bigraph) {
  if (bigraph.empty()) return 1;
  const auto simple = simplified(bigraph);
  if (!simple) return 0;
  if (simple->size() == 1) return 1;
  Bigraph key = canonical(*simple);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const std::uint64_t result = sum_over_splits(key);
  known_.emplace(std::move(key), result);
  return result;
}

std::uint64_t BigraphCounter::sum_over_splits(const Bigraph& bigraph) {
  std::uint64_t sum = 0;
  for (const auto& [m, n] : possible_splits(bigraph, steps_)) {
    if (steps_.are_exceeded()) break;
    sum += product(contracted(bigraph, 0, m), contracted(bigraph, 1, n));
  }
  return sum;
}

/// The smaller one first: it is often 0.
std::uint64_t BigraphCounter::product(Bigraph first, Bigraph second) {
  if (second.size() < first.size()) std::swap(first, second);
  const std::uint64_t count = lam(first);
  return count == 0 ? 0 : count * lam(second);
}

}  // namespace gcs
