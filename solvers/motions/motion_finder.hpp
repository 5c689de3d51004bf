#pragma once
/// Which solutions of a scene of points are not isolated because distances say the same there, with proof.
///
/// A singular end of a path shows the coincidences (collapse.hpp). A solution next to it of the equations that are left, as
/// many unknowns as are too many held at their values, is proven by Krawczyk's test; that suffices for a component of
/// dimension 1 or more through it. A real one is sought from starts at random, and a curve is followed from there
/// (figure_motion.hpp). The dimension is exact where a minor of the scene's own Jacobian of the complementary order is proven
/// not to vanish.
///
/// Scenes move for other reasons too: apparent_motion.hpp.

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/motions/collapse.hpp"

namespace gcs {

class MotionFinder {
 public:
  /// Keeps references.
  MotionFinder(const Scene& scene, const DistanceSystem& system, std::mt19937_64& random);

  /// What coincides at x, of the unknowns of the system, if that leaves the scene loose: nearly so, it may be, where x is
  /// not singular. Nothing for scenes of more than points and distances, or with given positions. `uncertainty` of x,
  /// relative to 1 + its largest entry.
  std::optional<Collapse> loose_at(const std::vector<std::complex<double>>& x, double uncertainty) const;
  /// Whether the solution next to x is proven to lie on the motion that is loose there; a new one is remembered.
  bool lies_on_motion(const Collapse& loose, const std::vector<std::complex<double>>& x);

  /// From the real solution next to x or, if there is none, from others; one that is found is remembered.
  void look_for_apparent_motion(const std::vector<std::complex<double>>& x);

  const std::vector<Motion>& motions() const { return motions_; }

 private:
  using Point = std::vector<std::complex<double>>;

  /// A proven solution of a loose system.
  struct LoosePoint {
    Point x;
    Enclosure enclosure;
    bool is_real = false;
  };

  std::optional<LoosePoint> proven(const QuadraticSystem& loose, const Point& start) const;
  std::optional<LoosePoint> proven_near(const QuadraticSystem& loose, const Point& x);
  std::optional<LoosePoint> proven_real(const QuadraticSystem& loose);
  bool has_corank(const LoosePoint& point, int dimension) const;
  void add_motion(const Collapse& collapse, const LoosePoint& near);

  const Scene& scene_;
  const DistanceSystem& system_;
  std::mt19937_64& random_;
  std::optional<CollapseSearch> search_;  ///< for the scenes that it is asked of
  std::vector<Motion> motions_;
};

/// Which points coincide and which bars are parallel: "p1 = p2, a3 ∥ a5".
std::string place_in_words(const ProblemStatement& problem, const Motion& motion);

/// What is proven to move and why, likewise.
std::string in_words(const ProblemStatement& problem, const std::vector<Motion>& motions);

}  // namespace gcs
