#include "solvers/tangents/degenerate_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// Lengths are of order 1, and so is the rounding of a difference of two of them.
constexpr double same_place = 8 * rounding;

/// The rounding of positions along an axis, relative to the axis.
constexpr double collinear = 16 * rounding;

/// What rounding leaves of a third divided difference, relative to the sum of its terms' moduli.
constexpr double on_a_parabola = 256 * rounding;

enum class Concentric { none, same, different };

Concentric concentric(const FourSpheres& spheres) {
  Concentric result = Concentric::none;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((spheres[i].center - spheres[j].center).norm() > same_place) continue;
      const double larger = std::max(spheres[i].square.value(), spheres[j].square.value());
      if (std::abs((spheres[i].square - spheres[j].square).value()) > 8 * rounding * larger)
        return Concentric::different;
      result = Concentric::same;
    }
  }
  return result;
}

/// The squared distances over the positions along the axis of the centres, r²(a) = α + βa + γa².
struct AxialDistances {
  Tangent<double> axis;
  std::array<double, 4> position{};
  std::array<double, 4> square{};
};

AxialDistances axial_distances(const FourSpheres& spheres) {
  AxialDistances axial;
  Eigen::Vector3d longest = Eigen::Vector3d::Zero();
  for (const Sphere& a : spheres)
    for (const Sphere& b : spheres)
      if ((a.center - b.center).norm() > longest.norm()) longest = a.center - b.center;
  axial.axis.direction = longest.normalized();
  const Eigen::Vector3d& origin = spheres[0].center;
  axial.axis.point = origin - axial.axis.direction * axial.axis.direction.dot(origin);
  for (std::size_t i = 0; i < 4; ++i) {
    axial.position[i] = axial.axis.direction.dot(spheres[i].center - origin);
    axial.square[i] = spheres[i].square.value();
  }
  return axial;
}

/// Third divided difference: zero when the four are values of a polynomial of degree 2.
bool are_on_a_parabola(const AxialDistances& axial) {
  double sum = 0, moduli = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double term = axial.square[i];
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) term /= axial.position[i] - axial.position[j];
    sum += term;
    moduli += std::abs(term);
  }
  return std::abs(sum) <= on_a_parabola * moduli;
}

/// Whether a real line has these squared distances: γ = sin² of its angle with the axis, and the least value
/// is the square of its distance from the axis.
bool is_real_family(const AxialDistances& axial) {
  const auto& a = axial.position;
  const auto& r = axial.square;
  const double slope_1 = (r[1] - r[0]) / (a[1] - a[0]);
  const double slope_2 = (r[2] - r[1]) / (a[2] - a[1]);
  const double gamma = (slope_2 - slope_1) / (a[2] - a[0]);
  const double span = *std::max_element(a.begin(), a.end()) - *std::min_element(a.begin(), a.end());
  const double largest = *std::max_element(r.begin(), r.end());
  const double tolerance = on_a_parabola * largest / (span * span);
  if (gamma < -tolerance || gamma > 1 + tolerance) return false;
  if (gamma <= tolerance) return std::abs(slope_1) <= on_a_parabola * largest / span;
  const double beta = slope_1 - gamma * (a[0] + a[1]);
  const double alpha = r[0] - beta * a[0] - gamma * a[0] * a[0];
  return alpha - beta * beta / (4 * gamma) >= -on_a_parabola * largest;
}

DegenerateTangents collinear_tangents(const AxialDistances& axial) {
  if (!are_on_a_parabola(axial)) return {};
  if (std::all_of(axial.square.begin(), axial.square.end(), [](double square) { return square == 0; }))
    return {
        "the four points lie on one line, which the line sought must be: all others that have the distance "
        "0 from them are complex, infinitely many",
        axial.axis};
  if (is_real_family(axial))
    return {
        "the centres are collinear and their distances are those of a line, which keeps them when it is "
        "turned about the line of the centres",
        {}};
  return {
      "the centres are collinear and infinitely many complex lines have these distances from them, but no "
      "real one",
      {}};
}

}  // namespace

std::optional<DegenerateTangents> degenerate_tangents(const FourSpheres& spheres) {
  switch (concentric(spheres)) {
    case Concentric::different:
      return DegenerateTangents{};
    case Concentric::same:
      return DegenerateTangents{
          "two centres coincide at equal distances: what is left are three conditions on the four degrees of "
          "freedom of a line",
          {}};
    case Concentric::none:
      break;
  }
  if (relative_width(spheres) > collinear) return std::nullopt;
  return collinear_tangents(axial_distances(spheres));
}

}  // namespace gcs
