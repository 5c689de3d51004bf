#pragma once
/// Systems Σ (u − v)² + Σ c·w = A_e in C^n, where u and w are unknowns and v is another one or a constant:
/// the distance equations of a scene in the coordinates of its frame, which have no linear terms c·w, with
/// the squared lengths A_e as parameters.
///
/// The value is f_e(x; A) = (Σ (u − v)² + Σ c·w − A_e)/2, so that a row of the Jacobian consists of the
/// differences themselves and of constants.

#include <complex>
#include <random>
#include <vector>

namespace gcs {

class DistanceSystem;

/// x[minuend] − x[subtrahend], or x[minuend] − constant where subtrahend is −1.
struct Difference {
  int minuend = 0;
  int subtrahend = -1;
  double constant = 0;
};

/// coefficient·x[unknown]
struct LinearTerm {
  int unknown = 0;
  std::complex<double> coefficient;
};

/// No equation has an unknown both in a difference and in a linear term.
struct SquareSystem {
  int unknowns = 0;                     ///< and as many equations
  std::vector<Difference> differences;  ///< those of equation e are first[e] … first[e + 1] − 1
  std::vector<int> first{0};
  std::vector<LinearTerm> linear;  ///< those of equation e are first_linear[e] … first_linear[e + 1] − 1
  std::vector<int> first_linear{0};
  std::vector<double> given;  ///< what edges between given coordinates add to Σ (u − v)², one per equation

  int equations() const { return static_cast<int>(given.size()); }
  /// Appends Σ (u − v)² + Σ c·w + constant.
  void add_equation(const std::vector<Difference>& squares, const std::vector<LinearTerm>& terms,
                    double constant);
};

/// Precondition: the scene's points have no line but one that is free, as DistanceSystem.
SquareSystem square_system(const DistanceSystem& system);

using ComplexVectorX = std::vector<std::complex<double>>;

/// Σ (u − v)² + Σ c·w of every equation: the parameters A for which x is a zero.
ComplexVectorX squares_at(const SquareSystem& system, const ComplexVectorX& x);

/// Whether rounding explains what x misses of these parameters: |Σ (u − v)² + Σ c·w − A| ≤ 2·√|A|·δ + δ² in
/// every equation, for an uncertainty δ of 1e-13 of the largest |x_i|.
bool is_zero_at(const SquareSystem& system, const ComplexVectorX& squares, const ComplexVectorX& x);

/// df_e/dx_i at x, row by row.
ComplexVectorX jacobian_at(const SquareSystem& system, const ComplexVectorX& x);

/// The largest |x_i|, and the largest |x_i − y_i|.
double largest(const ComplexVectorX& x);
double distance(const ComplexVectorX& x, const ComplexVectorX& y);

/// Normal distribution of variance 1 in the real and in the imaginary part.
ComplexVectorX random_complex_vector(int size, std::mt19937_64& random);

}  // namespace gcs
