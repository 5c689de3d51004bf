#pragma once
/// The number of realisations of a bigraph by the recursion of [C] Theorem 4.7 (see bigraph.hpp):
/// Lam(B) = Lam(ᵉB) + Lam(Bᵉ) + Σ Lam(ᴹB)·Lam(Bᴺ) over M ∪ N = E, M ∩ N = {e}, |M|, |N| ≥ 2. With Lam = 1 for
/// the empty bigraph the first two are the summands M = {e} and N = {e}.

#include <cstdint>
#include <map>
#include <optional>

#include "solvers/counting/bigraph.hpp"

namespace gcs {

/// Remembers what it has counted.
class BigraphCounter {
 public:
  /// `most_steps`: how many edges may be given to M or N in all before it gives up.
  explicit BigraphCounter(std::int64_t most_steps) : steps_left_(most_steps) {}

  /// The degree of the map (x, y) ↦ (x_e·y_e) from P^(dim G − 1) × P^(dim H − 1) to P^(|E| − 1), 0 where the
  /// map is not dominant; nothing where the steps do not suffice. 64 bits do: by Bézout the degree is at most
  /// the binomial coefficient of |E| − 1 over dim G − 1, below 2^63; so are all summands.
  std::optional<std::uint64_t> count(const Bigraph& bigraph);

 private:
  std::uint64_t lam(const Bigraph& bigraph);
  std::uint64_t sum_over_splits(const Bigraph& bigraph);
  std::uint64_t product(Bigraph first, Bigraph second);

  std::int64_t steps_left_;
  std::map<Bigraph, std::uint64_t> known_;
};

}  // namespace gcs
