/// Proven paths of general scenes against the fast tracker, monodromy, and the same scenes stated otherwise.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/sanitized.hpp"
#include "solvers/tests/tracking/general_path_samples.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

const OptionMap proven_mode{{"mode", "certified"}}, careful{{"tolerance", "1e-11"}};

std::vector<int> directions(const Answer& answer) {
  std::vector<int> result;
  for (const AssessedCrossing& crossing : answer.crossings) result.push_back(crossing.direction);
  return result;
}

void check_is_proven(const Answer& answer) {
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.claim == Claim::on_path);
  CHECK(answer.failed_checks.empty());
  REQUIRE(answer.ends.size() == 1);
  CHECK(answer.ends[0].end == PathRecord::End::closed);
  CHECK(answer.ends[0].proven);
}

/// Two of which the first has the others' distances too.
std::vector<double> lengths_between_points(const Figure& figure) {
  std::vector<double> lengths;
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i)
    for (Eigen::Index k = 0; k < i; ++k)
      lengths.push_back((figure.points.col(i) - figure.points.col(k)).norm());
  return lengths;
}

void check_same_points(const Answer& one, const Answer& other) {
  const std::vector<Figure> a = crossed(one), b = crossed(other);
  CHECK(directions(one) == directions(other));
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::vector<double> of_a = lengths_between_points(a[i]), of_b = lengths_between_points(b[i]);
    for (std::size_t k = 0; k < of_a.size(); ++k) CHECK(of_a[k] == Approx(of_b[k]).epsilon(1e-9));
  }
}

std::vector<ProblemStatement> scenes(std::uint64_t seed) {
  std::vector<ProblemStatement> result = sample_scenes(seed);
  RandomNumbers random(seed + 1000);
  result.push_back(sketched_points_and_lines(random));
  return result;
}

// ---- a scene of each kind, with the sketch near where the constraints without a value hold

ProblemStatement on_one_line(RandomNumbers& random) {
  const Eigen::Matrix3Xd target = random.points(2, 5, 2);
  Eigen::Matrix3Xd sketch = random.points(2, 5, 2);
  sketch.col(4) = (sketch.col(2) + sketch.col(3)) / 2 + random.point(2, 0.01);
  ProblemStatement problem = between(2, {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {0, 3}, {0, 4}}, sketch, target);
  problem.relations = {{"c", "collinear", {{2}, {3}, {4}}}};
  return problem;
}

ProblemStatement in_one_plane(RandomNumbers& random) {
  const Eigen::Matrix3Xd target = random.points(3, 6, 2);
  Eigen::Matrix3Xd sketch = random.points(3, 6, 2);
  sketch.row(2).segment(1, 4).setZero();
  const Edges edges = {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3},
                       {1, 4}, {0, 4}, {5, 0}, {5, 3}, {5, 4}};
  ProblemStatement problem = between(3, edges, sketch, target);
  problem.relations = {{"c", "coplanar", {{1}, {2}, {3}, {4}}}};
  return problem;
}

ProblemStatement segments_at_an_angle(RandomNumbers& random) {
  const Eigen::Matrix3Xd target = random.points(2, 4, 2);
  ProblemStatement problem = between(2, {{0, 1}, {0, 2}, {1, 2}, {2, 3}}, random.points(2, 4, 2), target);
  problem.relations = {
      {"c", "angle", {{0, 1}, {2, 3}}, Relation::Form::degrees, {random.uniform(20, 160), ""}}};
  return problem;
}

ProblemStatement hinged_bodies(RandomNumbers& random) {
  const Eigen::Matrix3Xd points = random.points(3, 6, 2);
  ProblemStatement problem = bodies_of(points, {{0, 1, 2, 3}, {2, 3, 4, 5}}, random);
  problem.constraints = {{"d", {0, 4}, {(points.col(0) - points.col(4)).norm(), ""}, false}};
  problem.sketch = Figure{points + random.points(3, 6, 0.05), {}};
  return problem;
}

ProblemStatement lines_at_distances(RandomNumbers& random) {
  ProblemStatement problem = sketched_points_and_lines(random);
  for (Relation& relation : problem.relations)
    if (relation.type == "angle")
      relation = {
          relation.id, "distance", relation.of, Relation::Form::length, {random.uniform(0.1, 1.5), ""}};
  return problem;
}

/// Points of a moving triangle at distances from given points.
ProblemStatement body_and_given_points(RandomNumbers& random) {
  ProblemStatement problem = sketched(random_platform(2, random), random);
  problem.fixed_points.assign(problem.points.size(), std::nullopt);
  for (const BodyElement& element : problem.bodies[0].elements) {
    const Eigen::Vector3d at(element.numbers[0].value, element.numbers[1].value, 0);
    problem.fixed_points[static_cast<std::size_t>(element.entity)] = at;
    problem.sketch->points.col(element.entity) = at;
  }
  problem.bodies.erase(problem.bodies.begin());
  problem.reference_body = -1;
  return problem;
}

}  // namespace

TEST_CASE("S of general scenes is proven, with the crossings of the fast tracker, which monodromy finds") {
  std::size_t met = 0;
  for (const std::uint64_t seed : {61U, 62U})
    for (const ProblemStatement& problem : sample_scenes(seed)) {
      const Scene scene = Scene::unchecked(problem);
      const Answer proven = followed(problem, proven_mode), fast = followed(problem, careful);
      CAPTURE(name_of(problem), seed, proven.reason);
      check_is_proven(proven);
      check_same_crossings(scene, crossed(proven), crossed(fast));
      CHECK(directions(proven) == directions(fast));
      const Answer all = solve(scene, "monodromy", {}, {.certify = true});
      for (const Figure& figure : crossed(proven))
        CHECK(std::ranges::count_if(all.solutions, [&](const AssessedSolution& one) {
                return one.is_real() && one.certified && are_alike(scene, figure, one.figure);
              }) == 1);
      met += proven.crossings.size();
    }
  CHECK(met >= 8);
}

TEST_CASE("S of points and lines is proven, with the crossings of the fast tracker") {
  std::size_t met = 0;
  const int seeds = repetitions(6);
  for (int seed = 1; seed <= seeds; ++seed) {
    RandomNumbers random(static_cast<std::uint64_t>(seed));
    const ProblemStatement problem = sketched_points_and_lines(random);
    const Answer proven = followed(problem, proven_mode), fast = followed(problem, careful);
    CAPTURE(seed, proven.reason);
    check_is_proven(proven);
    check_same_crossings(Scene::unchecked(problem), crossed(proven), crossed(fast));
    CHECK(directions(proven) == directions(fast));
    met += proven.crossings.size();
  }
  CHECK(met >= static_cast<std::size_t>(seeds));
}

TEST_CASE("S of scenes of many kinds is proven, with the crossings of the fast tracker") {
  using Kind = ProblemStatement (*)(RandomNumbers&);
  for (const Kind kind : {Kind(on_one_line), Kind(in_one_plane), Kind(segments_at_an_angle),
                          Kind(hinged_bodies), Kind(lines_at_distances), Kind(body_and_given_points)}) {
    std::size_t met = 0;
    for (const std::uint64_t seed : {2U, 3U, 4U}) {
      RandomNumbers random(seed);
      const ProblemStatement problem = kind(random);
      const Answer proven = followed(problem, proven_mode), fast = followed(problem, careful);
      CAPTURE(name_of(problem), seed, proven.reason);
      check_is_proven(proven);
      check_same_crossings(Scene::unchecked(problem), crossed(proven), crossed(fast));
      CHECK(directions(proven) == directions(fast));
      met += proven.crossings.size();
    }
    CHECK(met > 0);
  }
}

TEST_CASE("a proof for general scenes does not depend on orders, tolerances, directions, names and units") {
  for (const ProblemStatement& problem : scenes(63)) {
    const Scene scene = Scene::unchecked(problem);
    const std::vector<Figure> expected = crossed(followed(problem, proven_mode));
    CAPTURE(name_of(problem));
    for (const auto& [name, value] :
         OptionMap{{"order", "18"}, {"tolerance", "1e-10"}, {"step_max", "0.1"}}) {
      const Answer answer = followed(problem, {{"mode", "certified"}, {name, value}});
      check_is_proven(answer);
      check_same_crossings(scene, crossed(answer), expected);
    }
    const Answer back = followed(problem, {{"mode", "certified"}, {"orientation", "backward"}});
    check_is_proven(back);
    std::vector<Figure> backward = crossed(back);
    std::ranges::reverse(backward);
    check_same_crossings(scene, backward, expected);
    const Answer other = followed(renamed_and_scaled(problem), proven_mode);
    check_is_proven(other);
    check_same_crossings(scene, crossed(other), expected);
  }
}

TEST_CASE("points with an orientation have the proven path of the points, in as many tubes") {
  RandomNumbers random(65);
  for (const ProblemStatement& problem :
       {octahedron(), k33(), random_problem(2, 8, random), random_problem(3, 7, random)}) {
    const Answer general = followed(with_orientation(problem), proven_mode),
                 alone = followed(problem, proven_mode);
    CAPTURE(general.reason);
    check_is_proven(general);
    check_same_points(general, alone);
    CHECK(std::abs(general.work.iterations - alone.work.iterations) <= alone.work.iterations / 10);
  }
}

TEST_CASE("an octahedron with a plane on three points has the proven path of the octahedron") {
  const ProblemStatement octahedral = octahedron();
  const Answer alone = followed(octahedral, proven_mode);
  REQUIRE(alone.crossings.size() == 4);
  for (const auto& [i, k, l] : {std::array{0, 1, 2}, std::array{0, 2, 4}, std::array{3, 4, 5}}) {
    ProblemStatement with_plane = octahedral;
    with_plane.planes = {"h"};
    for (const int point : {i, k, l})
      with_plane.relations.push_back({"on" + std::to_string(point), "on", {{point}, {6}}});
    const Eigen::Matrix3Xd& p = octahedral.sketch->points;
    const Eigen::Vector3d a = p.col(k) - p.col(i), b = p.col(l) - p.col(i);
    const Eigen::Vector3d normal = a.cross(b).normalized();
    with_plane.sketch->planes = {{normal, normal.dot(p.col(i))}};
    const Answer answer = followed(with_plane, proven_mode);
    CAPTURE(i, k, l, answer.reason);
    check_is_proven(answer);
    check_same_points(answer, alone);
  }
}

TEST_CASE("an octahedron of which one side is a body has the proven path of the octahedron") {
  int met = 0;
  const Edges edges = {{0, 1}, {0, 2}, {1, 2}, {0, 4}, {0, 5}, {1, 3},
                       {1, 5}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {4, 5}};
  for (const std::uint64_t seed : {71U, 72U, 73U}) {
    RandomNumbers random(seed);
    Eigen::Matrix3Xd sketch = random.points(3, 6, 2), target = random.points(3, 6, 2);
    sketch.leftCols(3) = target.leftCols(3);
    ProblemStatement points = between(3, edges, sketch, target);
    points.interpolation = {11, 1};
    ProblemStatement body = points;
    body.constraints.erase(body.constraints.begin(), body.constraints.begin() + 3);
    body.interpolation = {8, 1};
    body.bodies = {{"base", {}}};
    for (int i = 0; i < 3; ++i)
      body.bodies[0].elements.push_back({i, {{target(0, i), ""}, {target(1, i), ""}, {target(2, i), ""}}});
    body.reference_body = 0;
    const Answer of_points = followed(points, proven_mode), of_body = followed(body, proven_mode);
    CAPTURE(seed, of_body.reason);
    check_is_proven(of_points);
    check_is_proven(of_body);
    check_same_points(of_body, of_points);
    met += static_cast<int>(of_body.crossings.size());
  }
  CHECK(met >= 2);
}

TEST_CASE("the crossings up to infinity are proven, and no more is claimed") {
  for (const double of_l : {40.0, 79.0, 85.0}) {
    const ProblemStatement problem = corner_of_lines(60, of_l, 80);
    const Answer proven = followed(problem, proven_mode), fast = followed(problem);
    CAPTURE(of_l, proven.reason);
    CHECK(proven.status == RunStatus::complete);
    CHECK(proven.claim == Claim::some_real);
    CHECK_THAT(proven.reason, Catch::Contains("infinity"));
    CHECK(proven.failed_checks.empty());
    REQUIRE(proven.ends.size() == 1);
    CHECK(proven.ends[0].end == PathRecord::End::at_infinity);
    CHECK_FALSE(proven.ends[0].proven);
    check_same_crossings(Scene::unchecked(problem), crossed(proven), crossed(fast));
  }
}

TEST_CASE("until the first solution S is proven that far, and past those that are not as stated") {
  for (const ProblemStatement& problem : scenes(64)) {
    const std::vector<Figure> all = crossed(followed(problem, proven_mode));
    const Answer first = followed(problem, {{"mode", "certified"}, {"until", "first"}});
    CAPTURE(name_of(problem));
    CHECK(first.failed_checks.empty());
    if (all.empty()) {
      CHECK(first.solutions.empty());
      continue;
    }
    CHECK(first.claim == Claim::some_real);
    check_same_crossings(Scene::unchecked(problem), crossed(first), {all.front()});
  }
}

TEST_CASE("where no figure beside the sketch meets the incidences the proof says so") {
  // All points of the line are one: it has no direction.
  RandomNumbers random(1);
  ProblemStatement problem = on_one_line(random);
  for (const int point : {3, 4}) problem.sketch->points.col(point) = problem.sketch->points.col(2);
  const Scene scene = Scene::unchecked(problem);
  const TrackedPath path = CertifiedTracker(scene, {}, {}).run();
  CHECK(path.end == TrackedPath::End::failed);
  CHECK_FALSE(path.proven);
  CHECK_THAT(path.cause, Catch::Contains("without a value"));
}

TEST_CASE("a sketch off the incidences has a proven path that begins where they hold") {
  ProblemStatement problem = corner_of_lines(60, 40, 80);
  problem.sketch->points.col(2) += Eigen::Vector3d(2e-4, -3e-4, 0);
  const Answer answer = followed(problem, proven_mode);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.solutions.size() == 2);
}
