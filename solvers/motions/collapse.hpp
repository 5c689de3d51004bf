#pragma once
/// Figures in which points coincide, or bars of one length are parallel: there some of the distances say the same, and
/// what is left of them may leave the figure loose.
///
/// Such coincidences are linear: p_a = p_b, or p_a − p_b = ±(p_c − p_d). On the linear space that they leave, constraints of
/// equal length between differences that are equal up to the sign are one equation. What solves the linear equations and
/// one of each such set of distances solves the scene, exactly. Of fewer equations than unknowns every component of the
/// solutions has dimension unknowns − equations at least (Krull's height theorem): no solution there is isolated.

#include <array>
#include <optional>
#include <vector>

#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/rational.hpp"

namespace gcs {

struct Collapse {
  std::vector<std::array<int, 2>> coincident;  ///< points
  std::vector<std::array<int, 2>> parallel;    ///< constraints of one length whose bars are parallel
  /// In the unknowns of the scene: independent linear equations, and the different distances.
  QuadraticSystem equations;

  /// The least dimension of a component of its solutions, if there are any.
  int looseness() const { return equations.unknowns - static_cast<int>(equations.equations.size()); }
};

/// Looks for coincidences in figures of one scene: in most there are none, which is told by their coordinates alone.
class CollapseSearch {
 public:
  /// Keeps a reference to `system`, which is the scene's; `distances` are its equations with the exact numbers, one for each
  /// constraint. Precondition: points and distances alone, no given positions.
  CollapseSearch(const Scene& scene, const DistanceSystem& system, QuadraticSystem distances);

  const QuadraticSystem& distances() const { return distances_; }
  /// The coincidences of `points`, as far as `tolerance`, a length, tells; without parallel bars if not asked for. Nothing
  /// where there are none, or distances contradict them.
  std::optional<Collapse> at(const ComplexPoints& points, double tolerance, bool with_parallel_bars) const;

 private:
  const DistanceSystem& system_;
  QuadraticSystem distances_;
  std::vector<Rational> squares_;               ///< of the lengths
  std::vector<std::array<int, 2>> equal_bars_;  ///< constraints of one length
};

}  // namespace gcs
