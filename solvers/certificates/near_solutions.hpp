#pragma once
/// All solutions next to a point where the Jacobian of a quadratic system is nearly singular: a few simple
/// ones that lie so near each other that Newton's method in doubles takes one for another, or a multiple one.
///
/// Newton's method from the point, and from others at 1e-9 to 1e-4 of the unknowns' size around it, each
/// together with the opposite one: of two solutions either is nearer to one of these. In balls of 256 bits it
/// reaches simple solutions down to some 1e-30 of each other, which Krawczyk's test then proves to exist and
/// to be different. Towards a double one it goes on by half of the way a step, and the residuals
/// fall to nothing; one of a higher multiplicity is found along the curve of ball_cluster.hpp, if it can be.

#include <complex>
#include <optional>
#include <stop_token>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/model/ball_krawczyk.hpp"

namespace gcs {

/// A point with solutions next to it that doubles do not tell apart.
struct NearlySingular {
  std::vector<std::complex<double>> x;  ///< their unknowns, to 1e-3 or better
  int solutions = 0;                    ///< how many there should be, multiplicities included
};

struct MultipleSolution {
  std::vector<std::complex<double>> x;
  bool is_real = false;  ///< the real parts of x are as good a solution; `x` is real then
  int multiplicity = 0;  ///< of all points together that lead to it
};

struct NearSolutions {
  /// Proven to exist, each alone in its enclosure, to be different from each other, mirror images too, and to
  /// be real or not to be.
  std::vector<Certificate> simple;
  /// Residuals are at most 1e-60 of the size of their terms: multiple solutions, or several that lengths of
  /// as many digits do not tell apart.
  std::vector<MultipleSolution> multiple;

  /// With multiplicities.
  int count() const;
};

/// The largest |a_i − b_i|. Precondition: as many numbers.
double largest_difference(const std::vector<std::complex<double>>& a,
                          const std::vector<std::complex<double>>& b);

/// The solutions next to these points, at most as many as they should be; where these are fewer than
/// `expected`, all that are found. Precondition: unknowns are of order 1, coefficients real.
NearSolutions solutions_near(const QuadraticSystem& system, const std::vector<NearlySingular>& points,
                             int expected, const std::stop_token& stop);

}  // namespace gcs
