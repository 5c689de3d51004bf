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
/// box {x : |x_i − mid_i| ≤ radius_i}. Where it lies inside the box there is exactly one.
template <typename Scalar>
class KrawczykOperator {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  KrawczykOperator(const Matrix& inverse, const LinearisedSystem<Scalar>& f)
      : rounding_(4 * static_cast<double>(f.value.size() + 4) * epsilon),
        size_(inverse.cwiseAbs()),
        defect_((Matrix::Identity(f.value.size(), f.value.size()) - inverse * f.jacobian).cwiseAbs()),
        jacobian_rounding_(rounding_ * f.jacobian.cwiseAbs()),
        move_(inverse * f.value),
        value_error_(size_ * (f.value_error + rounding_ * f.value.cwiseAbs())) {}

  /// `jacobian_radius`: how far the entries of J move within the box.
  KrawczykImage<Scalar> image(const Eigen::MatrixXd& jacobian_radius, const Eigen::VectorXd& radius) const {
    const Eigen::Index m = radius.size();
    const Eigen::MatrixXd defect = defect_ +
                                   size_ * (jacobian_rounding_ + (1 + rounding_) * jacobian_radius) +
                                   epsilon * Eigen::MatrixXd::Identity(m, m);
    return {move_, (1 + rounding_) * (defect * radius + value_error_)};
  }

 private:
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();

  double rounding_;  ///< of a scalar product of length m, complex ones included, relative to its terms
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
