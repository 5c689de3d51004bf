/// The strategies that subdivide a plan's angles against independent methods, on scenes that are not shipped.

#include "solvers/scanning/plan_scan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "harness/tests/contract/problem_restatements.hpp"
#include "solvers/figures/reflection_classes.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;

namespace {

SolveRun solved(const ProblemStatement& problem, const std::string& strategy, const OptionMap& options = {}) {
  return run_strategy(find_strategy(strategy), options, Scene(problem), {});
}

std::vector<Figure> real_figures(const SolveRun& run) {
  std::vector<Figure> figures;
  for (const AssessedSolution& s : run.solutions)
    if (s.is_real()) figures.push_back(s.placement());
  return figures;
}

/// Classes in both lists together, both being in the file's unit. Equal to each one's number if they are the
/// same.
int classes_together(const ProblemStatement& problem, std::vector<Figure> figures,
                     const std::vector<Figure>& others) {
  const Scene scene(problem);
  figures.insert(figures.end(), others.begin(), others.end());
  const double to_scene = std::ldexp(1.0, -scene.unit_exponent());
  for (Figure& figure : figures) {
    figure.points *= to_scene;
    for (LinePosition& line : figure.lines) line.point *= to_scene;
  }
  return reflection_classes(scene, figures, 1e-7).count();
}

ProblemStatement with_lengths_of(ProblemStatement problem, const Eigen::Matrix3Xd& points) {
  for (DistanceConstraint& c : problem.constraints) {
    c.given = {(points.col(c.between[0]) - points.col(c.between[1])).norm(), ""};
    c.is_squared = false;
  }
  problem.sketch.reset();
  return problem;
}

/// Two copies that share points 0 and 1. Precondition: these are constrained.
ProblemStatement glued(const ProblemStatement& problem) {
  ProblemStatement both = problem;
  const int more = static_cast<int>(problem.points.size()) - 2;
  const auto copy_of = [more](int point) { return point < 2 ? point : point + more; };
  for (int p = 2; p < more + 2; ++p) both.points.push_back(problem.points[p] + "'");
  for (const DistanceConstraint& c : problem.constraints) {
    if (std::max(c.between[0], c.between[1]) < 2) continue;
    DistanceConstraint copy = c;
    copy.id += "'";
    copy.between = {copy_of(c.between[0]), copy_of(c.between[1])};
    both.constraints.push_back(copy);
  }
  both.sketch.reset();
  both.reference.reset();
  both.interpolation = {};
  both.fixed_points.clear();
  both.construction.clear();
  return both;
}

/// The first, with the further points of the second, which shares points 0 and 1. Precondition: these are
/// constrained, to the same length.
ProblemStatement glued(ProblemStatement first, const ProblemStatement& second) {
  const int more = static_cast<int>(first.points.size()) - 2;
  const std::string mark = "'" + std::to_string(more);
  for (std::size_t p = 2; p < second.points.size(); ++p) first.points.push_back(second.points[p] + mark);
  for (DistanceConstraint copy : second.constraints) {
    if (std::max(copy.between[0], copy.between[1]) < 2) continue;
    copy.id += mark;
    for (int& end : copy.between)
      if (end > 1) end += more;
    first.constraints.push_back(copy);
  }
  return first;
}

/// K3,3 with random lengths but between points 0 and 1.
ProblemStatement random_k33(samples::RandomNumbers& random) {
  Eigen::Matrix3Xd points = random.points(2, 6, 1);
  points.leftCols<2>() << 0, 1.25, 0, 0, 0, 0;
  ProblemStatement problem = with_lengths_of(load_instance("k33").problem, points);
  problem.reference.reset();
  problem.interpolation = {};
  return problem;
}

/// A point at a given distance from a line, one from both, others from three of what was there; and as many
/// distances more as make it rigid.
ProblemStatement random_beside_line(int points, samples::RandomNumbers& random) {
  const int line = points;
  std::vector<std::array<int, 2>> edges{{0, line}, {1, line}, {0, 1}};
  const auto add = [&](int point, int other) {
    const std::array<int, 2> edge{std::min(point, other), std::max(point, other)};
    if (point != other && std::find(edges.begin(), edges.end(), edge) == edges.end()) edges.push_back(edge);
  };
  for (int p = 2; p < points; ++p)
    for (const auto wanted = edges.size() + 3; edges.size() < wanted;) {
      const int other = random.index(p + 1);
      add(p, other == p ? line : other);
    }
  while (edges.size() < static_cast<std::size_t>(3 * points - 2)) {
    const int other = random.index(points + 1);
    add(random.index(points), other);
  }
  const Eigen::Matrix3Xd places = random.points(3, points, 1);
  ProblemStatement problem = load_instance("hoffmann-yuan").problem;
  problem.reference.reset();
  problem.points.clear();
  problem.constraints.clear();
  for (int p = 0; p < points; ++p) problem.points.push_back("p" + std::to_string(p));
  for (const auto& [a, b] : edges) {
    const double length = b == line ? places.col(a).tail<2>().norm() : (places.col(a) - places.col(b)).norm();
    problem.constraints.push_back(
        {"c" + std::to_string(a) + "," + std::to_string(b), {a, b}, {length, ""}, false});
  }
  return problem;
}

ProblemStatement with_open_side(double length) {
  ProblemStatement problem = load_instance("hoffmann-yuan").problem;
  for (DistanceConstraint& c : problem.constraints)
    if (c.id == "a12") c.given = {length, ""};
  return problem;
}

/// Cells are counted, not timed. Where many branch ends follow on each other, or centres are nearly
/// collinear, an enclosure that does not shrink with its cell takes millions.
void scan_in_any_order(const std::string& id, std::size_t classes, int orders) {
  constexpr std::size_t most_cells_per_class = 1000;
  const ProblemStatement problem = load_instance(id).problem;
  const OptionMap options{{"max_cells", std::to_string(most_cells_per_class * classes)}};
  for (int seed = 1001; seed <= 1000 + orders; ++seed) {
    std::mt19937_64 random(seed);
    const ProblemStatement relabelled = contract::relabelled(problem, random).problem;
    const SolveRun scan =
        solved(contract::constraints_permuted(relabelled, random).problem, "plan-scan", options);
    INFO(id << " with seed " << seed << ": " << scan.reason);
    CHECK(scan.status == RunStatus::complete);
    CHECK(real_figures(scan).size() == classes);
  }
}

}  // namespace

TEST_CASE("random octahedra have the real solutions that Cayley-Menger determinants give") {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const ProblemStatement octahedron = load_instance("octahedron").problem;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Matrix3Xd points =
        Eigen::Matrix3Xd::NullaryExpr(3, 6, [&](Eigen::Index, Eigen::Index) { return coordinate(random); });
    const ProblemStatement problem = with_lengths_of(octahedron, points);
    const SolveRun scan = solved(problem, "plan-scan");
    const auto found = real_figures(scan);
    const auto expected = real_figures(solved(problem, "cayley-menger"));
    CHECK(scan.status == RunStatus::complete);
    CHECK(found.size() == expected.size());
    CHECK(classes_together(problem, found, expected) == static_cast<int>(expected.size()));
  }
}

TEST_CASE("no order of points and constraints makes a scan long") {
  const std::map<std::string, std::size_t> classes{
      {"disulfide", 18}, {"k33", 2}, {"octahedron", 4}, {"prism", 12}, {"g16a", 8}};
  for (const auto& [id, count] : classes) scan_in_any_order(id, count, 20);
}

TEST_CASE("no order of many points and constraints makes a scan long") { scan_in_any_order("g160", 66, 5); }

// Glued at an edge, each class of one goes with each class of the other, on the same side of the edge or on
// the other.
TEST_CASE("two scenes glued at an edge take two angles and multiply their solutions") {
  const ProblemStatement one = load_instance("k33").problem;
  const auto classes = real_figures(solved(one, "plan-scan")).size();
  REQUIRE(classes > 0);
  const SolveRun both = solved(glued(one), "plan-scan");
  CHECK(both.status == RunStatus::complete);
  CHECK(real_figures(both).size() == 2 * classes * classes);
}

// The counts that are multiplied are those of monodromy.
TEST_CASE("three random scenes glued at an edge take three angles and multiply their solutions") {
  samples::RandomNumbers random(2);
  ProblemStatement all = random_k33(random);
  std::size_t expected = real_figures(solved(all, "monodromy")).size();
  for (int i = 1; i < 3; ++i) {
    const ProblemStatement next = random_k33(random);
    expected *= 2 * real_figures(solved(next, "monodromy")).size();
    all = glued(std::move(all), next);
  }
  CHECK(expected > 0);
  CHECK(solved(all, "plan-scan", {{"reduce", "off"}}).status == RunStatus::unsupported);
  const SolveRun scan =
      solved(all, "plan-scan", {{"most_angles", "3"}, {"reduce", "off"}, {"max_cells", "1000000"}});
  INFO(scan.reason);
  CHECK(scan.status == RunStatus::complete);
  CHECK(real_figures(scan).size() == expected);
}

// The strategy scans them over a grid only; the subdivision is asked for by itself.
TEST_CASE("plans that start from a line lead to the real solutions that monodromy finds") {
  samples::RandomNumbers random(21);
  int compared = 0;
  for (int i = 0; i < 10; ++i) {
    const ProblemStatement problem = random_beside_line(4 + i % 2, random);
    SolveRun all;
    try {
      all = solved(problem, "monodromy");
    } catch (const InputError&) {
      continue;  // not rigid
    }
    const Scene scene(problem);
    if (why_no_scan_plan(scene) || all.status != RunStatus::complete) continue;
    const ScanPlan plan = derive_scan_plan(scene);
    if (plan.angles() > 1) continue;
    ++compared;
    INFO("scene " << i);
    const auto expected = real_figures(all);
    const ScanOutcome proven = scan_plan(SolveRequest(scene), plan, 1'000'000);
    CHECK(proven.end == ScanOutcome::End::complete);
    CHECK(proven.undecided.empty());
    CHECK(proven.solutions.size() == expected.size());
    const SolveRun grid =
        solved(problem, "plan-scan", {{"method", "published"}, {"step", "0.2"}, {"delta", "0.1"}});
    CHECK(grid.status == RunStatus::complete);
    const auto of_grid = real_figures(grid);
    CHECK(classes_together(problem, expected, of_grid) == static_cast<int>(expected.size()));
    CHECK(2 * of_grid.size() > expected.size());
  }
  CHECK(compared >= 6);
}

TEST_CASE("any length of the open side gives the solutions of a scan a hundred times finer") {
  std::mt19937_64 random(34);
  std::uniform_real_distribution<double> length(2, 11);
  for (int i = 0; i < 4; ++i) {
    const ProblemStatement problem = with_open_side(length(random));
    const SolveRun scan = solved(problem, "theta-scan");
    const auto found = real_figures(scan);
    const auto finer = real_figures(
        solved(problem, "theta-scan", {{"method", "published"}, {"dtheta", "0.01"}, {"delta", "0.05"}}));
    CHECK(scan.status == RunStatus::complete);
    CHECK(found.size() >= finer.size());
    CHECK(classes_together(problem, found, finer) == static_cast<int>(found.size()));
    CHECK(found.size() == finer.size());
  }
}

// Near a maximum of d34(θ) two solutions are as close together as one likes, and beyond it there is none of
// them.
TEST_CASE("solutions on both sides of an extremum are told apart") {
  const Scene scene(with_open_side(9));
  const Pyramid pyramid = *find_pyramid(scene);
  const PyramidBranches branches(pyramid);
  const auto longest = [&](double theta) {
    double gap = 0;
    for (const PyramidBranch& branch : branches.at(theta)) gap = std::max(gap, branch.gap());
    return gap;
  };
  double best = 0;
  for (int i = 0; i < 3600; ++i) {
    const double theta = i * 3.14159265358979 / 3600 - 1.5707963267949;
    if (longest(theta) > longest(best)) best = theta;
  }
  double low = best - 1e-3;
  double high = best + 1e-3;
  for (int i = 0; i < 100; ++i) {
    const double left = low + (high - low) / 3;
    const double right = high - (high - low) / 3;
    (longest(left) < longest(right) ? low : high) = longest(left) < longest(right) ? left : right;
  }
  const double top = std::ldexp(longest(low), scene.unit_exponent());
  for (const double gap : {1e-4, 1e-8, 1e-10}) {
    const SolveRun below = solved(with_open_side(top * (1 - gap)), "theta-scan");
    CHECK(below.status == RunStatus::complete);
    CHECK(real_figures(below).size() == 2);
    CHECK(real_figures(solved(with_open_side(top * (1 + gap)), "theta-scan")).empty());
  }
}

TEST_CASE("a scan that cannot divide by a gap does not say that nothing is there") {
  // Circles of radius 1 about points 1e-90 apart meet at height ±1.
  for (const std::string gap : {"1e-70", "1e-77", "1e-78", "1e-90", "1e-120"}) {
    const std::string text =
        R"({"format": "gcsbench-instance/1", "id": "gap", "dimension": 2, "points": ["a", "b", "c", "x"],
            "fixed": {"a": [0, 0], "b": [)" +
        gap + R"(, 0], "c": [0, 1]}, "constraints": [
            {"type": "distance", "between": ["x", "a"], "length": 1},
            {"type": "distance", "between": ["x", "b"], "length": 1}]})";
    const SolveRun run = solved(parse_instance(text, "gap.json").problem, "plan-scan");
    INFO(gap << ": " << run.reason);
    CHECK((run.status == RunStatus::partial || run.solutions.size() == 2));
  }
}
