#pragma once
/// The equations of a scene of points around figures of which some points are at infinity.
///
/// An escaping point is p = o + (u/w) n + q, o one of the points x that stay and are next to escaping ones. For each of
/// these and each p there is another unknown t, and
///     n·n = 0,   n·(x − o) = w t,   n·q = w t.
/// The distances between escaping points, and of one from a point that stays, are then free of 1/w:
///     |p − p'|² = |q − q'|² + 2(u − u')(t − t'),   |p − x|² = |q − (x − o)|² + 2u (t_p − t_x).
/// A figure leaves open how long n is, and u and t: of n and of q a linear form is given, u is 1 at a first point; and n
/// may turn, unless t is 0 at o and at the next corner of the walk, at a given distance from it. So there are as many
/// equations as unknowns. Where w ≠ 0 they say what the distances say; where w = 0 all x next to the escaping points lie in
/// an isotropic plane, and one of the distances along a closed walk of these follows from the others (escapes.hpp).

#include <algorithm>
#include <vector>

#include "solvers/certificates/escapes.hpp"
#include "solvers/elements/element_forms.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/enclosure.hpp"

namespace gcs {

class EquationsAtInfinity {
 public:
  /// Whether the points that escape are different ones, none of the frame, and not joined to those of another escape, and
  /// each walk has an edge that is in no other one, and goes across none but those of other escapes.
  static bool know(const Scene& scene, const Reference& frame, const std::vector<Escape>& escapes);

  /// Precondition: know(scene, frame, escapes), points in space. Keeps a reference to the scene.
  EquationsAtInfinity(const Scene& scene, const Reference& frame, std::vector<Escape> escapes);

  /// w = 0 for every escape, without one edge of each walk.
  QuadraticSystem at_infinity() const { return system(false); }
  /// All equations. The unknowns are those of at_infinity() and then each w.
  QuadraticSystem around() const { return system(true); }
  /// The unknowns of at_infinity() of the figure that is next to one in the frame; not finite where there is none.
  std::vector<std::complex<double>> unknowns_near(const ComplexPoints& points) const;
  /// Whether the solution of at_infinity() in an enclosure is one of all equations, with w = 0, and with no smaller set of
  /// points at infinity.
  bool holds_solution(const Enclosure& solution) const;

  /// What tells solutions apart comes first among the unknowns: the coordinates of the points that stay, and for each
  /// escape a sum of squared distances of those that escape. Together they have this mirror.
  const SignMasks& mirror() const { return mirror_; }
  const std::vector<Escape>& escapes() const { return escapes_; }
  /// Whether the same points escape together: the marks of both mean the same. Precondition: of one scene and frame.
  bool is_escape_of_same_points(const EquationsAtInfinity& other) const {
    return std::ranges::equal(escapes_, other.escapes_, {}, &Escape::points, &Escape::points);
  }

 private:
  /// Numbers of unknowns, −1: it is 0 (or, of u, 1).
  struct Escaping {
    int escape = -1;  ///< −1: the point stays
    int q = -1;       ///< the first of three
    int u = -1;
  };

  bool stays(int point) const { return of(point).escape < 0; }
  const Escaping& of(int point) const { return escaping_[static_cast<std::size_t>(point)]; }
  bool is_given(int a, int b) const;
  int origin(int escape) const { return escapes_[static_cast<std::size_t>(escape)].walk.corners[0]; }
  VectorForm place(int point) const;
  VectorForm direction(int escape) const;
  VectorForm offset(int point, int escape) const;
  LinearForm along(int point) const;
  LinearForm across(int point, int escape) const;
  int inverse_size(int escape) const { return unknowns_ + escape; }
  int across_unknown(int point, int escape) const;
  void add_unknowns(int escape);
  QuadraticSystem system(bool is_around) const;
  Equation distance(int a, int b) const;
  void add_planes(int escape, bool is_around, QuadraticSystem& system) const;
  QuadraticEquation summed_distances(int escape) const;

  const Scene& scene_;
  DistanceSystem frame_;
  Neighbours joined_;
  std::vector<Escape> escapes_;
  std::vector<int> left_out_;  ///< an edge of each walk
  std::vector<int> place_;     ///< of each coordinate of a point that stays its unknown, −1: 0
  std::vector<Escaping> escaping_;
  std::vector<int> direction_;  ///< of each escape the first unknown of n
  std::vector<int> sum_;        ///< and that of the summed distances
  std::vector<std::vector<int>>
      across_;  ///< of each escape, of each point the unknown t, −1: 0, or there is none
  SignMasks mirror_;
  int unknowns_ = 0;  ///< without the w
};

}  // namespace gcs
