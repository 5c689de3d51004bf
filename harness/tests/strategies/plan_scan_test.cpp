/// The strategies that subdivide a plan's angles against independent methods, on scenes that are not shipped.

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
