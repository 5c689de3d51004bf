#pragma once
/// Common tangents that were found, by whichever method.

#include <complex>
#include <optional>
#include <vector>

#include "solvers/tangents/tangent_equations.hpp"

namespace gcs {

using ComplexTangent = Tangent<std::complex<double>>;

/// Two lines that are not further apart (see `difference`) are one: Newton's method has brought simple ones
/// to 1e-14.
inline constexpr double same_line = 1e-9;

/// Where nearness_to_isotropic is not above it a line counts as one at infinity: the simple solutions' error
/// is 1e-13 as a rule, and a line with a direction as near to isotropic as this is 1e10 away.
inline constexpr double isotropic = 1e-10;

/// Largest difference of two lines' directions or points relative to their size; u and −u are the same.
/// Precondition: points nearest to the origin.
double difference(const ComplexTangent& a, const ComplexTangent& b);

ComplexTangent conjugate(const ComplexTangent& line);
/// The line of the real parts.
ComplexTangent real_part(const ComplexTangent& line);

/// No further from its conjugate than 1e-7, the root of the rounding: a multiple line that is real, or a
/// simple one that Newton's method in R has to confirm.
bool is_nearly_real(const ComplexTangent& line);

struct FoundTangent {
  ComplexTangent line;  ///< imaginary parts are 0 exactly when it is real
  bool is_real = false;
  int multiplicity = 1;
};

/// The multiple solution near `line`, or the middle of as many simple ones that doubles hardly tell apart:
/// its real part where `is_real`, settled (tangent_refinement.hpp). Nothing where that is no common tangent
/// to rounding.
std::optional<FoundTangent> multiple_tangent(const FourSpheres& spheres, const ComplexTangent& line,
                                             bool is_real, int multiplicity);

struct FoundTangents {
  std::vector<FoundTangent> lines;
  int at_infinity = 0;  ///< isotropic directions, with multiplicities

  /// With its conjugate where it is not real.
  void add_simple(const ComplexTangent& line);
  /// Of the twelve, with multiplicities.
  int accounted_for() const;
  /// Twelve, none of them at infinity.
  bool are_all_simple() const;
  /// More are accounted for, or as many as more different lines: rounding takes lines that are near to each
  /// other, or to infinity, for a multiple one, but makes no simple ones of it.
  bool tell_more_than(const FoundTangents& other) const;
  /// The number of this line in `lines`, or nothing.
  std::optional<std::size_t> find(const ComplexTangent& line) const;
};

}  // namespace gcs
