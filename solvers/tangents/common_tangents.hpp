#pragma once
/// All common tangents of four spheres, complex and multiple ones included, without an initial guess.

#include <complex>
#include <vector>

#include "solvers/tangents/tangent_equations.hpp"
#include "solvers/work.hpp"

namespace gcs {

using ComplexTangent = Tangent<std::complex<double>>;

/// Two lines that are not further apart (see `difference`) are one: Newton's method has brought simple ones
/// to 1e-14.
inline constexpr double same_line = 1e-9;

/// Largest difference of two lines' directions or points relative to their size; u and −u are the same.
/// Precondition: points nearest to the origin.
double difference(const ComplexTangent& a, const ComplexTangent& b);

ComplexTangent conjugate(const ComplexTangent& line);
/// The line of the real parts.
ComplexTangent real_part(const ComplexTangent& line);

struct FoundTangent {
  ComplexTangent line;  ///< imaginary parts are 0 exactly when it is real
  bool is_real = false;
  int multiplicity = 1;
};

struct CommonTangents {
  std::vector<FoundTangent> lines;
  int at_infinity = 0;           ///< isotropic directions, with multiplicities
  bool infinitely_many = false;  ///< to rounding

  /// Of the twelve, with multiplicities.
  int accounted_for() const;
};

/// Joint eigenvalues (tangent_algebra.hpp), simple ones polished by Newton's method, multiple ones found as
/// the means of clusters (eigenvalue_clusters.hpp). Complex lines come with their conjugates. Precondition:
/// the centres are not collinear; distances are of order 1. Adds to `work`.
CommonTangents common_tangents(const FourSpheres& spheres, WorkCounters& work);

}  // namespace gcs
