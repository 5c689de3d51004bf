#include "solvers/figures/reflection_classes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "solvers/model/complex_lines.hpp"

namespace {

using gcs::Figure;
using gcs::LinePosition;
using gcs::ProblemStatement;
using gcs::ReflectionClasses;
using gcs::Scene;

constexpr double tolerance = 1e-9;

/// A chain of distances 1 over the points: enough for a scene of size 1.
ProblemStatement problem_of(int dimension, int points, int lines) {
  ProblemStatement problem;
  problem.dimension = dimension;
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  for (int i = 0; i < lines; ++i) problem.lines.push_back("L" + std::to_string(i));
  for (int i = 1; i < points; ++i)
    problem.constraints.push_back({"a" + std::to_string(i), {i - 1, i}, {1, "1"}, false});
  problem.fixed_points.resize(problem.points.size());
  problem.fixed_lines.resize(problem.lines.size());
  return problem;
}

Scene scene_of(int dimension, int points, int lines) {
  return Scene::unchecked(problem_of(dimension, points, lines));
}

Scene anchored_scene(int points, int lines) {
  ProblemStatement problem = problem_of(3, points, lines);
  problem.constraints.resize(1);
  for (int i = 0; i + 1 < points; ++i) problem.fixed_points[i] = Eigen::Vector3d::Unit(i % 3) * 0.5;
  return Scene::unchecked(problem);
}

class RandomFigures {
 public:
  double number() { return distribution_(engine_); }
  Eigen::Vector3d vector() { return {number(), number(), number()}; }

  Figure figure(int dimension, int points, int lines) {
    Figure result;
    result.points = Eigen::Matrix3Xd::Zero(3, points);
    for (int i = 0; i < points; ++i) result.points.col(i).head(dimension) = vector().head(dimension);
    for (int i = 0; i < lines; ++i) result.lines.push_back({vector(), vector().normalized()});
    return result;
  }

  /// The figure after a random rigid motion; its lines are stated by other points and the opposite
  /// directions.
  Figure moved(const Figure& figure, bool mirrored) {
    Eigen::Matrix3d rotation(Eigen::AngleAxisd(number() * 3, vector().normalized()));
    if (mirrored) rotation.row(2) *= -1;
    const Eigen::Vector3d translation = vector();
    Figure result = figure;
    result.points = (rotation * figure.points).colwise() + translation;
    for (LinePosition& line : result.lines) {
      line = {rotation * (line.point + number() * line.direction) + translation,
              -(rotation * line.direction)};
    }
    return result;
  }

 private:
  std::mt19937_64 engine_{7};
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

LinePosition line_along(int axis) { return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Unit(axis)}; }

}  // namespace

namespace {

/// Four points in a plane and two at small heights over it.
Figure nearly_flat(double first, double second) {
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 6);
  figure.points << 0, 4, 1, 3, 0, 3, 0, 0, 3, 4, 2, 2, 0, 0, 0, 0, first, second;
  return figure;
}

/// Classes where all figures have these tolerances.
gcs::ReflectionClasses classes_within(const gcs::ClassTolerance& each, const Scene& scene,
                                      const std::vector<Figure>& figures) {
  std::vector<const Figure*> all;
  for (const Figure& figure : figures) all.push_back(&figure);
  return gcs::reflection_classes(scene, all, std::vector<gcs::ClassTolerance>(all.size(), each));
}

}  // namespace

TEST_CASE("heights over a plane are compared themselves, and not by what distances feel of them") {
  RandomFigures random;
  const Scene scene = scene_of(3, 6, 0);
  for (const double z : {1e-2, 1e-4, 1e-6}) {
    const Figure same = nearly_flat(z, 2 * z), across = nearly_flat(z, -2 * z);
    for (const bool is_mirrored : {false, true}) {
      const std::vector<Figure> figures{same, random.moved(same, is_mirrored), across,
                                        random.moved(across, is_mirrored)};
      CHECK(classes_within({1e-5, 1e-12}, scene, figures).class_of == std::vector<int>{0, 0, 1, 1});
      if (z < 1e-3) CHECK(classes_within({1e-5}, scene, figures).count() == 1);
    }
  }
}

TEST_CASE("figures on a line and noise in their places are one class") {
  RandomFigures random;
  const Scene scene = scene_of(3, 5, 0);
  Figure line;
  line.points = Eigen::Matrix3Xd::Zero(3, 5);
  line.points.row(0) << 0, 1, 3, -2, 0.5;
  std::vector<Figure> figures{line};
  for (int i = 0; i < 20; ++i) {
    Figure noisy = random.moved(line, i % 2 == 0);
    for (double& x : noisy.points.reshaped()) x += 1e-13 * random.number();
    figures.push_back(noisy);
  }
  CHECK(classes_within({1e-9, 1e-12}, scene, figures).count() == 1);
}

TEST_CASE("moved and mirrored figures are one class, others are not") {
  RandomFigures random;
  const Scene scene = scene_of(3, 6, 0);
  const Figure a = random.figure(3, 6, 0);
  const Figure b = random.figure(3, 6, 0);
  const std::vector<Figure> figures{a, b, random.moved(a, true), random.moved(b, false),
                                    random.moved(a, false)};
  const ReflectionClasses classes = gcs::reflection_classes(scene, figures, tolerance);
  CHECK(classes.class_of == std::vector<int>{0, 1, 0, 1, 0});
  CHECK(classes.first == std::vector<int>{0, 1});
  CHECK(classes.count() == 2);
}

TEST_CASE("mirror images in the plane are one class") {
  RandomFigures random;
  const Figure figure = random.figure(2, 5, 0);
  Figure mirrored = figure;
  mirrored.points.row(0) *= -1;
  CHECK(
      gcs::reflection_classes(scene_of(2, 5, 0), std::vector<Figure>{figure, mirrored}, tolerance).count() ==
      1);
}

TEST_CASE("no figures have no classes") {
  CHECK(gcs::reflection_classes(scene_of(3, 4, 0), {}, tolerance).count() == 0);
}

TEST_CASE("a partial mirror image is another class") {
  // Two tetrahedra on one base: the second apex above or below it, all constrained lengths being equal.
  Figure same_side;
  same_side.points.resize(3, 5);
  same_side.points << 0, 1, 0, 0.3, 0.4,  //
      0, 0, 1, 0.3, 0.2,                  //
      0, 0, 0, 1, 0.5;
  Figure other_side = same_side;
  other_side.points(2, 4) *= -1;
  CHECK(gcs::reflection_classes(scene_of(3, 5, 0), std::vector<Figure>{same_side, other_side}, tolerance)
            .count() == 2);
}

TEST_CASE("figures are equal within the tolerance relative to the scene's size") {
  ProblemStatement problem = problem_of(3, 3, 0);
  for (auto& constraint : problem.constraints) constraint.given.value = 1.75;
  const Scene scene = Scene::unchecked(problem);
  RandomFigures random;
  const Figure figure = random.figure(3, 3, 0);
  Figure other = figure;
  const Eigen::Vector3d along = (figure.points.col(1) - figure.points.col(0)).normalized();
  other.points.col(1) += along * scene.size() * 1e-6;
  const std::vector<Figure> figures{figure, other};
  CHECK(gcs::reflection_classes(scene, figures, 1.01e-6).count() == 1);
  CHECK(gcs::reflection_classes(scene, figures, 0.99e-6).count() == 2);
  CHECK(gcs::reflection_classes(scene, std::vector<Figure>{figure, figure}, 0).count() == 1);
}

TEST_CASE("the first figure of a class decides who belongs to it") {
  const Scene scene = scene_of(2, 2, 0);
  std::vector<Figure> figures(3);
  for (int i = 0; i < 3; ++i) {
    figures[i].points = Eigen::Matrix3Xd::Zero(3, 2);
    figures[i].points(0, 1) = 1 + 0.8 * i;  // neighbours are within the tolerance, the ends are not
  }
  CHECK(gcs::reflection_classes(scene, figures, 1).class_of == std::vector<int>{0, 0, 1});
  std::swap(figures[0], figures[1]);
  CHECK(gcs::reflection_classes(scene, figures, 1).class_of == std::vector<int>{0, 0, 0});
}

TEST_CASE("figures that are not finite are classes of their own") {
  RandomFigures random;
  const Figure good = random.figure(3, 4, 0);
  Figure bad = good;
  bad.points(0, 2) = std::numeric_limits<double>::quiet_NaN();
  Figure far = good;
  far.points(0, 2) = std::numeric_limits<double>::max();
  const std::vector<Figure> figures{bad, good, bad, far, good};
  CHECK(gcs::reflection_classes(scene_of(3, 4, 0), figures, tolerance).class_of ==
        std::vector<int>{0, 1, 2, 3, 1});
}

TEST_CASE("a line is the same however it is stated") {
  RandomFigures random;
  const Scene scene = scene_of(3, 5, 2);
  const Figure figure = random.figure(3, 5, 2);
  const std::vector<Figure> figures{figure, random.moved(figure, false), random.moved(figure, true),
                                    random.figure(3, 5, 2)};
  CHECK(gcs::reflection_classes(scene, figures, tolerance).class_of == std::vector<int>{0, 0, 0, 1});
}

TEST_CASE("lines with equal distances to all points of a tetrahedron are told apart") {
  // The three axes have the distance √2 to all four vertices.
  Figure figure;
  figure.points.resize(3, 4);
  figure.points << 1, 1, -1, -1,  //
      1, -1, 1, -1,               //
      1, -1, -1, 1;
  std::vector<Figure> figures(3, figure);
  for (int axis = 0; axis < 3; ++axis) figures[axis].lines = {line_along(axis)};
  CHECK(gcs::reflection_classes(scene_of(3, 4, 1), figures, tolerance).count() == 3);
}

TEST_CASE("the angle between lines through one point counts") {
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, 1);
  figure.lines = {line_along(0), line_along(1)};
  Figure narrow = figure;
  narrow.lines[1].direction = Eigen::Vector3d(1, 1e-4, 0).normalized();
  Figure parallel = figure;
  parallel.lines[1] = line_along(0);
  ProblemStatement problem = problem_of(3, 1, 2);
  problem.constraints = {{"a1", {0, 1}, {1, "1"}, false}};
  const std::vector<Figure> figures{figure, narrow, parallel};
  CHECK(gcs::reflection_classes(Scene::unchecked(problem), figures, tolerance).count() == 3);
}

TEST_CASE("with fixed positions mirror images and moved figures are different") {
  RandomFigures random;
  const Scene scene = anchored_scene(4, 1);
  REQUIRE(scene.is_anchored());
  const Figure figure = random.figure(3, 4, 1);
  Figure restated = figure;
  restated.lines[0] = {figure.lines[0].point + 0.7 * figure.lines[0].direction, -figure.lines[0].direction};
  Figure mirrored = figure;
  mirrored.points.row(2) *= -1;
  Figure turned = figure;
  turned.lines[0].direction = random.vector().normalized();
  const std::vector<Figure> figures{figure, restated, mirrored, turned, random.moved(figure, false)};
  CHECK(gcs::reflection_classes(scene, figures, tolerance).class_of == std::vector<int>{0, 0, 1, 2, 3});
}

TEST_CASE("a complex line is one class and one representative, however it is stated") {
  using Complex = std::complex<double>;
  RandomFigures random;
  const Scene scene = anchored_scene(4, 1);
  const auto with = [&, figure = random.figure(3, 4, 1)](const Eigen::Vector3cd& point,
                                                         const Eigen::Vector3cd& direction) {
    Figure result = figure;
    result.imaginary = Eigen::Matrix3Xd::Zero(3, 4);
    gcs::set_complex_lines({{point, direction}}, result);
    return scene.representative(result);
  };
  // (3, 4i, 0) and (1, 2, 2): squares −7 and 9.
  const Eigen::Vector3cd u(3, Complex(0, 4), 0), v(1, 2, 2), p(Complex(0.5, 0.2), 1, Complex(0, -0.3));
  const Complex unit = std::sqrt(Complex(-7, 0)), along = (u.transpose() * p).value() / unit;
  const std::vector<Figure> figures{with(p, u), with(p + Complex(0.4, -0.7) * u, Complex(-2, 1) * u),
                                    with(p.conjugate(), u.conjugate()), with(p + Complex(0, 1e-3) * v, u),
                                    with(p, u + 1e-3 * v)};
  CHECK(gcs::reflection_classes(scene, figures, tolerance).class_of == std::vector<int>{0, 0, 1, 2, 3});
  for (int i = 0; i < 2; ++i) {
    const gcs::ComplexLine line = gcs::complex_lines(figures[i])[0];
    // (3, 4i, 0)/√−7 is imaginary in x: the orientation with Im x > 0.
    const Eigen::Vector3cd direction = u / unit * (unit.imag() > 0 ? -1.0 : 1.0);
    CHECK((line.direction - direction).norm() <= 1e-14);
    CHECK((line.point - (p - u / unit * along)).norm() <= 1e-14);
  }
}

TEST_CASE("thousands of figures are classified") {
  constexpr int originals = 2500;
  RandomFigures random;
  std::vector<Figure> figures;
  std::vector<int> expected;
  for (int i = 0; i < originals; ++i) {
    figures.push_back(random.figure(3, 8, 0));
    expected.push_back(i);
  }
  for (int i = 0; i < originals; ++i) {
    figures.push_back(random.moved(figures[i], i % 2 == 0));
    expected.push_back(i);
  }
  const ReflectionClasses classes = gcs::reflection_classes(scene_of(3, 8, 0), figures, tolerance);
  CHECK(classes.count() == originals);
  CHECK(classes.class_of == expected);
  CHECK(gcs::reflection_classes(scene_of(3, 8, 0), figures, tolerance, 4).class_of == expected);
}

TEST_CASE("classes are those that comparing every distance of every pair gives") {
  constexpr double near = 1e-3;
  RandomFigures random;
  std::vector<Figure> figures;
  for (int base = 0; base < 12; ++base) {
    const Figure original = random.figure(3, 5, 0);
    for (int i = 0; i < 25; ++i) {
      figures.push_back(original);
      for (double& x : figures.back().points.reshaped()) x += near / 2 * random.number();
    }
  }
  const auto are_equal = [&](const Figure& a, const Figure& b) {
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < i; ++j) {
        const double apart =
            (a.points.col(i) - a.points.col(j)).norm() - (b.points.col(i) - b.points.col(j)).norm();
        if (std::abs(apart) > near) return false;
      }
    return true;
  };
  std::vector<int> first, expected;
  for (int i = 0; i < static_cast<int>(figures.size()); ++i) {
    const auto known =
        std::ranges::find_if(first, [&](int one) { return are_equal(figures[one], figures[i]); });
    expected.push_back(static_cast<int>(known - first.begin()));
    if (known == first.end()) first.push_back(i);
  }
  const Scene scene = scene_of(3, 5, 0);
  REQUIRE(scene.size() == 1);
  CHECK(gcs::reflection_classes(scene, figures, near).class_of == expected);
  CHECK(first.size() > 24);
  CHECK(first.size() < figures.size());
}
