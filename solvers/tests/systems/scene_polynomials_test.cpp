#include "solvers/systems/scene_polynomials.hpp"

#include <catch2/catch.hpp>

#include "solvers/elements/scene_system.hpp"

using namespace gcs;

namespace {

/// A triangle with sides 3, 4 and 5, and a plane of which every corner is at its own distance.
ProblemStatement triangle_and_plane(const std::vector<std::string>& distances) {
  ProblemStatement problem;
  problem.dimension = 3;
  problem.points = {"a", "b", "c"};
  problem.planes = {"h"};
  problem.reference = Reference{0, 1, 2};
  problem.constraints = {
      {"ab", {0, 1}, {4, "4"}, false}, {"ac", {0, 2}, {3, "3"}, false}, {"bc", {1, 2}, {25, "25"}, true}};
  for (int point = 0; point < 3; ++point) {
    const std::string& text = distances[static_cast<std::size_t>(point)];
    problem.relations.push_back({"h" + std::to_string(point),
                                 "distance",
                                 {{point}, {3}},
                                 Relation::Form::length,
                                 {std::stod(text), text}});
  }
  return problem;
}

Figure figure_with(const Scene& scene, const Eigen::Vector3d& normal, double offset) {
  Figure figure;
  figure.points.resize(3, 3);
  figure.points << 0, 4, 0, 0, 0, 3, 0, 0, 0;
  figure.planes = {{normal, offset}};
  return scene.in_scene_unit(figure);
}

/// How many equations the polynomials say that the figure meets, exactly.
int met_equations(const Scene& scene, const Figure& figure) {
  const SceneSystem system(scene);
  REQUIRE_FALSE(why_no_polynomials(system.equations()));
  std::vector<Rational> point;
  for (const std::complex<double>& value : system.coordinates(figure))
    point.push_back(Rational::from_double(value.real()));
  int met = 0;
  for (const RationalPolynomial& equation : polynomials_of(system.equations()).equations)
    met += equation.value(point).is_zero() ? 1 : 0;
  return met;
}

}  // namespace

TEST_CASE("a figure whose coordinates are fractions makes the polynomials of its scene vanish") {
  // n·x − h at the corners, for the plane x = −1/2 and for z = 1.
  const Scene upright = Scene::unchecked(triangle_and_plane({"0.5", "4.5", "0.5"}));
  const Scene level = Scene::unchecked(triangle_and_plane({"-1", "-1", "-1"}));
  const Figure at_x = figure_with(upright, Eigen::Vector3d::UnitX(), -0.5),
               at_z = figure_with(level, Eigen::Vector3d::UnitZ(), 1);
  CHECK(met_equations(upright, at_x) == 7);
  CHECK(met_equations(level, at_z) == 7);
  CHECK(met_equations(upright, at_z) == 4);  // all but the distances from the plane
  CHECK(met_equations(level, at_x) == 4);
}

TEST_CASE("numbers that doubles do not hold are taken as the file writes them") {
  const Scene scene = Scene::unchecked(triangle_and_plane({"0.1", "4.1", "0.1"}));
  // The offset −0.1 is not a double, so the distances are met to rounding and not exactly.
  CHECK(met_equations(scene, figure_with(scene, Eigen::Vector3d::UnitX(), -0.1)) == 4);
}

TEST_CASE("an angle in degrees has no polynomial, its cosine has") {
  ProblemStatement problem = triangle_and_plane({"1", "1", "1"});
  problem.planes.push_back("g");
  Relation angle{"angle", "angle", {{3}, {4}}, Relation::Form::degrees, {50, "50"}};
  problem.relations.push_back(angle);
  const Scene in_degrees = Scene::unchecked(problem);
  CHECK(why_no_polynomials(SceneSystem(in_degrees).equations()).value_or("").find("degrees") !=
        std::string::npos);
  problem.relations.back() = {"angle", "angle", {{3}, {4}}, Relation::Form::cosine, {0.6, "0.6"}};
  const Scene with_cosine = Scene::unchecked(problem);
  CHECK_FALSE(why_no_polynomials(SceneSystem(with_cosine).equations()));
}
