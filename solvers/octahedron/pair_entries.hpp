#pragma once
/// What is given of two elements, points or planes: of two points their squared distance, of a point p and a plane
/// n·x = h the signed distance n·p − h, of two planes the cosine n·m.
///
/// These are, but for a factor −1/2 of squared distances, the inner products of vectors of R^{4,1}: with e·e = 0 a point
/// is a vector P with P·P = 0 and P·e = 1, a plane one with N·N = 1 and N·e = 0. So the matrix of these products of any
/// elements, with e as a further row and column (1 for points, 0 for planes), has rank 5 at most: of points it is that of
/// Cayley and Menger. Michelucci, Foufou 2004; Yang 2002.

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/exact_number.hpp"
#include "solvers/numeric/rational.hpp"

namespace gcs {

/// A constraint as an entry of that matrix.
struct GivenPair {
  std::array<int, 2> between{};
  ExactNumber entry;
};

/// The pair that a relation gives: the distance of a point from a plane, 0 where it is on it, or the cosine of two planes,
/// 0 where they are perpendicular. Nothing of any other relation.
std::optional<GivenPair> given_pair(const Scene& scene, const Relation& relation);

/// Entries by the elements' numbers, in the scene's unit: 0 where nothing is given, 1 of a plane and itself.
class PairEntries {
 public:
  explicit PairEntries(const Scene& scene);
  double operator()(int p, int q) const { return matrix_(p, q); }
  bool is_plane(int element) const { return element >= first_plane_; }

 private:
  Eigen::MatrixXd matrix_;
  int first_plane_;
};

/// The same exactly. Precondition: no angle is given in degrees.
class ExactEntries {
 public:
  explicit ExactEntries(const Scene& scene);
  /// Precondition: the scene gives the pair.
  const Rational& operator()(int p, int q) const { return entries_.at({p, q}); }
  bool is_plane(int element) const { return element >= first_plane_; }

 private:
  std::map<std::pair<int, int>, Rational> entries_;
  int first_plane_;
};

/// Twice the product of two elements as vectors of R³ seen from the point `apex`: p − apex of a point, the normal of a
/// plane.
template <class Entries>
auto doubled_product(const Entries& entries, int apex, int p, int q) {
  if (!entries.is_plane(p) && !entries.is_plane(q))
    return entries(p, apex) + entries(q, apex) - entries(p, q);
  if (entries.is_plane(p) && entries.is_plane(q)) return entries(p, q) + entries(p, q);
  const auto [plane, point] = entries.is_plane(p) ? std::pair(p, q) : std::pair(q, p);
  const auto component = entries(plane, point) - entries(plane, apex);
  return component + component;
}

}  // namespace gcs
