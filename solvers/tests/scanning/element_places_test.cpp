/// Closed forms of places against figures that are known: the element's own place is among them.

#include "solvers/scanning/element_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "solvers/construction/closed_forms.hpp"
#include "solvers/tests/random_numbers.hpp"

namespace gcs {
namespace {

/// Three elements of each kind to build on, and the one to be placed, the last of its kind.
struct KnownFigure {
  ProblemStatement problem;
  Figure figure;

  KnownFigure(int dimension, samples::RandomNumbers& random) {
    problem.dimension = dimension;
    figure.points = random.points(dimension, 4, 2);
    for (int i = 0; i < 4; ++i) {
      problem.points.push_back("p" + std::to_string(i));
      problem.lines.push_back("l" + std::to_string(i));
      const Eigen::Vector3d through = random.point(dimension, 1);
      figure.lines.push_back({through, random.point(dimension, 1).normalized()});
      if (dimension == 2) continue;
      problem.planes.push_back("h" + std::to_string(i));
      const Eigen::Vector3d normal = random.point(3, 1).normalized();
      figure.planes.push_back({normal, random.uniform(-1, 1)});
    }
  }

  LinePosition& line(int entity) { return figure.lines[static_cast<std::size_t>(problem.line_of(entity))]; }
  PlanePosition& plane(int entity) {
    return figure.planes[static_cast<std::size_t>(problem.plane_of(entity))];
  }
  Eigen::Vector3d direction(int entity) {
    return problem.is_line(entity) ? line(entity).direction : plane(entity).normal;
  }

  double distance(int a, int b) {
    if (!problem.is_point(a)) std::swap(a, b);
    const Eigen::Vector3d p = figure.points.col(a);
    if (problem.is_point(b)) return (p - figure.points.col(b)).norm();
    if (problem.is_line(b)) return (p - line(b).point).cross(line(b).direction).norm();
    return plane(b).normal.dot(p) - plane(b).offset;
  }
  double product(int a, int b) {
    const double product = direction(a).dot(direction(b));
    return problem.is_plane(a) && problem.is_plane(b) ? product : std::abs(product);
  }
  void make_incident(int element, int other) {
    if (problem.is_point(element))
      figure.points.col(element) = line(other).point + 0.7 * line(other).direction;
    else
      line(element).point = figure.points.col(other);
  }
  void make_parallel(int element, int other) {
    if (problem.is_line(element))
      line(element).direction = direction(other);
    else
      plane(element).normal = direction(other);
  }

  double apart(int element, const Figure& placed) {
    KnownFigure other = *this;
    other.figure = placed;
    if (problem.is_point(element)) return (figure.points.col(element) - placed.points.col(element)).norm();
    if (problem.is_plane(element))
      return (direction(element) - other.direction(element)).norm() +
             std::abs(plane(element).offset - other.plane(element).offset);
    return direction(element).cross(other.direction(element)).norm() +
           (line(element).point - other.line(element).point).cross(direction(element)).norm();
  }
};

/// By a letter each, in the order in which an instruction has them: p, h and l are a distance from the next point, plane
/// and line; o is on, or through, it; x and y a product with the next plane and line; d a direction of the next line.
struct KnownStep {
  int dimension;
  char kind;  ///< p, l or h
  std::string given;
  int angles;
};

ElementStep step_of(const KnownStep& known, KnownFigure& figure) {
  ElementStep step;
  step.place = known.kind == 'p' ? 3 : known.kind == 'l' ? 7 : 11;
  step.angles = known.angles;
  if (known.dimension == 2 && known.kind == 'p') step.zeros = {2};
  int point = 0, line = 4, plane = 8;
  const int on = known.dimension == 3 ? 2 : 1;
  const auto next_for = [&](char letter) {
    const bool is_point = letter == 'p' || (letter == 'o' && known.kind == 'l');
    return is_point ? point++ : letter == 'h' || letter == 'x' ? plane++ : line++;
  };
  std::vector<std::pair<char, int>> others;
  for (const char letter : known.given) others.emplace_back(letter, next_for(letter));
  for (const auto& [letter, other] : others) {
    if (letter == 'd') figure.make_parallel(step.place, other);
    if (letter == 'o' && (known.kind == 'p' || other == 0)) figure.make_incident(step.place, other);
    if (letter == 'o' && known.kind == 'l' && other > 0)
      figure.figure.points.col(other) =
          figure.line(step.place).point + 0.6 * figure.line(step.place).direction;
  }
  for (const auto& [letter, other] : others) {
    if (letter == 'd')
      step.given.push_back({other, MetBy::one_direction, 0, on, -1});
    else if (letter == 'o')
      step.given.push_back({other, MetBy::distance, 0, on, -1});
    else if (letter == 'x' || letter == 'y')
      step.given.push_back({other, MetBy::product, figure.product(step.place, other), 1, -1});
    else
      step.given.push_back({other, MetBy::distance, figure.distance(step.place, other), 1, -1});
  }
  return step;
}

/// Of all places the nearest to the known one; over a grid of the step's angle, if it has one.
double nearest_place(const KnownStep& known, samples::RandomNumbers& random, double degrees) {
  KnownFigure figure(known.dimension, random);
  const ElementStep step = step_of(known, figure);
  const auto used =
      used_in_closed_form(figure.problem, step.place, static_cast<int>(step.zeros.size()), step.given);
  CHECK(used.size() == step.given.size());
  const Scene scene = Scene::unchecked(figure.problem);
  const ElementPlaces places(scene, 0);
  double nearest = std::numeric_limits<double>::infinity();
  const auto count = known.angles == 0 ? 1 : static_cast<int>(360 / degrees);
  for (int i = 0; i < count; ++i) {
    const double angle = i * degrees * std::numbers::pi / 180 - std::numbers::pi;
    for (const PlacedElement& placed : places.of(step, figure.figure, {angle, 0}))
      nearest = std::min(nearest, figure.apart(step.place, placed.figure));
  }
  return nearest;
}

}  // namespace

TEST_CASE("the place of an element is among those that its instruction finds") {
  const std::vector<KnownStep> steps{
      {3, 'p', "ppp", 0}, {3, 'p', "pph", 0}, {3, 'p', "phh", 0}, {3, 'p', "hhh", 0}, {3, 'p', "po", 0},
      {3, 'p', "ho", 0},  {3, 'p', "lo", 0},  {3, 'p', "ppl", 0}, {3, 'p', "phl", 0}, {3, 'p', "hhl", 0},
      {3, 'h', "ppp", 0}, {3, 'h', "ppx", 0}, {3, 'h', "ppy", 0}, {3, 'h', "pxx", 0}, {3, 'h', "pxy", 0},
      {3, 'h', "pd", 0},  {3, 'l', "oo", 0},  {3, 'l', "opp", 0}, {3, 'l', "opx", 0}, {3, 'l', "oxy", 0},
      {3, 'l', "oyy", 0}, {3, 'l', "od", 0},  {3, 'l', "ppd", 0}, {2, 'p', "pp", 0},  {2, 'p', "pl", 0},
      {2, 'p', "ll", 0},  {2, 'l', "pp", 0},  {2, 'l', "py", 0},  {2, 'l', "pd", 0}};
  samples::RandomNumbers random(61);
  for (const KnownStep& known : steps)
    for (int i = 0; i < 5; ++i) {
      CAPTURE(known.dimension, known.kind, known.given, i);
      CHECK(nearest_place(known, random, 0) <= 1e-9);
    }
}

TEST_CASE("the place of an element is near one of an angle of its instruction's grid") {
  const std::vector<KnownStep> steps{{3, 'p', "pp", 1}, {3, 'p', "ph", 1}, {3, 'p', "pl", 1},
                                     {3, 'p', "hl", 1}, {3, 'p', "ll", 1}, {3, 'h', "pp", 1},
                                     {3, 'h', "py", 1}, {3, 'l', "op", 1}, {3, 'l', "pd", 1}};
  samples::RandomNumbers random(62);
  for (const KnownStep& known : steps)
    for (int i = 0; i < 5; ++i) {
      CAPTURE(known.given, known.kind, i);
      const double coarse = nearest_place(known, random, 0.5);
      CHECK(coarse <= 0.2);
    }
}

}  // namespace gcs
