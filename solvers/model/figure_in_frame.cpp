#include "solvers/model/figure_in_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/model/complex_lines.hpp"

namespace gcs {
namespace {

/// The point of the line nearest to the origin, and the direction whose first non-zero component is positive.
LinePosition normalised(const LinePosition& line) {
  LinePosition result;
  result.direction = line.direction.stableNormalized();
  int lead = 0;
  while (lead < 2 && std::abs(result.direction[lead]) < 1e-9) ++lead;
  if (result.direction[lead] < 0) result.direction = -result.direction;
  result.point = line.point - result.direction * result.direction.dot(line.point);
  return result;
}

double reach_of(const Figure& figure) {
  double reach = figure.points.size() > 0 ? figure.points.cwiseAbs().maxCoeff() : 0;
  if (figure.imaginary.size() > 0) reach = std::max(reach, figure.imaginary.cwiseAbs().maxCoeff());
  for (const auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (const LinePosition& line : *lines) reach = std::max(reach, line.point.norm());
  for (const auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (const PlanePosition& plane : *planes) reach = std::max(reach, std::abs(plane.offset));
  return reach;
}

}  // namespace

Figure as_seen_from(const FramePose& frame, const Figure& figure) {
  Figure result = figure;
  result.points = frame.axes * (figure.points.colwise() - frame.origin);
  if (figure.imaginary.cols() > 0) result.imaginary = frame.axes * figure.imaginary;
  for (LinePosition& line : result.lines) {
    line.point = frame.axes * (line.point - frame.origin);
    line.direction = frame.axes * line.direction;
  }
  for (LinePosition& line : result.imaginary_lines)
    line = {frame.axes * line.point, frame.axes * line.direction};
  for (auto* planes : {&result.planes, &result.imaginary_planes})
    for (PlanePosition& plane : *planes) {
      plane.offset -= plane.normal.dot(frame.origin);
      plane.normal = frame.axes * plane.normal;
    }
  return result;
}

Figure with_normalised_lines(Figure figure) {
  if (figure.is_real())
    for (LinePosition& line : figure.lines) line = normalised(line);
  else
    set_complex_lines(normalised(complex_lines(figure)), figure);
  return figure;
}

Figure in_file(const Figure& figure, int unit_exponent, const std::optional<FramePose>& frame) {
  const Figure scaled = figure.scaled(unit_exponent);
  if (!frame) return scaled;
  const FramePose file{frame->axes.transpose(), -(frame->axes * frame->origin)};
  return with_normalised_lines(as_seen_from(file, scaled));
}

double error_in_file(const Figure& figure, double error, double size, int unit_exponent,
                     const std::optional<FramePose>& frame) {
  if (!frame) return error;
  // The frame's axes and the products with them are right to less than so much, relative to what they are of.
  constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  const double lever = std::ldexp(frame->origin.norm(), -unit_exponent);
  const bool has_directions = !figure.lines.empty() || !figure.planes.empty();
  const double turned = has_directions ? 4 * lever / size : 0;
  return (error * (1 + turned) + rounding * (lever + size + reach_of(figure))) * (1 + rounding);
}

Figure in_scene(const Figure& figure, int unit_exponent, const std::optional<FramePose>& frame) {
  return (frame ? as_seen_from(*frame, figure) : figure).scaled(-unit_exponent);
}

}  // namespace gcs
