#pragma once
/// Points on the projective line with given cross ratios of quadruples of them: how many such configurations there are
/// up to projective maps, for as many quadruples as configurations have freedoms, at generic values.
/// [S] M. Gallet, G. Grasegger, J. Schicho: Counting realizations of Laman graphs on the sphere. Electron. J. Combin.
/// 27 (2020). A point of the complex sphere is the pair of points in which the lines through it meet the conic at
/// infinity, and the distance of two points is the cross ratio of their pairs.

#include <cstdint>
#include <optional>
#include <vector>

namespace gcs {

/// A bit per mark, as points on the line are called.
using MarkSet = std::uint64_t;
inline constexpr int most_marks = 58;

struct CrossRatios {
  int marks = 0;                    ///< at least 3, at most most_marks
  std::vector<MarkSet> quadruples;  ///< sets of four marks, as many as there are marks but three

  friend auto operator<=>(const CrossRatios&, const CrossRatios&) = default;
};

/// As many configurations with less marks; nothing where there are none. The values are independent if and only if
/// any k > 0 of the quadruples have k + 3 marks or more together. A mark that is in one quadruple only is determined
/// by its cross ratio.
std::optional<CrossRatios> simplified(CrossRatios ratios);

/// Renames marks and orders quadruples by what is around them, so that systems that are equal but for names mostly
/// become equal.
CrossRatios canonical(const CrossRatios& ratios);

}  // namespace gcs
