#pragma once
/// The equations of a point distance problem in the free coordinates of its frame, [I] §2.1–2.2:
/// f_i(x, a) = (|p_j − p_k|² − a_i²)/2, whose derivative by p_j is simply p_j − p_k. It has the same zeros,
/// tangents and arc length as the unsquared form |p_j − p_k| − a_i. A line is the x-axis of the frame, and a
/// point at distance a_i from it has the equation (y² + z² − a_i²)/2.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/double_double.hpp"

namespace gcs {

class DistanceSystem {
 public:
  /// Precondition: at most one line, which is not fixed.
  explicit DistanceSystem(const Scene& scene);
  /// The same in another frame, which puts a line on the x-axis if there is one.
  DistanceSystem(const Scene& scene, const Reference& reference);

  /// The frame of the coordinates: the scene's, unless another was given, or there is a line and the scene's
  /// does not put it on the x-axis (then see line_reference).
  const Reference& reference() const { return reference_; }
  int dimension() const { return dimension_; }
  int point_count() const { return point_count_; }
  int unknowns() const { return unknowns_; }
  int equations() const { return static_cast<int>(edges_.size()); }
  /// Two points, or a point and the line, numbered as in DistanceConstraint; the line comes second.
  const std::vector<std::array<int, 2>>& edges() const { return edges_; }
  bool is_line(int entity) const { return entity >= point_count_; }
  /// What the frame or the file gives for coordinate `axis` of a point.
  double given_coordinate(int point, int axis) const { return fixed_coordinates_(axis, point); }
  /// At least how far that double is from the file's decimal; 0 for an unknown and for the line.
  double coordinate_error(int entity, int axis) const {
    return is_line(entity) ? 0 : coordinate_errors_(axis, entity);
  }
  /// Index of the unknown that is coordinate `axis` of `entity`, or −1 when the frame fixes it.
  int unknown(int entity, int axis) const { return unknown_[3 * entity + axis]; }

  /// Free coordinates of a figure that is in the frame.
  Eigen::VectorXd coordinates(const Figure& figure) const;
  /// The figure of these free coordinates.
  Figure figure(const Eigen::Ref<const Eigen::VectorXd>& x) const;
  /// Writes x into `points` (3 × point_count), which must already hold the coordinates that the frame fixes.
  void place(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Matrix3Xd& points) const;

  /// The squared distance of edge `e` in double-double.
  DoubleDouble squared_length(const Eigen::Matrix3Xd& points, int e) const;
  /// f_i at the squared lengths a_i² in `squares`, one per equation, rounded after the subtraction.
  void residual(const Eigen::Matrix3Xd& points, const std::vector<DoubleDouble>& squares,
                Eigen::Ref<Eigen::VectorXd> f) const;
  /// df_i/dx: row i of `jacobian` (equations × at least unknowns; columns beyond are left alone).
  void jacobian(const Eigen::Matrix3Xd& points, Eigen::Ref<Eigen::MatrixXd> jacobian) const;

 private:
  std::array<Eigen::Vector3d, 2> ends(const Eigen::Matrix3Xd& points, int e) const;

  Reference reference_;
  int dimension_;
  int point_count_;
  bool has_line_;
  int unknowns_ = 0;
  std::vector<std::array<int, 2>> edges_;
  std::vector<int> unknown_;
  Eigen::Matrix3Xd fixed_coordinates_;
  Eigen::Matrix3Xd coordinate_errors_;
};

/// The axis of every unknown whose sign may be changed together with the others of that axis: −1 where
/// positions are given, since nothing is divided out then.
std::vector<int> mirror_axes(const Scene& scene, const DistanceSystem& system);

/// Outcome of Newton's method at fixed lengths.
struct Refinement {
  bool converged = false;
  int iterations = 0;
  /// 2-norm of the last step, in the scene's unit: an estimate of the error left.
  double last_correction = 0;
};

/// a² in double-double, for every constraint at its target length, from the exact decimal of the file: right
/// to 2^-104 relative.
std::vector<DoubleDouble> target_squares(const Scene& scene);

/// Newton's method on f(x) = 0 at the given squared lengths, with residuals in double-double, so that what is
/// left is the rounding of x itself. Stops when a correction is below 4 ulp of the largest coordinate or no
/// longer falls. `x` is improved in place; on failure it is left as it came.
Refinement refine(const DistanceSystem& system, const std::vector<DoubleDouble>& squares, Eigen::VectorXd& x);

}  // namespace gcs
