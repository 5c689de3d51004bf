#pragma once
/// When a simplified Newton iteration may stop, and when it must be refused.

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace gcs {

/// Fed with the sizes of successive corrections. With the matrix frozen they fall by a constant factor, which
/// is about the distance moved divided by the distance at which Newton would leave the path, and also the
/// relative error of whatever is computed with the frozen matrix afterwards.
class CorrectorTest {
 public:
  enum class Verdict { again, settled, refuse };

  /// A predictor that is worse than its tolerance by this factor is not trusted.
  static constexpr double first_limit = 100;

  /// `tolerance`: the tracker's, in the unit of the coordinates.
  explicit CorrectorTest(double tolerance) : tolerance_(tolerance) {}

  Verdict judge(double correction, double size) {
    const double noise = noise_at(size);
    if (!(correction <= first_limit * tolerance_)) return Verdict::refuse;
    if (correction <= noise) return Verdict::settled;
    if (previous_ > 0) {
      const double factor = correction / previous_;
      if (factor > contraction) return correction <= noise_limit * noise ? Verdict::settled : Verdict::refuse;
      factor_ = std::max(factor_, factor);
      if (correction * factor <= noise) return Verdict::settled;
    }
    previous_ = correction;
    return Verdict::again;
  }

  /// A correction up to this may be left at coordinates of that size: rounding, amplified by the condition of
  /// the Jacobian.
  static double settled_limit(double size) { return noise_limit * noise_at(size); }

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
  static constexpr double stale_limit = 10;
  double tolerance_;
  double previous_ = 0;
  double factor_ = 0;
};

/// The sign of det B, B = [F_y; tangent]. On an arc of a regular curve F = 0 followed in one direction it is
/// the same everywhere. Where two arcs nearly cross it differs between what lies straight ahead, which is
/// the other arc's, and what the arc bends to.
inline int determinant_sign(const Eigen::PartialPivLU<Eigen::MatrixXd>& lu) {
  const auto negative = (lu.matrixLU().diagonal().array() < 0).count();
  return (negative % 2 == 0 ? 1 : -1) * static_cast<int>(lu.permutationP().determinant());
}

}  // namespace gcs
