#include "harness/tests/contract/distance_of_figures.hpp"

#include <algorithm>
#include <limits>

#include "solvers/elements/placement.hpp"

namespace gcs::contract {
namespace {

/// Distance of two lines' representations; the sign of a direction means nothing.
double distance(const ComplexLine& a, const ComplexLine& b) {
  const double turn = std::min((a.direction - b.direction).norm(), (a.direction + b.direction).norm());
  return std::max((a.point - b.point).norm(), turn);
}

/// Likewise of planes, whichever side they are seen from.
double distance(const ComplexPlane& a, const ComplexPlane& b) {
  const auto apart = [&](double sign) {
    return std::max((a.normal - sign * b.normal).norm(), std::abs(a.offset - sign * b.offset));
  };
  return std::min(apart(1), apart(-1));
}

}  // namespace

double distance_of(const Figure& a, const Figure& b) {
  if (a.is_real() != b.is_real()) return std::numeric_limits<double>::infinity();
  double result = (complex_points(a) - complex_points(b)).cwiseAbs().maxCoeff();
  const std::vector<ComplexLine> lines_a = normalised(complex_lines(a)),
                                 lines_b = normalised(complex_lines(b));
  for (std::size_t i = 0; i < lines_a.size(); ++i)
    result = std::max(result, distance(lines_a[i], lines_b[i]));
  const std::vector<ComplexPlane> planes_a = placement_of(a).planes, planes_b = placement_of(b).planes;
  for (std::size_t i = 0; i < planes_a.size(); ++i)
    result = std::max(result, distance(planes_a[i], planes_b[i]));
  return result;
}

}  // namespace gcs::contract
