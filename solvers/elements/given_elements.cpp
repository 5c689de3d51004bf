#include "solvers/elements/given_elements.hpp"

#include <algorithm>
#include <cstdlib>

#include "solvers/elements/exact_coordinates.hpp"
#include "solvers/model/frame_choice.hpp"

namespace gcs {
namespace {

/// The numbers of given positions, exactly as they are known.
class GivenNumbers {
 public:
  explicit GivenNumbers(const ProblemStatement& problem) : problem_(problem) {}

  std::vector<Decimal> of(int entity) const {
    const auto row = fixed_text_row(problem_, entity);
    std::vector<Decimal> numbers;
    if (problem_.is_point(entity)) {
      append(problem_.fixed_points[static_cast<std::size_t>(entity)]->head(problem_.dimension), row, numbers);
    } else if (problem_.is_line(entity)) {
      const LinePosition& line = *problem_.fixed_lines[static_cast<std::size_t>(problem_.line_of(entity))];
      append(line.point.head(problem_.dimension), row, numbers);
      append(line.direction.head(problem_.dimension), row + 1, numbers);
    } else {
      const PlanePosition& plane =
          *problem_.fixed_planes[static_cast<std::size_t>(problem_.plane_of(entity))];
      append(plane.normal, row, numbers);
      append(Eigen::Matrix<double, 1, 1>(plane.offset), row + 1, numbers);
    }
    return numbers;
  }

 private:
  void append(const Eigen::VectorXd& values, std::size_t row, std::vector<Decimal>& numbers) const {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const std::string text =
          row < problem_.fixed_texts.size() ? problem_.fixed_texts[row][static_cast<std::size_t>(i)] : "";
      numbers.push_back({text.empty() ? values[i] : std::strtod(text.c_str(), nullptr), text});
    }
  }

  const ProblemStatement& problem_;
};

struct Axis {
  RationalVector origin, direction;
};

/// Without a point the origin is the point h n/(n·n) of the plane, or that by which the line is given.
Axis axis_of(const ProblemStatement& problem, const std::vector<BodyElement>& elements, int exponent) {
  const GivenAxis given = given_axis(problem);
  const auto numbers = [&](int entity, std::size_t first, int length_exponent) {
    const auto found = std::ranges::find(elements, entity, &BodyElement::entity);
    return rational_vector(*found, first, problem.dimension, length_exponent);
  };
  Axis axis;
  if (given.origin >= 0) axis.origin = numbers(given.origin, 0, exponent);
  if (given.axis < 0) {
    axis.direction[0] = Rational(1);
  } else if (problem.is_point(given.axis)) {
    axis.direction = numbers(given.axis, 0, exponent) - axis.origin;
  } else if (problem.is_line(given.axis)) {
    axis.direction = numbers(given.axis, static_cast<std::size_t>(problem.dimension), 0);
    if (given.origin < 0) axis.origin = numbers(given.axis, 0, exponent);
  } else {
    axis.direction = numbers(given.axis, 0, 0);
    const auto plane = std::ranges::find(elements, given.axis, &BodyElement::entity);
    const Rational height = rational_vector(*plane, 3, 1, exponent)[0] / dot(axis.direction, axis.direction);
    for (std::size_t i = 0; given.origin < 0 && i < 3; ++i) axis.origin[i] = height * axis.direction[i];
  }
  return axis;
}

/// The first of the axes along which the vector is shortest.
RationalVector least_along(const RationalVector& v) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if ((v[i] * v[i] - v[least] * v[least]).sign() < 0) least = i;
  RationalVector axis;
  axis[least] = Rational(1);
  return axis;
}

}  // namespace

std::vector<BodyElement> given_elements(const ProblemStatement& problem) {
  const GivenNumbers numbers(problem);
  std::vector<BodyElement> elements;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity)) elements.push_back({entity, numbers.of(entity)});
  return elements;
}

ExactFrame exact_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements) {
  const Axis axis = axis_of(problem, elements, 0);
  RationalVector z;
  if (problem.dimension == 2)
    z[2] = Rational(1);
  else
    z = cross(axis.direction, least_along(axis.direction));
  return {{unit_numbers(axis.direction), unit_numbers(cross(z, axis.direction)), unit_numbers(z)},
          exact_numbers(axis.origin)};
}

FramePose axial_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements) {
  const ExactFrame exact = exact_frame(problem, elements);
  FramePose frame;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    frame.origin[axis] = rounded_to_double(exact.origin[i]).real();
    for (std::size_t k = 0; k < 3; ++k)
      frame.axes(axis, static_cast<Eigen::Index>(k)) = rounded_to_double(exact.axes[i][k]).real();
  }
  return frame;
}

// With the origin o and the axis d the place of a point v is (v − o)·d/‖d‖, and that of a plane n·x = h across d
// (h − n·o)/(n·d) · d·d/‖d‖. Without a point o is the point h n/(n·n) of the plane that gives the axis.
std::vector<AxialElement> axial_elements(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const int d = problem.dimension, exponent = -scene.unit_exponent();
  const GivenAxis frame = given_axis(problem);
  const std::vector<BodyElement> given = given_elements(problem);
  const Axis axis = axis_of(problem, given, exponent);
  const std::vector<Rational> along(axis.direction.begin(), axis.direction.end());
  std::vector<AxialElement> elements;
  for (const BodyElement& element : given) {
    AxialElement& axial = elements.emplace_back();
    axial.entity = element.entity;
    if (problem.is_line(element.entity) || element.entity == frame.origin) continue;
    if (problem.is_point(element.entity)) {
      axial.place =
          over_norm(dot(rational_vector(element, 0, d, exponent) - axis.origin, axis.direction), along);
      continue;
    }
    const RationalVector normal = rational_vector(element, 0, d, 0);
    const Rational height = rational_vector(element, 3, 1, exponent)[0] - dot(normal, axis.origin),
                   cosine = dot(normal, axis.direction);
    axial.is_opposite = cosine.sign() < 0;
    axial.place = over_norm(height / cosine * dot(axis.direction, axis.direction), along);
  }
  return elements;
}

bool has_given_shape(const ProblemStatement& problem) {
  return problem.file_frame && problem.reference_body < 0 && given_elements(problem).size() > 1;
}

ProblemStatement with_given_body(ProblemStatement problem) {
  if (!problem.is_anchored()) return problem;
  RigidBody given{"fixed", given_elements(problem)};
  for (RigidBody& body : problem.bodies)
    if (std::ranges::all_of(
            body.elements, [&](int entity) { return problem.is_fixed(entity); }, &BodyElement::entity))
      body.elements.clear();
  problem.reference_body = static_cast<int>(problem.bodies.size());
  problem.bodies.push_back(std::move(given));
  return problem;
}

bool has_element_equations(const ProblemStatement& problem) {
  return problem.is_general() ||
         std::ranges::any_of(problem.fixed_lines, [](const auto& line) { return line.has_value(); });
}

}  // namespace gcs
