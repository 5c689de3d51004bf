#pragma once
/// Where the exact path S begins and how its lengths run, for the exact decimals of the file.
///
/// The scene holds doubles: a decimal's nearest one, and what floating point makes of a sketch moved into the
/// frame. Everything that is proven of S is proven for all paths whose data lie in the enclosures given here,
/// and the exact data are among them.

#include <Eigen/Core>
#include <vector>

#include "solvers/model/distance_system.hpp"

namespace gcs {

/// More than what rounding takes from a sum of up to 2000 numbers of one sign.
inline constexpr double round_up = 1 + 0x1p-40;

/// All vectors y with |y_i − mid_i| ≤ radius_i.
struct PointBox {
  Eigen::VectorXd mid;
  Eigen::VectorXd radius;
};

/// a(t) with bounds on how far the exact parameters are from those of `path`, in the scene's unit.
struct EnclosedLength {
  LengthPath path;
  double sketch_error = 0;
  double target_error = 0;
  double bend_error = 0;
  std::vector<double> higher_errors{};  ///< one for each of path.higher
  bool is_plain = false;                ///< the equation has a(t) itself, not half its square
};

struct PathData {
  PointBox start;  ///< (X, t) of the sketch in the frame of the scene; t = 0 exactly
  std::vector<EnclosedLength> lengths;
  bool is_finite() const;
};

/// How far a coefficient of a file may be from its double, for the bends.
void set_bend_errors(const Scene& scene, EnclosedLength& length);

/// The sketch is moved into the frame in affine forms without symbols, that is, in intervals. Where the
/// sketch does not determine the frame (its reference points coincide or lie on one line) the result is not
/// finite. Precondition: the scene has a sketch, no lines and nothing fixed.
PathData enclose_path_data(const Scene& scene, const DistanceSystem& system);

}  // namespace gcs
