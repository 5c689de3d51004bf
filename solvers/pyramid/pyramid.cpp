#include "solvers/pyramid/pyramid.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace gcs {
namespace {

constexpr int points = 5;
constexpr int line = 5;  // the entity after the points

/// Target lengths between entities; 0: none is given (a given distance to the line may be 0 too).
struct Lengths {
  Eigen::Matrix<double, 6, 6> value = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<bool, 6, 6> given = Eigen::Matrix<bool, 6, 6>::Constant(false);

  explicit Lengths(const Scene& scene) {
    for (int e = 0; e < scene.constraint_count(); ++e) {
      const auto [a, b] = scene.problem().constraints[e].between;
      value(a, b) = value(b, a) = scene.target_lengths()[e];
      given(a, b) = given(b, a) = true;
    }
  }

  /// How many of the five points are constrained against `entity`.
  int degree(int entity) const { return static_cast<int>(given.row(entity).head<points>().count()); }
};

/// The point of degree 4 when the others have degree 3 and all five are constrained against the line.
std::optional<int> find_apex(const Lengths& lengths) {
  if (lengths.degree(line) != points) return std::nullopt;
  std::optional<int> apex;
  for (int p = 0; p < points; ++p) {
    if (lengths.degree(p) == 3) continue;
    if (lengths.degree(p) != 4 || apex) return std::nullopt;
    apex = p;
  }
  return apex;
}

/// The four others around. With degree 2 among themselves they are one cycle.
std::array<int, 4> cycle_around(const Lengths& lengths, int apex) {
  const int first = apex == 0 ? 1 : 0;
  std::vector<int> neighbours;
  int opposite = -1;
  for (int p = 0; p < points; ++p) {
    if (p == apex || p == first) continue;
    if (lengths.given(first, p))
      neighbours.push_back(p);
    else
      opposite = p;
  }
  return {first, neighbours[0], opposite, neighbours[1]};
}

}  // namespace

std::optional<Pyramid> find_pyramid(const Scene& scene) {
  const bool has_entities = scene.point_count() == points && scene.problem().lines.size() == 1;
  if (!has_entities || scene.constraint_count() != 13 || scene.is_anchored()) return std::nullopt;
  const Lengths lengths(scene);
  const auto apex = find_apex(lengths);
  if (!apex) return std::nullopt;
  Pyramid pyramid;
  pyramid.apex = *apex;
  pyramid.cycle = cycle_around(lengths, *apex);
  pyramid.apex_radius = lengths.value(*apex, line);
  for (std::size_t i = 0; i < 4; ++i) {
    const int p = pyramid.cycle[i];
    pyramid.radius[i] = lengths.value(p, line);
    pyramid.spoke[i] = lengths.value(p, *apex);
    pyramid.side[i] = lengths.value(p, pyramid.cycle[(i + 1) % 4]);
  }
  return pyramid;
}

}  // namespace gcs
