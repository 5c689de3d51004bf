#include "solvers/tangents/degenerate_spheres.hpp"

#include <algorithm>
#include <limits>

namespace gcs {
namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// Lengths are of order 1, and so is the rounding of a difference of two of them.
constexpr double same_place = 8 * rounding;

enum class Concentric { none, same, different };

Concentric concentric(const ExactSpheres& spheres) {
  Concentric result = Concentric::none;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_zero(spheres[i].center - spheres[j].center)) continue;
      if (!(spheres[i].square == spheres[j].square)) return Concentric::different;
      result = Concentric::same;
    }
  }
  return result;
}

bool are_collinear(const ExactSpheres& spheres) {
  const RationalVector along = spheres[1].center - spheres[0].center;
  return is_zero(cross(along, spheres[2].center - spheres[0].center)) &&
         is_zero(cross(along, spheres[3].center - spheres[0].center));
}

/// The squared distances over the positions along the axis of the centres, r²(a) = α + βa + γa².
struct AxialDistances {
  Rational unit;  ///< of the positions, squared
  std::array<Rational, 4> position;
  std::array<Rational, 4> square;

  /// Precondition: the centres are distinct and collinear.
  explicit AxialDistances(const ExactSpheres& spheres) {
    const RationalVector along = spheres[1].center - spheres[0].center;
    unit = Rational(1) / dot(along, along);
    for (std::size_t i = 0; i < 4; ++i) {
      position[i] = dot(along, spheres[i].center - spheres[0].center);
      square[i] = spheres[i].square;
    }
  }
};

/// Third divided difference: zero when the four are values of a polynomial of degree 2.
bool are_on_a_parabola(const AxialDistances& axial) {
  Rational sum;
  for (std::size_t i = 0; i < 4; ++i) {
    Rational term = axial.square[i];
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) term = term / (axial.position[i] - axial.position[j]);
    sum = sum + term;
  }
  return sum.is_zero();
}

/// Whether a real line has these squared distances: γ = sin² of its angle with the axis, and the least value
/// is the square of its distance from the axis.
bool is_real_family(const AxialDistances& axial) {
  const auto& a = axial.position;
  const auto& r = axial.square;
  const Rational slope_1 = (r[1] - r[0]) / (a[1] - a[0]);
  const Rational slope_2 = (r[2] - r[1]) / (a[2] - a[1]);
  const Rational gamma = (slope_2 - slope_1) / (a[2] - a[0]);
  if (gamma.sign() < 0 || (axial.unit - gamma).sign() < 0) return false;
  if (gamma.is_zero()) return slope_1.is_zero();
  const Rational beta = slope_1 - gamma * (a[0] + a[1]);
  const Rational alpha = r[0] - beta * a[0] - gamma * a[0] * a[0];
  return (Rational(4) * alpha * gamma - beta * beta).sign() >= 0;
}

DegenerateTangents collinear_tangents(const AxialDistances& axial) {
  if (!are_on_a_parabola(axial)) return {};
  if (std::all_of(axial.square.begin(), axial.square.end(),
                  [](const Rational& square) { return square.is_zero(); }))
    return {
        "the four points lie on one line, which the line sought must be: all others that have the distance "
        "0 from them are complex, infinitely many",
        true};
  if (is_real_family(axial))
    return {
        "the centres are collinear and their distances are those of a line, which keeps them when it is "
        "turned about the line of the centres",
        false};
  return {
      "the centres are collinear and infinitely many complex lines have these distances from them, but no "
      "real one",
      false};
}

}  // namespace

std::optional<DegenerateTangents> degenerate_tangents(const ExactSpheres& spheres) {
  switch (concentric(spheres)) {
    case Concentric::different:
      return DegenerateTangents{};
    case Concentric::same:
      return DegenerateTangents{
          "two centres coincide at equal distances: what is left are three conditions on the four degrees of "
          "freedom of a line",
          false};
    case Concentric::none:
      break;
  }
  if (!are_collinear(spheres)) return std::nullopt;
  return collinear_tangents(AxialDistances(spheres));
}

std::optional<std::string> why_nearly_concentric(const FourSpheres& spheres) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((spheres[i].center - spheres[j].center).norm() <= same_place)
        return "two centres are so close together that doubles do not tell them apart";
  return std::nullopt;
}

Tangent<double> line_of_centers(const FourSpheres& spheres) {
  Eigen::Vector3d longest = Eigen::Vector3d::Zero();
  for (const Sphere& a : spheres)
    for (const Sphere& b : spheres)
      if ((a.center - b.center).norm() > longest.norm()) longest = a.center - b.center;
  const Eigen::Vector3d direction = longest.normalized();
  const Eigen::Vector3d& origin = spheres[0].center;
  return {origin - direction * direction.dot(origin), direction};
}

}  // namespace gcs
