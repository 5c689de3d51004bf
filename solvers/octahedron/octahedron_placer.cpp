#include "solvers/octahedron/octahedron_placer.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {
namespace {

/// A position that misses a distance which it was not placed by by more (relative, squared) is none: the
/// error of a double zero is the square root of rounding, that of the height over a plane which it decides
/// the fourth.
constexpr double largest_miss = 1e-2;

/// The entries of all pairs but the last.
struct FilledEntries {
  const PairEntries& given;
  const Octahedron& octahedron;
  const Diagonals& diagonals;

  bool is_plane(int element) const { return given.is_plane(element); }
  std::complex<double> operator()(int p, int q) const {
    const auto are = [&](const std::array<int, 2>& pair) {
      return std::minmax(p, q) == std::minmax(pair[0], pair[1]);
    };
    if (are(octahedron.pair[0])) return diagonals.x;
    if (are(octahedron.pair[1])) return diagonals.y;
    return given(p, q);
  }
};

}  // namespace

OctahedronPlacer::OctahedronPlacer(int elements, const PairEntries& entries, const Octahedron& octahedron)
    : entries_(entries), octahedron_(octahedron), points_(ComplexPoints::Zero(3, elements)) {
  const auto [a, b, c] = base();
  const double length = std::sqrt(entries(a, b));
  const double along = (entries(a, b) + entries(a, c) - entries(b, c)) / (2 * length);
  points_(0, b) = length;
  points_(0, c) = along;
  points_(1, c) = std::sqrt(std::max(0.0, entries(a, c) - along * along));
  scale_ = std::max({entries(a, b), entries(a, c), entries(b, c)});
}

std::vector<ComplexPoints> OctahedronPlacer::place(const Diagonals& diagonals) {
  const auto [a, b, c] = base();
  const int a2 = octahedron_.pair[0][1];
  const int b2 = octahedron_.pair[1][1];
  diagonals_ = diagonals;
  std::vector<ComplexPoints> figures;
  const auto both_a2 = on({a, b, c}, a2);
  const auto both_b2 = on({a, b, c}, b2);
  if (!both_a2 || !both_b2) return figures;
  points_.col(a2) = (*both_a2)[0];
  for (const Eigen::Vector3cd& position : plausible(*both_b2, b2, a2)) {
    points_.col(b2) = position;
    place_last(figures);
  }
  return figures;
}

/// c' on a, b and whichever of a' and b' is farther from their line; the other one decides the side.
void OctahedronPlacer::place_last(std::vector<ComplexPoints>& figures) {
  const auto [a, b, c] = base();
  int third = octahedron_.pair[0][1];
  int other = octahedron_.pair[1][1];
  const int last = octahedron_.pair[2][1];
  const auto height = [this](int p) { return points_.col(p).tail<2>().norm(); };
  if (height(third) < height(other)) std::swap(third, other);
  const auto both = on({a, b, third}, last);
  if (!both) return;
  for (const Eigen::Vector3cd& position : plausible(*both, last, other)) {
    points_.col(last) = position;
    figures.push_back(points_);
  }
}

/// Of the distance of two elements as they are placed.
std::complex<double> OctahedronPlacer::square(int p, int q) const {
  const FilledEntries entries{entries_, octahedron_, diagonals_};
  if (!entries.is_plane(p) && !entries.is_plane(q)) return entries(p, q);
  const auto product = [&](int i, int k) { return doubled_product(entries, base()[0], i, k) / 2.0; };
  return product(p, p) + product(q, q) - 2.0 * product(p, q);
}

std::optional<std::array<Eigen::Vector3cd, 2>> OctahedronPlacer::on(const std::array<int, 3>& centers,
                                                                    int p) const {
  return trilaterate({points_.col(centers[0]), points_.col(centers[1]), points_.col(centers[2])},
                     {square(p, centers[0]), square(p, centers[1]), square(p, centers[2])});
}

/// By how much the distance from `position` to point q misses that of p and q; relative, squared.
double OctahedronPlacer::miss(const Eigen::Vector3cd& position, int p, int q) const {
  const Eigen::Vector3cd difference = position - points_.col(q);
  return std::abs((difference.transpose() * difference).value() - square(p, q)) /
         std::max(scale_, difference.squaredNorm());
}

/// Of the two positions of p those that miss the distance to q by little, the better one in any case.
std::vector<Eigen::Vector3cd> OctahedronPlacer::plausible(const std::array<Eigen::Vector3cd, 2>& both, int p,
                                                          int q) const {
  const double first = miss(both[0], p, q);
  const double second = miss(both[1], p, q);
  std::vector<Eigen::Vector3cd> kept;
  if (first <= second || first <= largest_miss) kept.push_back(both[0]);
  if (!(first <= second) || second <= largest_miss) kept.push_back(both[1]);
  return kept;
}

}  // namespace gcs
