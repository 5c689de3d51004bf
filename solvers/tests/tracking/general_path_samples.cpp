#include "solvers/tests/tracking/general_path_samples.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solvers/figures/general_figures.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/tracking/slow_general_path.hpp"

namespace gcs::samples {
namespace {

/// Both bodies somewhere, and their points nearly where that puts them.
Figure random_posture(const ProblemStatement& platform, RandomNumbers& random) {
  Figure figure{Eigen::Matrix3Xd(3, 0), {}};
  for (const RigidBody& body : platform.bodies) {
    const Eigen::Quaterniond turn = samples::random_turn(platform.dimension, random);
    const Eigen::Vector3d shift = random.point(platform.dimension, 1);
    Eigen::Matrix3Xd placed = (turn.toRotationMatrix() * points_of(body)).colwise() + shift;
    placed += random.points(platform.dimension, static_cast<int>(placed.cols()), 0.01);
    figure.points.conservativeResize(3, figure.points.cols() + placed.cols());
    figure.points.rightCols(placed.cols()) = placed;
  }
  return figure;
}

Figure points_and_lines(RandomNumbers& random) {
  Figure figure{random.points(3, 3, 2), {}};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d point = random.point(3, 2);
    figure.lines.push_back({point, random.point(3, 1).normalized()});
  }
  return figure;
}

}  // namespace

ProblemStatement sketched_points_and_lines(RandomNumbers& random) {
  const Figure target = points_and_lines(random);
  ProblemStatement problem;
  problem.points = {"p0", "p1", "p2"};
  problem.lines = {"L0", "L1", "L2"};
  problem.reference = Reference{0, 1, 2};
  const auto line = [&](int i) { return target.lines[static_cast<std::size_t>(i)]; };
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const std::string name = std::to_string(a) + std::to_string(b);
      if (a < b)
        problem.constraints.push_back(
            {"p" + name, {a, b}, {(target.points.col(a) - target.points.col(b)).norm(), ""}, false});
      const Eigen::Vector3d arm = target.points.col(a) - line(b).point;
      problem.relations.push_back({"l" + name,
                                   "distance",
                                   {{a}, {3 + b}},
                                   Relation::Form::length,
                                   {arm.cross(line(b).direction).norm(), ""}});
      if (a < b)
        problem.relations.push_back({"a" + name,
                                     "angle",
                                     {{3 + a}, {3 + b}},
                                     Relation::Form::cosine,
                                     {std::abs(line(a).direction.dot(line(b).direction)), ""}});
    }
  problem.sketch = points_and_lines(random);
  return problem;
}

ProblemStatement sketched(ProblemStatement problem, RandomNumbers& random) {
  if (!problem.bodies.empty()) {
    problem.sketch = random_posture(problem, random);
    return problem;
  }
  problem.sketch = Figure{random.points(3, static_cast<int>(problem.points.size()), 2), {}};
  for (std::size_t i = 0; i < problem.planes.size(); ++i)
    problem.sketch->planes.push_back({random.point(3, 1).normalized(), random.uniform(-1, 1)});
  return problem;
}

std::vector<ProblemStatement> sample_scenes(std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<ProblemStatement> problems;
  for (const int dimension : {2, 3})
    problems.push_back(sketched(samples::random_platform(dimension, random), random));
  for (const int planes : {1, 2, 3})
    problems.push_back(sketched(samples::random_octahedral(planes, random), random));
  return problems;
}

std::string name_of(const ProblemStatement& problem) {
  return std::to_string(problem.dimension) + "D, " + std::to_string(problem.planes.size()) + " planes, " +
         std::to_string(problem.bodies.size()) + " bodies";
}

ProblemStatement corner_of_lines(double sketched, double of_l, double of_m) {
  const Operand o{0}, a{1}, p{2}, line_l{4}, line_m{5}, o_a{0, 1};
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"o", "a", "p", "b"};
  problem.lines = {"L", "M"};
  problem.reference = Reference{0, 3};
  problem.constraints = {
      {"oa", {0, 1}, {1, ""}, false}, {"ob", {0, 3}, {1, ""}, false}, {"ab", {1, 3}, {1, ""}, false}};
  problem.interpolation.bend = 0;
  using R = Relation;
  problem.relations = {{"oL", "on", {o, line_l}},
                       {"aM", "on", {a, line_m}},
                       {"pL", "on", {p, line_l}},
                       {"pM", "on", {p, line_m}},
                       {"l", "angle", {o_a, line_l}, R::Form::degrees, {of_l, ""}},
                       {"m", "angle", {o_a, line_m}, R::Form::degrees, {of_m, ""}}};
  const auto direction = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  };
  const Eigen::Vector3d u = direction(sketched), v = direction(of_m);
  const double lambda = v.y() / u.cross(v).z();  // λ u = a + μ v
  Figure sketch{Eigen::Matrix3Xd::Zero(3, 4), {{Eigen::Vector3d::Zero(), u}, {Eigen::Vector3d::UnitX(), v}}};
  sketch.points.col(1) = Eigen::Vector3d::UnitX();
  sketch.points.col(2) = lambda * u;
  sketch.points.col(3) = direction(60);
  problem.sketch = sketch;
  return problem;
}

ProblemStatement with_orientation(ProblemStatement problem) {
  Relation relation{"o", "orientation", {}};
  for (int point = 0; point <= problem.dimension; ++point) relation.of.push_back({point});
  relation.sign = 1;
  problem.relations.push_back(relation);
  return problem;
}

ProblemStatement renamed_and_scaled(const ProblemStatement& problem) {
  ProblemStatement other = problem;
  const int last = static_cast<int>(problem.constraints.size()) - 1;
  other.interpolation = {0, 8 * problem.interpolation.bend};
  std::ranges::reverse(other.constraints);
  std::ranges::reverse(other.relations);
  REQUIRE(bent_lengths(problem)[0].constraint == last);
  const auto scale = [](Decimal& length) { length.value *= 8; };
  for (DistanceConstraint& c : other.constraints) scale(c.given);
  for (Relation& r : other.relations)
    if (r.form == Relation::Form::length) scale(r.given);
  for (RigidBody& body : other.bodies)
    for (BodyElement& element : body.elements) std::ranges::for_each(element.numbers, scale);
  other.sketch = problem.sketch->scaled(3);
  for (std::string& name : other.points) name += "'";
  return other;
}

Answer followed(const ProblemStatement& problem, const OptionMap& options) {
  return solve(Scene::unchecked(problem), "full-space", options);
}

bool are_alike(const Scene& scene, const Figure& a, const Figure& b) {
  const Scene framed = in_frame_of_elements(scene);
  const std::vector<Figure> figures{framed.in_frame(a), framed.in_frame(b)};
  const std::vector<GeneralTolerance> tolerances(2, {1e-6});
  return general_classes(framed, figures, tolerances).count() == 1;
}

std::vector<Figure> crossed(const Answer& answer) {
  std::vector<Figure> figures;
  for (const AssessedCrossing& crossing : answer.crossings)
    figures.push_back(answer.solutions[static_cast<std::size_t>(*crossing.solution)].figure);
  return figures;
}

void check_same_crossings(const Scene& scene, const std::vector<Figure>& one,
                          const std::vector<Figure>& other) {
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(are_alike(scene, one[i], other[i]));
}

}  // namespace gcs::samples
