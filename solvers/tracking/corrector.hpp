#pragma once
/// When a simplified Newton iteration may stop, and when it must be refused.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {

/// Fed with the sizes of successive corrections. With the matrix frozen they fall by a constant factor, which
/// is about the distance moved divided by the distance at which Newton would leave the path, and also the
/// relative error of whatever is computed with the frozen matrix afterwards.
class CorrectorTest {
 public:
  /// `stalled`: to be refused, unless it is the rounding of the residuals, amplified by an ill-conditioned Jacobian, that
  /// keeps small corrections from falling. Residuals in double-double tell, and the coordinates may stay rounded: what
  /// that changes the next correction undoes.
  enum class Verdict { again, settled, stalled, refuse };

  /// A predictor that is worse than its tolerance by this factor is not trusted.
  static constexpr double first_limit = 100;
  /// A tangent that is off by more tolerances than this is computed anew.
  static constexpr double stale_limit = 10;

  /// `tolerance`: the tracker's, in the unit of the coordinates. `is_wide`: residuals are in double-double.
  explicit CorrectorTest(double tolerance, bool is_wide = false) : tolerance_(tolerance), is_wide_(is_wide) {}

  Verdict judge(double correction, double size) {
    const double noise = noise_at(size);
    const Verdict no =
        !is_wide_ && correction <= rounding_limit * std::max(1.0, size) ? Verdict::stalled : Verdict::refuse;
    if (!(correction <= first_limit * tolerance_)) return no;
    if (correction <= noise) return Verdict::settled;
    if (previous_ > 0) {
      const double factor = correction / previous_;
      if (factor > contraction) return !is_wide_ && correction <= noise_limit * noise ? Verdict::settled : no;
      factor_ = std::max(factor_, factor);
      if (correction * factor <= noise) return Verdict::settled;
    }
    previous_ = correction;
    return Verdict::again;
  }

  /// After `stalled`: what is judged from now on are corrections from residuals in double-double.
  void widen() {
    is_wide_ = true;
    previous_ = 0;
  }
  bool is_wide() const { return is_wide_; }

  /// A correction up to this may be left at coordinates of that size: rounding, amplified by the condition of
  /// the Jacobian.
  static double settled_limit(double size) { return noise_limit * noise_at(size); }

  /// The same for residuals in double-double.
  static double wide_limit(double size) { return noise_at(size); }

  /// Whether arcs of S are told apart where the rounding of the equations moves a point by so much: that is the roundoff
  /// over their gap, about. Of arcs nearer than a few 1e-7 lengths a few hundred roundings off have others.
  static bool are_arcs_apart(double moved, double size) {
    return moved <= rounding_limit * std::max(1.0, size);
  }

  /// The matrix has to be renewed before a tangent is computed with it: a stale tangent would be off by more
  /// than the tolerance per step.
  bool matrix_is_stale() const { return factor_ > stale_limit * tolerance_; }

 private:
  static double noise_at(double size) {
    return 64 * std::numeric_limits<double>::epsilon() * std::max(1.0, size);
  }

  static constexpr double contraction = 0.1;
  /// Rounding amplified by a condition number of the Jacobian up to 1e3·64.
  static constexpr double noise_limit = 1e3;
  static constexpr double rounding_limit = 3e-10;
  double tolerance_;
  bool is_wide_;
  double previous_ = 0;
  double factor_ = 0;
};

/// What rounding may leave of equation i, whose gradient has this length, at coordinates of that size. The signs and sizes
/// of all have no pattern to which the image of a nearly singular Jacobian could be orthogonal.
inline double rounding_of_equation(Eigen::Index i, double gradient, double size) {
  constexpr double golden = 0.6180339887498949;
  const double multiple = golden * static_cast<double>(i + 1);
  const double share = multiple - std::floor(multiple) - 0.5;
  return std::numeric_limits<double>::epsilon() * gradient * std::max(1.0, size) * share;
}

/// The sign of det B, B = [F_y; tangent]. On an arc of a regular curve F = 0 followed in one direction it is
/// the same everywhere. Where two arcs nearly cross it differs between what lies straight ahead, which is
/// the other arc's, and what the arc bends to.
inline int determinant_sign(const Eigen::PartialPivLU<Eigen::MatrixXd>& lu) {
  const auto negative = (lu.matrixLU().diagonal().array() < 0).count();
  return (negative % 2 == 0 ? 1 : -1) * static_cast<int>(lu.permutationP().determinant());
}

}  // namespace gcs
