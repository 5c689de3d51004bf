#include "solvers/model/scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// A rotation, in the plane about the z-axis.
Eigen::Matrix3d random_rotation(int dimension, RandomNumbers& random) {
  const double pi = std::acos(-1.0);
  if (dimension == 2)
    return Eigen::AngleAxisd(random.uniform(-pi, pi), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Eigen::Quaterniond q;
  do {
    q.coeffs() << random.point(3, 1), random.uniform(-1, 1);
  } while (q.norm() < 0.1);
  return q.normalized().toRotationMatrix();
}

Figure moved(const Figure& figure, const Eigen::Matrix3d& axes, const Eigen::Vector3d& shift) {
  Figure result = figure;
  result.points = (axes * figure.points).colwise() + shift;
  for (LinePosition& line : result.lines) {
    line.point = axes * line.point + shift;
    line.direction = axes * line.direction;
  }
  return result;
}

/// Mirrored at the plane x = 0.
Eigen::Matrix3d mirror() { return Eigen::Vector3d(-1, 1, 1).asDiagonal(); }

double largest_difference(const Figure& a, const Figure& b) {
  double worst = (a.points - b.points).cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    worst = std::max(worst, (a.lines[i].point - b.lines[i].point).cwiseAbs().maxCoeff());
    worst = std::max(worst, (a.lines[i].direction - b.lines[i].direction).cwiseAbs().maxCoeff());
  }
  return worst;
}

double distance_change(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  double worst = 0;
  for (Eigen::Index i = 0; i < a.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      worst = std::max(worst, std::abs((a.col(i) - a.col(j)).norm() - (b.col(i) - b.col(j)).norm()));
  return worst;
}

/// Twice the signed area of three points, or six times the signed volume of four.
double orientation(int dimension, const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d a = points.col(1) - points.col(0);
  const Eigen::Vector3d b = points.col(2) - points.col(0);
  if (dimension == 2) return a.cross(b).z();
  return a.cross(b).dot(points.col(3) - points.col(0));
}

Figure random_figure(const Scene& scene, RandomNumbers& random) {
  Figure figure;
  figure.points = random.points(scene.dimension(), scene.point_count(), 3);
  for (std::size_t i = 0; i < scene.problem().lines.size(); ++i)
    figure.lines.push_back({random.point(3, 3), random.point(3, 1).normalized()});
  return figure;
}

/// A line and five points, each at a distance from the line, in any reference.
ProblemStatement line_problem() {
  ProblemStatement problem =
      samples::problem_of(3, 5, {{0, 5}, {1, 5}, {2, 5}, {3, 5}, {4, 5}}, {1, 1, 1, 1, 1});
  problem.lines = {"L"};
  return problem;
}

ProblemStatement scaled(ProblemStatement problem, int exponent) {
  for (DistanceConstraint& c : problem.constraints)
    c.given.value = std::ldexp(c.given.value, c.is_squared ? 2 * exponent : exponent);
  problem.sketch->points =
      problem.sketch->points.unaryExpr([=](double x) { return std::ldexp(x, exponent); });
  problem.interpolation.bend = std::ldexp(problem.interpolation.bend, exponent);
  return problem;
}

}  // namespace

TEST_CASE("moving into the frame keeps all distances and the orientation") {
  RandomNumbers random(1);
  for (const int dimension : {2, 3}) {
    const Scene scene = Scene::unchecked(dimension == 2 ? samples::k33() : samples::octahedron());
    double worst = 0;
    int mirrored = 0;
    for (int sample = 0; sample < 500; ++sample) {
      const Figure figure = random_figure(scene, random);
      const Figure framed = scene.in_frame(figure);
      worst = std::max(worst, distance_change(figure.points, framed.points));
      if (orientation(dimension, figure.points) * orientation(dimension, framed.points) < 0) ++mirrored;
      CHECK(framed.points.col(0).isZero(0));
      CHECK(framed.points(0, 1) > 0);
      CHECK(framed.points.col(1).tail<2>().isZero(0));
      if (dimension == 3) CHECK((framed.points(1, 2) > 0 && framed.points(2, 2) == 0));
    }
    CHECK(worst <= 1e-14);
    CHECK(mirrored == 0);
  }
}

TEST_CASE("a figure in the frame stays where it is") {
  RandomNumbers random(2);
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron(), line_problem()}) {
    const Scene scene = Scene::unchecked(problem);
    double worst = 0;
    for (int sample = 0; sample < 200; ++sample) {
      const Figure once = scene.in_frame(random_figure(scene, random));
      worst = std::max(worst, largest_difference(scene.in_frame(once), once));
    }
    CHECK(worst <= 1e-14);
  }
}

TEST_CASE("another reference gives another frame of the same figure") {
  RandomNumbers random(3);
  const Scene scene(samples::octahedron());
  const Reference reference{4, 2, 5};
  const Figure figure = random_figure(scene, random);
  const Figure framed = scene.in_frame(figure, reference);
  CHECK(distance_change(figure.points, framed.points) <= 1e-14);
  CHECK(framed.points.col(4).isZero(0));
  CHECK(framed.points.col(2).tail<2>().isZero(0));
  CHECK(framed.points(2, 5) == 0);
  CHECK(largest_difference(scene.in_frame(framed), scene.in_frame(figure)) <= 1e-14);
}

TEST_CASE("a line as reference becomes the x-axis, its height point goes to the z-axis") {
  RandomNumbers random(4);
  const Scene scene = Scene::unchecked(line_problem());
  CHECK(scene.reference().line == 0);
  CHECK(scene.reference().height == 0);
  for (int sample = 0; sample < 200; ++sample) {
    const Figure figure = random_figure(scene, random);
    const Figure framed = scene.in_frame(figure);
    CHECK(distance_change(figure.points, framed.points) <= 1e-14);
    CHECK(orientation(3, figure.points) * orientation(3, framed.points) > 0);
    CHECK(framed.points.col(0).head<2>().isZero(0));
    CHECK(framed.points(2, 0) > 0);
    for (int p = 0; p < 5; ++p) {
      const Eigen::Vector3d off = figure.points.col(p) - figure.lines[0].point;
      CHECK(framed.points.col(p).tail<2>().norm() ==
            Approx(off.cross(figure.lines[0].direction).norm()).epsilon(1e-12));
    }
  }
}

TEST_CASE("the representative of a class does not depend on position or mirror image") {
  RandomNumbers random(5);
  ProblemStatement two_lines = line_problem();
  two_lines.lines = {"L", "M"};
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron(), line_problem(), two_lines}) {
    const Scene scene = Scene::unchecked(problem);
    double worst = 0;
    for (int sample = 0; sample < 300; ++sample) {
      const Figure figure = random_figure(scene, random);
      const Figure expected = scene.representative(figure);
      Eigen::Matrix3d axes = random_rotation(scene.dimension(), random);
      if (random.sign() > 0) axes = axes * mirror();
      Figure other = moved(figure, axes, random.point(scene.dimension(), 5));
      // The direction of a line is up to sign.
      for (LinePosition& line : other.lines)
        if (random.sign() > 0) line.direction = -line.direction;
      worst = std::max(worst, largest_difference(scene.representative(other), expected));
    }
    // A reference point close to the line through the others is the worst case of these samples.
    CHECK(worst <= 1e-10);
  }
}

TEST_CASE("the first point off the mirror is on its positive side") {
  const Scene scene(samples::octahedron());
  Figure figure = *scene.sketch();
  CHECK(scene.representative(figure).points(2, 3) > 0);
  figure.points.row(2) *= -1;
  CHECK(scene.representative(figure).points(2, 3) > 0);
  figure.points(2, 3) = 0;
  CHECK(scene.representative(figure).points(2, 4) > 0);
}

TEST_CASE("scaling the file by a power of two changes no bit of the scene") {
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron()}) {
    const Scene scene = Scene::unchecked(problem);
    for (const int exponent : {-900, -37, -1, 1, 40, 900}) {
      const Scene other = Scene::unchecked(scaled(problem, exponent));
      CHECK(other.unit_exponent() == scene.unit_exponent() + exponent);
      CHECK(other.target_lengths() == scene.target_lengths());
      CHECK(other.sketch()->points == scene.sketch()->points);
      CHECK(other.size() == scene.size());
      for (int i = 0; i < scene.constraint_count(); ++i) {
        CHECK(other.length_paths()[i].at_sketch == scene.length_paths()[i].at_sketch);
        CHECK(other.length_paths()[i].bend == scene.length_paths()[i].bend);
      }
    }
  }
}

TEST_CASE("squared lengths scale like lengths") {
  ProblemStatement problem = samples::octahedron();
  for (DistanceConstraint& c : problem.constraints) {
    c.is_squared = true;
    c.given.value *= c.given.value;
  }
  const Scene scene = Scene::unchecked(problem);
  const Scene other = Scene::unchecked(scaled(problem, 200));
  CHECK(other.unit_exponent() == scene.unit_exponent() + 200);
  CHECK(other.target_lengths() == scene.target_lengths());
}

TEST_CASE("lengths of 1e-300 and 1e300 become lengths near 1 and back") {
  for (const double size : {1e-300, 1e300}) {
    ProblemStatement problem =
        samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {4 * size, 3 * size, 5 * size});
    Figure sketch;
    sketch.points = Eigen::Matrix3Xd::Zero(3, 3);
    sketch.points.col(1) << 0, 4 * size, 0;
    sketch.points.col(2) << 3 * size, 0, 0;
    problem.sketch = sketch;
    const Scene scene = Scene::unchecked(problem);
    for (int i = 0; i < 3; ++i) {
      CHECK(scene.target_lengths()[i] >= 0.5);
      CHECK(scene.target_lengths()[i] < 2);
      CHECK(std::ldexp(scene.target_lengths()[i], scene.unit_exponent()) ==
            problem.constraints[i].given.value);
      CHECK(scene.length_paths()[i].at_sketch == Approx(scene.length_paths()[i].at_target).epsilon(1e-14));
    }
    const Figure back = scene.in_file_unit(*scene.sketch());
    CHECK(back.points(0, 1) == Approx(4 * size).epsilon(1e-14));
    CHECK(back.points(1, 2) == Approx(-3 * size).epsilon(1e-14));
  }
}

TEST_CASE("the lengths travel from the sketch's to the given ones, one of them bent") {
  ProblemStatement problem = samples::octahedron();
  for (const int bent : {-1, 4}) {
    problem.interpolation = {bent, 3};
    const Scene scene = Scene::unchecked(problem);
    const double unit = std::ldexp(1.0, scene.unit_exponent());
    for (int i = 0; i < scene.constraint_count(); ++i) {
      const LengthPath& path = scene.length_paths()[i];
      const auto [a, b] = problem.constraints[i].between;
      const double start = (problem.sketch->points.col(a) - problem.sketch->points.col(b)).norm();
      const double end = problem.constraints[i].given.value;
      CHECK(path.value(0) * unit == Approx(start).epsilon(1e-14));
      CHECK(path.value(1) * unit == end);
      // [I] Definition 1 at t = 2 and its derivative at t = 1/2
      const double bend = i == (bent < 0 ? 11 : bent) ? 3 : 0;
      CHECK(path.value(2) * unit == Approx(-4 * bend + 2 * (end - start + bend) + start).epsilon(1e-13));
      CHECK(path.slope(0.5) * unit == Approx(end - start).margin(1e-13));
    }
  }
}

TEST_CASE("the default reference is the first triple of pairwise constrained points") {
  ProblemStatement problem = samples::octahedron();
  problem.reference.reset();
  const Reference triangle = Scene::unchecked(problem).reference();
  CHECK(triangle.origin == 0);
  CHECK(triangle.axis == 1);
  CHECK(triangle.plane == 2);

  problem = samples::k33();
  problem.reference.reset();
  CHECK(Scene::unchecked(problem).reference().origin == 0);
  CHECK(Scene::unchecked(problem).reference().axis == 1);
  CHECK(Scene::unchecked(problem).reference().plane == -1);

  // Only the last constraints close a triangle.
  problem = samples::problem_of(3, 4, {{0, 1}, {0, 3}, {1, 2}, {2, 3}, {1, 3}}, {1, 1, 1, 1, 1});
  CHECK(Scene::unchecked(problem).reference().origin == 0);
  CHECK(Scene::unchecked(problem).reference().axis == 1);
  CHECK(Scene::unchecked(problem).reference().plane == 3);
}

TEST_CASE("three points in a line are no frame where others are") {
  // 0, 1 and 2 are; 1, 2 and 3 are not.
  const samples::Edges edges{{0, 1}, {1, 2}, {0, 2}, {1, 3}, {2, 3}};
  const Reference triangle = Scene::unchecked(samples::problem_of(3, 4, edges, {1, 2, 3, 2, 2})).reference();
  CHECK(triangle.origin == 1);
  CHECK(triangle.axis == 2);
  CHECK(triangle.plane == 3);
  // 3 is constrained with 0 and 1 alone.
  const Reference loose =
      Scene::unchecked(samples::problem_of(3, 4, {{0, 1}, {1, 2}, {0, 2}, {0, 3}}, {0.1, 0.2, 0.3, 1}))
          .reference();
  CHECK(loose.origin == 0);
  CHECK(loose.axis == 1);
  CHECK(loose.plane == 3);
}

TEST_CASE("a graph without triangles is put into a frame by its first points") {
  samples::Edges edges;
  for (int a = 0; a < 4; ++a)
    for (int b = 4; b < 10; ++b) edges.push_back({a, b});
  const Scene scene = Scene::unchecked(samples::problem_of(3, 10, edges, std::vector<double>(24, 1)));
  CHECK(scene.reference().origin == 0);
  CHECK(scene.reference().axis == 1);
  CHECK(scene.reference().plane == 2);
}

TEST_CASE("given positions are kept as they are") {
  ProblemStatement problem = samples::problem_of(2, 3, {{0, 2}, {1, 2}}, {5, 5});
  problem.fixed_points = {Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(-3, 2, 0), std::nullopt};
  const Scene scene = Scene::unchecked(problem);
  CHECK(scene.is_anchored());
  RandomNumbers random(6);
  const Figure figure = random_figure(scene, random);
  CHECK(scene.in_frame(figure).points == figure.points);
  CHECK(scene.representative(figure).points == figure.points);
  CHECK(std::ldexp((*scene.fixed_point(0))[1], scene.unit_exponent()) == 2);
  CHECK_FALSE(scene.fixed_point(2));
}
