#pragma once
/// The number of realisations of a bigraph by the recursion of [C] Theorem 4.7 (see bigraph.hpp):
/// Lam(B) = Lam(ᵉB) + Lam(Bᵉ) + Σ Lam(ᴹB)·Lam(Bᴺ) over M ∪ N = E, M ∩ N = {e}, |M|, |N| ≥ 2. With Lam = 1 for
/// the empty bigraph the first two are the summands M = {e} and N = {e}.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "solvers/counting/bigraph.hpp"
#include "solvers/counting/recursion_limits.hpp"

namespace gcs {

struct BigraphHash {
  std::size_t operator()(const Bigraph& bigraph) const;
};

/// Remembers what it has counted.
class BigraphCounter {
 public:
  explicit BigraphCounter(const RecursionLimits& limits) : steps_(limits) {}

  /// The degree of the map (x, y) ↦ (x_e·y_e) from P^(dim G − 1) × P^(dim H − 1) to P^(|E| − 1), 0 where the
  /// map is not dominant; nothing where the limits do not suffice. 64 bits do: by Bézout the degree is at most
  /// the binomial coefficient of |E| − 1 over dim G − 1, below 2^63; so are all summands.
  std::optional<std::uint64_t> count(const Bigraph& bigraph);

 private:
  std::uint64_t lam(const Bigraph& bigraph);
  std::uint64_t sum_over_splits(const Bigraph& bigraph);
  std::uint64_t product(Bigraph first, Bigraph second);

  StepsLeft steps_;
  std::unordered_map<Bigraph, std::uint64_t, BigraphHash> known_;
};

}  // namespace gcs
