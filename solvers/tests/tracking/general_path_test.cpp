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
#include "solvers/tracking/real_equations.hpp"
#include "solvers/tracking/sketched_unknowns.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

Answer followed(const ProblemStatement& problem, const OptionMap& options = {}) {
  return solve(Scene::unchecked(problem), "full-space", options);
}

Eigen::Matrix3Xd points_of(const RigidBody& body) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(body.elements.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const std::vector<Decimal>& numbers = body.elements[static_cast<std::size_t>(i)].numbers;
    for (std::size_t axis = 0; axis < numbers.size(); ++axis)
      points(static_cast<Eigen::Index>(axis), i) = numbers[axis].value;
  }
  return points;
}

/// Both bodies somewhere, and their points nearly where that puts them.
Figure random_posture(const ProblemStatement& platform, RandomNumbers& random) {
  Figure figure{Eigen::Matrix3Xd(3, 0), {}};
  for (const RigidBody& body : platform.bodies) {
    const Eigen::Quaterniond turn =
        platform.dimension == 3
            ? Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                                 random.uniform(-1, 1))
                  .normalized()
            : Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(-3, 3), Eigen::Vector3d::UnitZ()));
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

// ---- another way to track S: by geometry, in coordinates of its own, with tiny steps of Euler and Newton

Eigen::Quaterniond turn_of(const Eigen::VectorXd& z, Eigen::Index at) {
  return {z[at], z[at + 1], z[at + 2], z[at + 3]};
}

class SlowPath {
 public:
  explicit SlowPath(const ProblemStatement& problem) : problem_(problem), bent_(bent_lengths(problem)) {
    start_ = problem.bodies.empty() ? elements_of(*problem.sketch) : posture_of(*problem.sketch);
    at_sketch_ = values(start_);
  }

  /// The figures at t = 1 in the order met, as many as asked for, with the sign of dt.
  std::vector<std::pair<Figure, int>> crossings(std::size_t count) {
    constexpr double step = 1e-2;
    constexpr int most_steps = 50'000;
    Eigen::VectorXd z(start_.size() + 1);
    z << start_, 0;
    Eigen::VectorXd tangent = Eigen::VectorXd::Unit(z.size(), z.size() - 1);
    tangent = tangent_at(z, tangent);
    std::vector<std::pair<Figure, int>> found;
    for (int i = 0; i < most_steps && found.size() < count; ++i) {
      const Eigen::VectorXd before = z;
      z += step * tangent;
      correct(z, tangent);
      const double t0 = before[z.size() - 1] - 1, t1 = z[z.size() - 1] - 1;
      if ((t0 < 0) != (t1 < 0)) {
        Eigen::VectorXd at = before + (z - before) * (t0 / (t0 - t1));
        at[z.size() - 1] = 1;
        correct(at, Eigen::VectorXd::Unit(z.size(), z.size() - 1));
        found.emplace_back(figure(at), t1 > t0 ? 1 : -1);
      }
      tangent = tangent_at(z, tangent);
    }
    return found;
  }

 private:
  Eigen::VectorXd elements_of(const Figure& figure) const {
    std::vector<double> z(figure.points.data(), figure.points.data() + figure.points.size());
    for (const PlanePosition& plane : figure.planes) {
      z.insert(z.end(), plane.normal.begin(), plane.normal.end());
      z.push_back(plane.offset);
    }
    return Eigen::Map<Eigen::VectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
  }

  /// Of the second body as the first one sees it: shift, then a quaternion.
  Eigen::VectorXd posture_of(const Figure& figure) const {
    const Eigen::Index n = figure.points.cols() / 2;
    const Eigen::Matrix4d base =
                              Eigen::umeyama(points_of(problem_.bodies[0]), figure.points.leftCols(n), false),
                          moved = Eigen::umeyama(points_of(problem_.bodies[1]), figure.points.rightCols(n),
                                                 false);
    const Eigen::Matrix4d motion = base.inverse() * moved;
    const Eigen::Quaterniond turn(Eigen::Matrix3d(motion.topLeftCorner<3, 3>()));
    Eigen::VectorXd z(7);
    z << motion.topRightCorner<3, 1>(), turn.w(), turn.x(), turn.y(), turn.z();
    return z;
  }

  Figure figure(const Eigen::VectorXd& z) const {
    if (!problem_.bodies.empty()) {
      const Eigen::Matrix3Xd base = points_of(problem_.bodies[0]), moved = points_of(problem_.bodies[1]);
      Figure result{Eigen::Matrix3Xd(3, base.cols() + moved.cols()), {}};
      result.points << base,
          (turn_of(z, 3).toRotationMatrix() * moved).colwise() + Eigen::Vector3d(z.head<3>());
      return result;
    }
    const auto points = static_cast<Eigen::Index>(problem_.points.size());
    Figure result{Eigen::Map<const Eigen::Matrix3Xd>(z.data(), 3, points), {}};
    for (std::size_t i = 0; i < problem_.planes.size(); ++i) {
      const Eigen::Index at = 3 * points + 4 * static_cast<Eigen::Index>(i);
      result.planes.push_back({z.segment<3>(at), z[at + 3]});
    }
    return result;
  }

  /// Of all constraints, in the order of the problem.
  Eigen::VectorXd values(const Eigen::VectorXd& z) const {
    const Figure at = figure(z);
    std::vector<double> result;
    for (const DistanceConstraint& c : problem_.constraints)
      result.push_back((at.points.col(c.between[0]) - at.points.col(c.between[1])).norm());
    const auto plane = [&](const Operand& of) {
      return at.planes[static_cast<std::size_t>(problem_.plane_of(of.entity))];
    };
    for (const Relation& r : problem_.relations) {
      if (r.type == RelationType::angle)
        result.push_back(plane(r.of[0]).normal.dot(plane(r.of[1]).normal));
      else
        result.push_back(plane(r.of[1]).normal.dot(at.points.col(r.of[0].entity)) - plane(r.of[1]).offset);
    }
    return Eigen::Map<Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
  }

  double given(Eigen::Index i) const {
    const auto count = static_cast<Eigen::Index>(problem_.constraints.size());
    return i < count ? problem_.constraints[static_cast<std::size_t>(i)].given.value
                     : problem_.relations[static_cast<std::size_t>(i - count)].given.value;
  }

  /// Zero on S, and where the frame and the norms of normals and of the quaternion are.
  Eigen::VectorXd excess(const Eigen::VectorXd& z) const {
    const double t = z[z.size() - 1];
    Eigen::VectorXd f = values(z);
    for (Eigen::Index i = 0; i < f.size(); ++i) {
      f[i] -= (1 - t) * at_sketch_[i] + t * given(i);
      for (const BentLength& bent : bent_)
        if (bent.constraint == i) f[i] -= bent.coefficients[0] * t * (1 - t);
    }
    std::vector<double> rest;
    if (!problem_.bodies.empty()) {
      rest.push_back(turn_of(z, 3).squaredNorm() - 1);
      if (problem_.dimension == 2) rest.insert(rest.end(), {z[2], z[4], z[5]});
    } else {
      rest = {z[0] - start_[0], z[1] - start_[1], z[2] - start_[2],
              z[4] - start_[4], z[5] - start_[5], z[8] - start_[8]};
      for (const PlanePosition& plane : figure(z).planes) rest.push_back(plane.normal.squaredNorm() - 1);
    }
    Eigen::VectorXd all(f.size() + static_cast<Eigen::Index>(rest.size()));
    all << f, Eigen::Map<Eigen::VectorXd>(rest.data(), static_cast<Eigen::Index>(rest.size()));
    return all;
  }

  Eigen::MatrixXd derivatives(const Eigen::VectorXd& z) const {
    constexpr double change = 1e-6;
    Eigen::MatrixXd result(z.size() - 1, z.size());
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      const Eigen::VectorXd e = change * Eigen::VectorXd::Unit(z.size(), i);
      result.col(i) = (excess(z + e) - excess(z - e)) / (2 * change);
    }
    return result;
  }

  Eigen::MatrixXd bordered(const Eigen::VectorXd& z, const Eigen::VectorXd& last) const {
    Eigen::MatrixXd matrix(z.size(), z.size());
    matrix << derivatives(z), last.transpose();
    return matrix;
  }

  Eigen::VectorXd tangent_at(const Eigen::VectorXd& z, const Eigen::VectorXd& last) const {
    return bordered(z, last).partialPivLu().solve(Eigen::VectorXd::Unit(z.size(), z.size() - 1)).normalized();
  }

  void correct(Eigen::VectorXd& z, const Eigen::VectorXd& across) const {
    const auto factors = bordered(z, across).partialPivLu();
    for (int i = 0; i < 4; ++i) {
      Eigen::VectorXd f(z.size());
      f << excess(z), 0;
      z -= factors.solve(f);
    }
  }

  const ProblemStatement& problem_;
  std::vector<BentLength> bent_;
  Eigen::VectorXd start_, at_sketch_;
};

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
  problem.relations = {{"oL", RelationType::on, {o, line_l}},
                       {"aM", RelationType::on, {a, line_m}},
                       {"pL", RelationType::on, {p, line_l}},
                       {"pM", RelationType::on, {p, line_m}},
                       {"l", RelationType::angle, {o_a, line_l}, R::Form::degrees, {of_l, ""}},
                       {"m", RelationType::angle, {o_a, line_m}, R::Form::degrees, {of_m, ""}}};
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

TEST_CASE("a crossing at which a segment points the other way is no solution") {
  // c is on a ray from o, and on a circle about a that o is inside of: its other place is on the opposite ray.
  ProblemStatement problem;
  problem.dimension = 2;
  problem.points = {"o", "a", "b", "c"};
  problem.reference = Reference{0, 2};
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
    problem.constraints.push_back({std::to_string(i) + std::to_string(j), {i, j}, {1, ""}, false});
  problem.constraints.push_back({"ac", {1, 3}, {1.2, ""}, false});
  problem.relations = {{"aoc", RelationType::angle, {{0, 1}, {0, 3}}, Relation::Form::degrees, {50, ""}}};
  problem.sketch = Figure{Eigen::Matrix3Xd::Zero(3, 4), {}};
  problem.sketch->points.col(1) << 1, 0, 0;
  problem.sketch->points.col(2) << 0.5, std::sqrt(0.75), 0;
  problem.sketch->points.col(3) << 0.5, 0.6, 0;
  const Answer answer = followed(problem);
  CHECK(answer.status == RunStatus::partial);
  CHECK(answer.claim == Claim::some_real);
  CHECK_THAT(answer.reason, Catch::Contains("not the constraints as they are stated"));
  CHECK(answer.failed_checks.empty());
  CHECK(answer.solutions.size() == 1);
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
