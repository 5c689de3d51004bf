#pragma once
/// Krawczyk's operator in double precision with all rounding enclosed, for real boxes and for products of
/// complex discs. (Krawczyk 1969; Neumaier, Interval methods for systems of equations, 1990, chapter 5; Rump,
/// Verification methods, Acta Numerica 2010, section 13, for a priori bounds of rounding.)

#include <Eigen/Core>
#include <complex>
#include <limits>
#include <type_traits>

namespace gcs {

/// |x| of each entry, to a relative epsilon. Complex ones without the care of std::abs, which takes several times as long:
/// infinite where a square overflows, and larger by what squares that underflow may lack.
template <typename Derived>
Eigen::MatrixXd magnitudes(const Eigen::MatrixBase<Derived>& matrix) {
  if constexpr (std::is_same_v<typename Derived::Scalar, double>) {
    return matrix.cwiseAbs();
  } else {
    constexpr double underflow_of_root = 0x1p-536;
    return (matrix.array().abs2().sqrt() + underflow_of_root).matrix();
  }
}

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
/// box {x : |x_i − mid_i| ≤ radius_i}. Where it lies inside the box there is exactly one.
template <typename Scalar>
class KrawczykOperator {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  KrawczykOperator(const Matrix& inverse, const LinearisedSystem<Scalar>& f)
      : rounding_(4 * static_cast<double>(f.value.size() + 4) * epsilon),
        size_(magnitudes(inverse)),
        defect_(magnitudes(Matrix(Matrix::Identity(f.value.size(), f.value.size()) - inverse * f.jacobian))),
        jacobian_rounding_(rounding_ * magnitudes(f.jacobian)),
        move_(inverse * f.value),
        value_error_(size_ * (f.value_error + rounding_ * f.value.cwiseAbs())) {}

  /// |C| v.
  Eigen::VectorXd sizes_times(const Eigen::VectorXd& v) const { return size_ * v; }

  /// `jacobian_radius`: how far the entries of J move within the box.
  KrawczykImage<Scalar> image(const Eigen::MatrixXd& jacobian_radius, const Eigen::VectorXd& radius) const {
    const Eigen::VectorXd moved = jacobian_rounding_ * radius + (1 + rounding_) * (jacobian_radius * radius);
    return {move_, (1 + rounding_) * (defect_ * radius + size_ * moved + epsilon * radius + value_error_)};
  }

 private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();

  /// Of one or two nested scalar products of length m, complex ones included, relative to their terms.
  double rounding_;
  Eigen::MatrixXd size_;
  Eigen::MatrixXd defect_;
  Eigen::MatrixXd jacobian_rounding_;
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> move_;
  Eigen::VectorXd value_error_;
};

/// The operator on one box.
template <typename Scalar>
KrawczykImage<Scalar> krawczyk_image(const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& inverse,
                                     const LinearisedSystem<Scalar>& f,
                                     const Eigen::MatrixXd& jacobian_radius, const Eigen::VectorXd& radius) {
  return KrawczykOperator<Scalar>(inverse, f).image(jacobian_radius, radius);
}

}  // namespace gcs
