/// S of general scenes against monodromy, against another way to track it, and against geometry.

#include "solvers/tracking/general_path.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/general_figures.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/tracking/slow_general_path.hpp"
#include "solvers/tracking/real_equations.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

using namespace gcs;
using samples::points_of;
using samples::RandomNumbers;
using samples::SlowPath;

namespace {

Answer followed(const ProblemStatement& problem, const OptionMap& options = {}) {
  return solve(Scene::unchecked(problem), "full-space", options);
}

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

/// Whether two figures are one solution, to a millionth.
bool are_alike(const Scene& scene, const Figure& a, const Figure& b) {
  const std::vector<Figure> figures{a, b};
  const std::vector<double> tolerances(2, 1e-6);
  return general_classes(scene, figures, tolerances).count() == 1;
}

/// Of each crossing its figure, in the order met.
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

/// The coordinates that the frame of three points makes zero are.
ProblemStatement with_sketch_in_frame(ProblemStatement problem) {
  const Scene scene = Scene::unchecked(problem);
  problem.sketch = scene.in_file_unit(*scene.sketch());
  return problem;
}

// ---- a corner p of lines L through o and M through a, of which L turns

const Operand o{0}, a{1}, p{2}, line_l{4}, line_m{5}, o_a{0, 1};

/// Angles in degrees between the lines and o–a; the sketch has L at `sketched` degrees to it, counterclockwise. o, a and
/// b are a triangle, whose sides do not change.
ProblemStatement corner(double sketched, double of_l, double of_m) {
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

}  // namespace

TEST_CASE("S of a general scene is closed, and meets solutions that monodromy finds") {
  std::size_t met = 0;
  for (const std::uint64_t seed : {21U, 22U, 23U})
    for (const ProblemStatement& problem : sample_scenes(seed)) {
      const Answer on_path = followed(problem);
      CAPTURE(name_of(problem), seed, on_path.reason);
      CHECK(on_path.status == RunStatus::complete);
      CHECK(on_path.failed_checks.empty());
      REQUIRE(on_path.ends.size() == 1);
      CHECK(on_path.ends[0].end == PathRecord::End::closed);
      CHECK(on_path.crossings.size() % 2 == 0);
      const Scene scene = Scene::unchecked(problem);
      const Answer all = solve(scene, "monodromy");
      for (const Figure& figure : crossed(on_path))
        CHECK(std::ranges::count_if(all.solutions, [&](const AssessedSolution& one) {
                return one.is_real() && are_alike(scene, figure, one.figure);
              }) == 1);
      met += on_path.crossings.size();
    }
  CHECK(met >= 10);
}

TEST_CASE("S of a general scene does not depend on orders, tolerances and steps") {
  for (const ProblemStatement& problem : sample_scenes(24)) {
    const std::vector<Figure> expected = crossed(followed(problem));
    for (const OptionMap& options :
         {OptionMap{{"order", "20"}}, OptionMap{{"tolerance", "1e-11"}}, OptionMap{{"step_max", "0.05"}}}) {
      CAPTURE(name_of(problem), options.begin()->first);
      check_same_crossings(Scene::unchecked(problem), crossed(followed(problem, options)), expected);
    }
    std::vector<Figure> backward = crossed(followed(problem, {{"orientation", "backward"}}));
    std::ranges::reverse(backward);
    CAPTURE(name_of(problem));
    check_same_crossings(Scene::unchecked(problem), backward, expected);
  }
}

TEST_CASE("tiny steps by geometry meet the same solutions of general scenes in the same order") {
  for (const std::uint64_t seed : {25U})
    for (const ProblemStatement& random : sample_scenes(seed)) {
      const ProblemStatement problem = random.bodies.empty() ? with_sketch_in_frame(random) : random;
      const Scene scene = Scene::unchecked(problem);
      const Answer answer = followed(problem);
      std::vector<Figure> expected = crossed(answer);
      if (expected.empty()) continue;
      expected.push_back(expected.front());  // once more round
      const auto slow = SlowPath(problem).crossings(expected.size());
      CAPTURE(name_of(problem), seed);
      std::vector<Figure> met;
      for (const auto& [figure, direction] : slow) met.push_back(scene.in_scene_unit(figure));
      check_same_crossings(scene, met, expected);
      for (std::size_t i = 0; i < answer.crossings.size(); ++i)
        CHECK(slow[i].second == answer.crossings[i].direction);
    }
}

TEST_CASE("names, orders and units of a general scene do not change S") {
  for (const ProblemStatement& problem : sample_scenes(27)) {
    CAPTURE(name_of(problem));
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
    check_same_crossings(Scene::unchecked(problem), crossed(followed(other)), crossed(followed(problem)));
  }
}

TEST_CASE("a sketch is moved to where the constraints without a value hold") {
  ProblemStatement problem = corner(60, 40, 80);
  problem.sketch->points.col(2) += Eigen::Vector3d(2e-4, -3e-4, 0);
  const Scene scene = Scene::unchecked(problem);
  const SceneSystem system(scene);
  const auto start = sketched_unknowns(scene, system);
  REQUIRE(start);
  CHECK(start->moved > 1e-5);
  CHECK(start->moved < 1e-3);
  const RealEquations equations = real_equations(system.equations());
  const Eigen::VectorXd excess = equations.sums(start->x) - equations.given;
  for (std::size_t e = 0; e < system.value_of().size(); ++e)
    if (system.value_of()[e] == no_value) CHECK(std::abs(excess[static_cast<Eigen::Index>(e)]) <= 1e-14);
}

TEST_CASE("where a point goes to infinity on both sides S ends there, and is complete") {
  // L turns about o from 60° as far as 80° − 180° and 80°, where it is parallel to M.
  struct Sample {
    double of_l;
    std::size_t solutions;
  };
  for (const auto& [of_l, solutions] : {Sample{40, 2}, Sample{79, 2}, Sample{85, 1}}) {
    const Answer answer = followed(corner(60, of_l, 80));
    CAPTURE(of_l, answer.reason);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.failed_checks.empty());
    REQUIRE(answer.ends.size() == 1);
    CHECK(answer.ends[0].end == PathRecord::End::at_infinity);
    CHECK(answer.solutions.size() == solutions);
  }
}

TEST_CASE("a crossing at which a segment points the other way is met, and not as stated") {
  ProblemStatement problem = samples::point_at_an_angle(50);
  problem.sketch = Figure{Eigen::Matrix3Xd::Zero(3, 4), {}};
  problem.sketch->points.col(1) << 1, 0, 0;
  problem.sketch->points.col(2) << 0.5, std::sqrt(0.75), 0;
  problem.sketch->points.col(3) << 0.5, 0.6, 0;
  const Answer answer = followed(problem);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.claim == Claim::on_path);
  CHECK(answer.failed_checks.empty());
  REQUIRE(answer.solutions.size() == 2);
  CHECK(answer.solutions[0].is_as_stated());
  CHECK(answer.solutions[1].signs == SignVerdict{Standing::not_as_stated, {0}});
  CHECK(answer.counts.on_path == 1U);
  CHECK(answer.counts.not_as_stated == 1U);
}

TEST_CASE("Newton's method from a general sketch ends at a solution or says that it does not") {
  int ended = 0;
  for (const std::uint64_t seed : {28U, 29U, 30U})
    for (const ProblemStatement& problem : sample_scenes(seed)) {
      const Answer answer = followed(problem, {{"mode", "newton"}});
      CHECK(answer.failed_checks.empty());
      if (answer.status == RunStatus::complete)
        ended += answer.solutions.size() == 1;
      else
        CHECK(answer.reason == "Newton's method from the sketch does not settle");
    }
  CHECK(ended > 0);
}

TEST_CASE("what full-space cannot do with a general scene it says") {
  RandomNumbers random(31);
  ProblemStatement problem = sketched(samples::random_octahedral(1, random), random);
  for (const char* mode : {"paper", "certified"}) {
    const Answer answer = followed(problem, {{"mode", mode}});
    CHECK(answer.status == RunStatus::unsupported);
    CHECK_THAT(answer.reason, Catch::Contains("distances between points"));
  }
  problem.sketch.reset();
  CHECK_THAT(followed(problem).reason, Catch::Contains("sketch"));
}
