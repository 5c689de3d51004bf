#pragma once
/// What constraints of a general scene say beyond their equations: signs, which select among the real solutions of these.
/// An orientation gives that of the determinant of p2 − p1, p3 − p1, …; an angle of two segments that of (q − p)·(s − r),
/// which is not in its equation where the length of a segment is free to become negative.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "solvers/elements/placement.hpp"
#include "solvers/numeric/interval.hpp"

namespace gcs {

/// A determinant, of as many ways as there are dimensions, or the inner product of two ways has this sign.
struct StatedSign {
  using Way = std::array<int, 2>;  ///< from one point to another

  int relation = -1;  ///< its number among the problem's
  std::vector<Way> ways;
  bool is_determinant = false;
  int sign = 0;
};

std::vector<StatedSign> stated_signs(const ProblemStatement& problem);

/// The problem of the same equations that has no orientations; nothing where it has none itself.
std::optional<ProblemStatement> without_orientations(ProblemStatement problem);

enum class Standing { as_stated, undecided, not_as_stated };

/// What signs say of a real solution of the equations.
struct SignVerdict {
  Standing standing = Standing::as_stated;
  /// Numbers of the relations that do not hold as stated or, where none is known not to, of those that are undecided.
  std::vector<int> relations{};

  bool operator==(const SignVerdict&) const = default;
};

using EnclosedPoint = std::array<Interval, 3>;

/// Of the figure whose points lie where `at` says, by their numbers. A sign is undecided where neither is excluded.
SignVerdict verdict_on(const std::vector<StatedSign>& signs,
                       const std::function<EnclosedPoint(int point)>& at);
/// The same of a real figure, no coordinate of which is off by more than `error`.
SignVerdict verdict_on(const std::vector<StatedSign>& signs, const Figure& figure, double error);

/// The orientations whose determinants are 0 at these points up to rounding, by their numbers among the relations.
std::vector<int> flat_orientations(const std::vector<StatedSign>& signs, const ComplexPoints& points);

/// Segments at angles to others, the smaller number of a point first, whose equations ask for a negative length where the
/// points are: those of given lengths are positive, and beginning there the signs are those that bring each angle nearer
/// to its cosine.
std::vector<std::array<int, 2>> turned_segments(const ProblemStatement& problem, const ComplexPoints& points);

}  // namespace gcs
