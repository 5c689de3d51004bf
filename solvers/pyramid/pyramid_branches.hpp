#pragma once
/// A pyramid whose side d34 is left open: all its placements at a given angle of p1 around the line.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "solvers/pyramid/pyramid.hpp"
#include "solvers/scanning/step_places.hpp"

namespace gcs {

/// One placement of p1 … p4. Frame: the line is the x-axis, the apex is (0, 0, r_5).
struct PyramidBranch {
  std::array<Eigen::Vector3d, 4> cycle;

  /// d34(θ) of this branch, in the unit of the pyramid's lengths.
  double gap() const { return (cycle[2] - cycle[3]).norm(); }
};

/// Evaluates the branches at any angle, Hoffmann and Yuan 2000, section 4.3. p1 comes from eq. 10 with both
/// signs of x1; p2, p4 (from p1 and the apex) and p3 (from p2 and the apex) lie each on a circle that meets
/// the cylinder around the line in up to four points: up to 128 branches. A point of the circle is found by
/// its angle on the circle; the paper's ellipse in the circle's plane (eqs. 11–13) does not exist where
/// x1 = 0.
class PyramidBranches {
 public:
  explicit PyramidBranches(const Pyramid& pyramid);

  /// The branches at θ, in radians: the angle of p1 around the line, from the xy-plane. Those with x1 > 0
  /// first; where x1 = 0, each once. Empty where p1 does not exist or a triangle of the pyramid does not.
  std::vector<PyramidBranch> at(double theta) const;

 private:
  void append(const Eigen::Vector3d& p1, std::vector<PyramidBranch>& branches) const;
  /// Where the circle around the axis from the apex to `hinge` meets the cylinder of cycle[point].
  Places places(int point, const Eigen::Vector3d& hinge, double hinge_length,
                const std::optional<HingeCircle>& circle) const;

  Pyramid pyramid_;
  Eigen::Vector3d apex_;
  std::optional<HingeCircle> second_, third_, fourth_;
};

/// The whole scene of a branch: the points of the pyramid and its line. In the branch's frame.
Figure figure_of(const Pyramid& pyramid, const PyramidBranch& branch);

/// A point of the curve d34(θ).
struct GapSample {
  double theta = 0;  ///< degrees
  double gap = 0;    ///< in the unit of the pyramid's lengths
};

/// The curve over all branches at `count` angles, evenly spaced over a full turn from 0° on.
std::vector<GapSample> sample_gap_curve(const Pyramid& pyramid, int count);

}  // namespace gcs
