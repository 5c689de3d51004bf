#pragma once
/// Where a point is that hangs on d others: at given distances from d points, whose distances are given or
/// measured.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solvers/model/distance_system.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/rational.hpp"
#include "solvers/reduction/simplex_coordinates.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// The point and its mirror image, with −ζ.
struct HungPlace {
  SimplexCoordinates coordinates = SimplexCoordinates::Zero();
  bool is_real = false;   ///< where the base is
  bool is_flat = false;   ///< the point is its own mirror image: a double solution
  bool is_stiff = false;  ///< it is nearly flat, or its base nearly collinear
  std::string undecided;  ///< why it cannot be told where the point is, in words; else empty
};

/// Why nothing is placed on the part's base: its points are collinear, or so nearly that rounding decides;
/// empty when they are not. Precondition: the base is given.
std::string why_not_on_base(const Scene& scene, const Part& part);

/// The numbers of two points of a base, for its squared distances: in the plane the first pair.
inline constexpr std::array<std::array<int, 2>, 3> base_pairs{{{0, 1}, {0, 2}, {1, 2}}};
/// So many of them count.
constexpr int pairs_in(int dimension) { return dimension == 2 ? 1 : 3; }

/// Squared distances of a base's points, in the scene's unit, to a relative error.
struct MeasuredSquares {
  std::array<Rational, 3> squares;
  double error = 0;
};

/// On a base that is real: whether the point is real is proven; a point that is flat, or on a collinear base, to that
/// error is undecided, unless that is 0.
HungPlace precise_place(const Scene& scene, const Part& hung, const MeasuredSquares& base);

/// By the decimals of the file, exactly: whether it is real, and whether it is flat, is proven, and
/// coordinates are right to rounding. Precondition: the base is given.
HungPlace exact_place(const Scene& scene, const Part& hung);

/// For measured places of the base, in the scene's unit, in a solution of this condition number. What is
/// within a relative 1e-9, or 1000 times the errors of the base's edges, of a flat point or a collinear base
/// is undecided.
HungPlace measured_place(const Scene& scene, const Part& hung, const Simplex& base, double condition = 1);

/// Puts points where they are on a base that is placed. `positions`: of all points of the scene, in its unit.
class BasePlacer {
 public:
  /// Keeps a reference to the scene.
  explicit BasePlacer(const Scene& scene) : scene_(scene), squares_(target_squares(scene)) {}

  /// The points of a part at these coordinates in its base, or on the other side of it for side = −1, refined
  /// unless they are flat.
  void place(const Part& part, const std::vector<SimplexCoordinates>& coordinates, double side, bool is_flat,
             Simplex& positions) const;

  /// Newton's method for the points that a part places on its base, with residuals in double-double, as long as these
  /// become smaller; nothing is done where it does not converge.
  void refine(const Part& part, Simplex& positions) const;

 private:
  std::vector<int> constraints_of_points(const Part& part) const;
  /// Of each constraint's squared length.
  Eigen::VectorXcd excess(const std::vector<int>& constraints, const Simplex& positions) const;

  const Scene& scene_;
  std::vector<DoubleDouble> squares_;  ///< of the lengths
};

}  // namespace gcs
