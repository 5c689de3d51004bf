#pragma once
/// The number of configurations of a system of cross ratios by the recursion of [S] (see cross_ratios.hpp): at the value
/// of one cross ratio at which its marks a, b come together and c, d too, a configuration is two lines that meet in a
/// point, which is a further mark of both. Of every other quadruple three marks or more are on one line, which then
/// carries its cross ratio. So the number is the sum over all distributions of the marks of the products of both lines'
/// numbers.

#include <cstdint>
#include <map>
#include <optional>

#include "solvers/counting/cross_ratios.hpp"
#include "solvers/counting/recursion_limits.hpp"

namespace gcs {

/// Remembers what it has counted.
class CrossRatioCounter {
 public:
  explicit CrossRatioCounter(const RecursionLimits& limits) : steps_(limits) {}

  /// Nothing where the limits do not suffice. 64 bits do: by Silversmith (Cross-ratio
  /// degrees and perfect matchings, 2022) the number is at most that of perfect matchings of quadruples with all marks
  /// but any three, by Brègman at most 24^(55/4) < 2^64; so are all summands.
  std::optional<std::uint64_t> count(const CrossRatios& ratios);

 private:
  std::uint64_t number(const CrossRatios& ratios);
  std::uint64_t sum_over_distributions(const CrossRatios& ratios);

  StepsLeft steps_;
  std::map<CrossRatios, std::uint64_t> known_;
};

}  // namespace gcs
