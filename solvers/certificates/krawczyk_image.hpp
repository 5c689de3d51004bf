#pragma once
/// Krawczyk's operator in double precision with all rounding enclosed, for real boxes and for products of
/// complex discs. (Krawczyk 1969; Neumaier, Interval methods for systems of equations, 1990, chapter 5; Rump,
/// Verification methods, Acta Numerica 2010, section 13, for a priori bounds of rounding.)

#include <Eigen/Core>
#include <complex>
#include <limits>

namespace gcs {

/// f at the middle of a box and its Jacobian there and over the box. Scalar: double or std::complex<double>.
template <typename Scalar>
struct LinearisedSystem {
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> value;                  ///< f(mid)
  Eigen::VectorXd value_error;                                     ///< bound on the error of each |value_i|
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> jacobian;  ///< at mid, right to a relative epsilon
};

/// All mid − move + e with |e_i| ≤ spread_i.
template <typename Scalar>
struct KrawczykImage {
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> move;
  Eigen::VectorXd spread;

  /// At most how far a point of the image is from the middle.
  Eigen::VectorXd reach() const {
    constexpr double margin = 1 + 4 * std::numeric_limits<double>::epsilon();
    return (move.cwiseAbs() * margin + spread) * margin;
  }
  /// Whether it lies inside the box of this radius and the same middle, or outside of it.
  bool is_inside(const Eigen::VectorXd& radius) const { return (reach().array() < radius.array()).all(); }
  bool misses(const Eigen::VectorXd& radius) const {
    constexpr double margin = 1 + 4 * std::numeric_limits<double>::epsilon();
    return (move.cwiseAbs().array() > (spread + radius).array() * margin).any();
  }
};

/// mid − C f(mid) + (I − C J(box))(box − mid) for C = `inverse`, any matrix: it holds every zero of f in the
/// box {x : |x_i − mid_i| ≤ radius_i}. Where it lies inside the box there is exactly one. `jacobian_radius`:
/// how far the entries of J move within the box.
template <typename Scalar>
KrawczykImage<Scalar> krawczyk_image(const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& inverse,
                                     const LinearisedSystem<Scalar>& f,
                                     const Eigen::MatrixXd& jacobian_radius, const Eigen::VectorXd& radius) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const Eigen::Index m = radius.size();
  // Of a scalar product of length m, complex ones included, relative to its terms.
  const double rounding = 4 * static_cast<double>(m + 4) * epsilon;
  const Eigen::MatrixXd size = inverse.cwiseAbs();
  const Eigen::MatrixXd defect =
      (Matrix::Identity(m, m) - inverse * f.jacobian).cwiseAbs() +
      size * (rounding * f.jacobian.cwiseAbs() + (1 + rounding) * jacobian_radius) +
      epsilon * Eigen::MatrixXd::Identity(m, m);
  KrawczykImage<Scalar> image;
  image.move = inverse * f.value;
  image.spread = (1 + rounding) * (defect * radius + size * (f.value_error + rounding * f.value.cwiseAbs()));
  return image;
}

}  // namespace gcs
