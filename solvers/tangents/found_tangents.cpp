#include "solvers/tangents/found_tangents.hpp"

#include <algorithm>
#include <utility>

#include "solvers/tangents/tangent_algebra.hpp"
#include "solvers/tangents/tangent_refinement.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// Relative to the squared distances: what an exact multiple solution leaves after rounding its coordinates,
/// and two simple ones 1e-7 apart, too near to be told apart, leave at their mean.
constexpr double multiple_residual = 1e-13;

bool satisfies(const FourSpheres& spheres, const ComplexTangent& line) {
  const double size = (1 + line.point.norm()) * line.direction.norm();
  return largest_excess(spheres, line) <= multiple_residual * size * size;
}

}  // namespace

double difference(const ComplexTangent& a, const ComplexTangent& b) {
  const double direction = std::min((a.direction - b.direction).norm(), (a.direction + b.direction).norm());
  return std::max(direction / a.direction.norm(), (a.point - b.point).norm() / (1 + a.point.norm()));
}

ComplexTangent conjugate(const ComplexTangent& line) {
  return {line.point.conjugate(), line.direction.conjugate()};
}

ComplexTangent real_part(const ComplexTangent& line) {
  return {line.point.real().cast<Complex>(), line.direction.real().cast<Complex>()};
}

bool is_nearly_real(const ComplexTangent& line) { return difference(line, conjugate(line)) <= 1e-7; }

std::optional<FoundTangent> multiple_tangent(const FourSpheres& spheres, const ComplexTangent& line,
                                             bool is_real, int multiplicity) {
  FoundTangent found{is_real ? real_part(line) : line, is_real, multiplicity};
  settle(spheres, found.line);
  if (!satisfies(spheres, found.line)) return std::nullopt;
  return found;
}

void FoundTangents::add_simple(const ComplexTangent& line) {
  const bool is_real = is_nearly_real(line);
  lines.push_back({is_real ? real_part(line) : line, is_real, 1});
  if (!is_real) lines.push_back({conjugate(line), false, 1});
}

int FoundTangents::accounted_for() const {
  int sum = at_infinity;
  for (const FoundTangent& found : lines) sum += found.multiplicity;
  return sum;
}

bool FoundTangents::are_all_simple() const { return lines.size() == tangent_count; }

bool FoundTangents::tell_more_than(const FoundTangents& other) const {
  return std::pair(accounted_for(), lines.size()) > std::pair(other.accounted_for(), other.lines.size());
}

std::optional<std::size_t> FoundTangents::find(const ComplexTangent& line) const {
  const auto found = std::find_if(lines.begin(), lines.end(), [&](const FoundTangent& other) {
    return difference(line, other.line) <= same_line;
  });
  if (found == lines.end()) return std::nullopt;
  return static_cast<std::size_t>(found - lines.begin());
}

}  // namespace gcs
