#include "solvers/tests/elements/measured_scenes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

namespace gcs::samples {
namespace {

Eigen::Vector3d direction(int dimension, RandomNumbers& random) {
  return random.point(dimension, 1).normalized();
}

LinePosition line_through(const Eigen::Vector3d& point, int dimension, RandomNumbers& random) {
  return {point, direction(dimension, random)};
}

LinePosition random_line(int dimension, RandomNumbers& random) {
  const Eigen::Vector3d point = random.point(dimension, 2);
  return line_through(point, dimension, random);
}

PlanePosition random_plane(RandomNumbers& random) {
  const Eigen::Vector3d normal = direction(3, random);
  return {normal, random.uniform(-1, 1)};
}

/// p3 and p4 by a line through p0, of which one coordinate is left until p4 is placed.
Figure cylinders_figure(RandomNumbers& random) {
  Figure figure{random.points(3, 5, 2), {}};
  figure.lines.push_back(line_through(figure.points.col(0), 3, random));
  return figure;
}
void cylinders(MeasuredProblem& p) {
  p.distance(0, 1).distance(0, 2).distance(1, 2).holds("on", 0, 5).distance(1, 5).distance(3, 5);
  p.distance(4, 5).distance(1, 3).distance(2, 3).distance(2, 4).distance(3, 4).distance(0, 4);
}

/// Planes by points and by a plane, a line by a point, a plane and a point.
Figure planes_figure(RandomNumbers& random) {
  Figure figure{random.points(3, 4, 2), {}};
  figure.lines.push_back(line_through(figure.points.col(1), 3, random));
  for (int i = 0; i < 2; ++i) figure.planes.push_back(random_plane(random));
  return figure;
}
void planes(MeasuredProblem& p) {
  p.distance(0, 1).distance(0, 2).distance(1, 2).distance(0, 5).distance(1, 5).distance(3, 5);
  p.angle(5, 6).distance(2, 6).distance(0, 6).holds("on", 1, 4).angle(4, 5).distance(3, 4);
  p.distance(0, 3).distance(2, 3).distance(3, 6);
}

/// A line at distances from points alone, and points on it and beside it.
Figure line_beside_figure(RandomNumbers& random) {
  Figure figure{random.points(3, 5, 2), {}};
  figure.lines.push_back(random_line(3, random));
  figure.points.col(4) = figure.lines[0].point + random.uniform(-1, 1) * figure.lines[0].direction;
  return figure;
}
void line_beside(MeasuredProblem& p) {
  p.distance(0, 1).distance(0, 2).distance(1, 2).distance(0, 5).distance(1, 5).distance(2, 5);
  p.distance(3, 5).holds("on", 4, 5).distance(0, 3).distance(1, 3).distance(3, 4).distance(2, 4);
}

/// In the plane: tangents of circles, and points on and beside them.
Figure tangents_figure(RandomNumbers& random) {
  Figure figure{random.points(2, 4, 2), {}};
  figure.lines.push_back(line_through(figure.points.col(0), 2, random));
  figure.lines.push_back(line_through(figure.points.col(3), 2, random));
  return figure;
}
void tangents(MeasuredProblem& p) {
  p.distance(0, 1).holds("on", 0, 4).distance(3, 4).distance(1, 5).distance(2, 5).distance(0, 2);
  p.distance(2, 3).distance(1, 3).holds("on", 3, 5);
}

/// In the plane: lines at an angle, a point by a point and a line.
Figure lines_figure(RandomNumbers& random) {
  Figure figure{random.points(2, 4, 2), {}};
  for (int i = 0; i < 2; ++i) figure.lines.push_back(random_line(2, random));
  figure.points.col(3) = figure.lines[0].point + random.uniform(-1, 1) * figure.lines[0].direction;
  return figure;
}
void lines(MeasuredProblem& p) {
  p.distance(0, 1).distance(0, 4).distance(2, 4).distance(1, 5).angle(4, 5).distance(0, 2);
  p.distance(2, 5).holds("on", 3, 4).distance(2, 3);
}

/// Two points and a line through one of them beside a body at rest.
Figure beside_body_figure(RandomNumbers& random) {
  Figure figure{random.points(3, 6, 2), {}};
  figure.lines.push_back(line_through(figure.points.col(5), 3, random));
  return figure;
}
void beside_body(MeasuredProblem& p) {
  p.at_rest(4).distance(1, 5).distance(3, 5).distance(4, 5).distance(0, 4).distance(2, 4);
  p.holds("on", 5, 6).distance(4, 6).distance(0, 6).distance(1, 6);
}

/// Parallel planes, whose normals are one or opposite, beside points.
Figure parallel_planes_figure(RandomNumbers& random) {
  Figure figure{random.points(3, 4, 2), {}};
  figure.planes = {random_plane(random), random_plane(random)};
  figure.planes[1].normal = -figure.planes[0].normal;
  return figure;
}
void parallel_planes(MeasuredProblem& p) {
  p.distance(0, 1).distance(0, 2).distance(1, 2).distance(0, 4).distance(1, 4).holds("parallel", 4, 5);
  p.distance(2, 5).distance(0, 3).distance(1, 3).distance(3, 5).distance(2, 3);
}

struct Kind {
  std::string name;
  int dimension;
  std::function<Figure(RandomNumbers&)> figure;
  std::function<void(MeasuredProblem&)> state;
};

}  // namespace

MeasuredProblem::MeasuredProblem(int dimension, const Figure& figure) : figure_(figure) {
  problem_.dimension = dimension;
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) problem_.points.push_back("p" + std::to_string(i));
  for (std::size_t i = 0; i < figure.lines.size(); ++i) problem_.lines.push_back("l" + std::to_string(i));
  for (std::size_t i = 0; i < figure.planes.size(); ++i) problem_.planes.push_back("h" + std::to_string(i));
  problem_.reference = Reference{0, 1, dimension == 3 ? 2 : -1};
}

void MeasuredProblem::relate(const std::string& type, int a, int b, Relation::Form form, double value) {
  const std::string id = type + std::to_string(a) + std::to_string(b);
  problem_.relations.push_back({id, type, {{a}, {b}}, form, {value, ""}});
}

MeasuredProblem& MeasuredProblem::distance(int a, int b) {
  const Eigen::Vector3d from = figure_.points.col(a);
  if (problem_.is_point(b)) {
    const double length = (from - figure_.points.col(b)).norm();
    problem_.constraints.push_back({std::to_string(a) + std::to_string(b), {a, b}, {length, ""}, false});
  } else if (problem_.is_line(b)) {
    const LinePosition& line = figure_.lines[static_cast<std::size_t>(problem_.line_of(b))];
    relate("distance", a, b, Relation::Form::length, (from - line.point).cross(line.direction).norm());
  } else {
    const PlanePosition& plane = figure_.planes[static_cast<std::size_t>(problem_.plane_of(b))];
    relate("distance", a, b, Relation::Form::length, plane.normal.dot(from) - plane.offset);
  }
  return *this;
}

MeasuredProblem& MeasuredProblem::angle(int a, int b) {
  const auto unit = [&](int element) -> Eigen::Vector3d {
    return problem_.is_line(element)
               ? figure_.lines[static_cast<std::size_t>(problem_.line_of(element))].direction
               : figure_.planes[static_cast<std::size_t>(problem_.plane_of(element))].normal;
  };
  const double product = unit(a).dot(unit(b));
  const bool is_of_planes = problem_.is_plane(a) && problem_.is_plane(b);
  const bool is_of_lines = problem_.is_line(a) && problem_.is_line(b);
  const double cosine = is_of_planes  ? product
                        : is_of_lines ? std::abs(product)
                                      : std::sqrt(1 - product * product);
  relate("angle", a, b, Relation::Form::cosine, cosine);
  return *this;
}

MeasuredProblem& MeasuredProblem::holds(const std::string& type, int a, int b) {
  relate(type, a, b, Relation::Form::none, 0);
  return *this;
}

MeasuredProblem& MeasuredProblem::at_rest(int points) {
  RigidBody body{"base", {}};
  for (int i = 0; i < points; ++i) {
    BodyElement element{i, {}};
    for (int axis = 0; axis < problem_.dimension; ++axis)
      element.numbers.push_back({figure_.points(axis, i), ""});
    body.elements.push_back(element);
  }
  problem_.bodies = {body};
  problem_.reference_body = 0;
  problem_.reference.reset();
  return *this;
}

std::vector<NamedProblem> measured_scenes(RandomNumbers& random) {
  const std::vector<Kind> kinds{{"cylinders", 3, cylinders_figure, cylinders},
                                {"planes", 3, planes_figure, planes},
                                {"line beside", 3, line_beside_figure, line_beside},
                                {"tangents", 2, tangents_figure, tangents},
                                {"lines", 2, lines_figure, lines},
                                {"beside a body", 3, beside_body_figure, beside_body},
                                {"parallel planes", 3, parallel_planes_figure, parallel_planes}};
  std::vector<NamedProblem> scenes;
  for (const Kind& kind : kinds) {
    MeasuredProblem measured(kind.dimension, kind.figure(random));
    kind.state(measured);
    ProblemStatement problem = measured.problem();
    problem.sketch = kind.figure(random);
    scenes.push_back({kind.name, problem});
  }
  return scenes;
}

}  // namespace gcs::samples
