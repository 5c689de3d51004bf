/// S of triangles whose sides are polynomials in t is known by hand: over the interval of t around [0, 1] in which the
/// triangle inequalities hold, the corner lies above or below the base, and at the ends of the interval the two arcs
/// meet. Where the interval ends between 0 and 1, S closes without a solution; where it does not end, S runs off.

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

using Coefficients = std::vector<double>;

constexpr double base_length = 1, left_length = 1, right_length = 0.9;

/// p3 above the base p1–p2, with these sides.
ProblemStatement triangle(const std::array<double, 3>& sketched, const std::array<double, 3>& given,
                          const std::vector<BentLength>& bends) {
  ProblemStatement problem =
      samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {given[0], given[1], given[2]});
  const auto [a, b, c] = sketched;
  const double x = (a * a + b * b - c * c) / (2 * a);
  problem.sketch = Figure{Eigen::Matrix3Xd::Zero(3, 3), {}};
  problem.sketch->points.col(1) << a, 0, 0;
  problem.sketch->points.col(2) << x, std::sqrt(b * b - x * x), 0;
  problem.reference = Reference{0, 1, -1, -1, -1};
  problem.interpolation.bends = bends;
  return problem;
}

/// The same sides at the sketch and at the target.
ProblemStatement swinging(const std::vector<BentLength>& bends) {
  return triangle({base_length, left_length, right_length}, {base_length, left_length, right_length}, bends);
}

struct Way {
  std::string strategy;
  OptionMap options;
};

const std::vector<Way> ways{{"full-space", {}},
                            {"full-space", {{"mode", "paper"}, {"step_max", "0.02"}}},
                            {"full-space", {{"mode", "certified"}}},
                            {"rcp", {}},
                            {"rcp", {{"mode", "paper"}, {"step_max", "0.02"}}}};

SolveReport solved(const ProblemStatement& problem, const Way& way) {
  const auto strategies = all_strategies();
  const StrategyEntry& entry =
      *std::find_if(strategies.begin(), strategies.end(),
                    [&](const StrategyEntry& one) { return one.name == way.strategy; });
  const Scene scene(problem);
  return entry.make(complete_options(entry, way.options))->solve(scene);
}

std::string in_words(const Way& way) {
  std::string text = way.strategy;
  for (const auto& [name, value] : way.options) text += " " + name + "=" + value;
  return text;
}

double height(const Figure& figure) {
  const Eigen::Vector3d a = figure.points.col(1) - figure.points.col(0),
                        b = figure.points.col(2) - figure.points.col(0);
  return a.cross(b).z() / a.norm();
}

/// With each way: S closes and meets the triangle above the base, and then the one below.
void check_both_triangles(const ProblemStatement& problem, double expected) {
  const double unit = std::ldexp(1.0, Scene(problem).unit_exponent());
  for (const Way& way : ways) {
    const SolveReport report = solved(problem, way);
    CAPTURE(in_words(way), report.reason);
    CHECK(report.status == SolveStatus::complete);
    REQUIRE(report.candidates.size() == 2);
    CHECK(unit * height(report.candidates[0].figure) == Approx(expected).epsilon(1e-9));
    CHECK(unit * height(report.candidates[1].figure) == Approx(-expected).epsilon(1e-9));
  }
}

void check_none(const ProblemStatement& problem) {
  for (const Way& way : ways) {
    const SolveReport report = solved(problem, way);
    CAPTURE(in_words(way), report.reason);
    CHECK(report.status == SolveStatus::complete);
    CHECK(report.candidates.empty());
  }
}

void check_runs_off(const std::vector<Way>& followed, const ProblemStatement& problem,
                    const std::string& orientation, const std::string& where, std::size_t met) {
  for (Way way : followed) {
    way.options["orientation"] = orientation;
    if (way.options.count("step_max") > 0) way.options["step_max"] = "0.5";
    const SolveReport report = solved(problem, way);
    CAPTURE(in_words(way));
    CHECK(report.status == SolveStatus::gave_up);
    CHECK_THAT(report.reason, Catch::StartsWith("S runs off to " + where));
    CHECK(report.candidates.size() == met);
  }
}

double corner_height(double a, double b, double c) {
  const double x = (a * a + b * b - c * c) / (2 * a);
  return std::sqrt(b * b - x * x);
}

}  // namespace

TEST_CASE("a side that stays short enough between sketch and target lets S meet both triangles") {
  // 1 + 6t²(1 − t) is at most 1 + 24/27 < 1.9.
  check_both_triangles(swinging({{1, {0, 6}}}), corner_height(base_length, left_length, right_length));
}

TEST_CASE("a side that gets too long between sketch and target keeps S from the target") {
  // 1 + 6.2t²(1 − t) is 1 + 24.8/27 > 1.9 at t = 2/3.
  check_none(swinging({{1, {0, 6.2}}}));
}

TEST_CASE("all sides bent by polynomials of several degrees") {
  const std::vector<BentLength> bends{{0, {0.1, -0.2, 0.3}}, {1, {0.5, 0.25}}, {2, {-0.2, 0.1, 0, 0.4, 1}}};
  check_both_triangles(triangle({1, 0.9, 0.8}, {1.2, 0.8, 1.1}, bends), corner_height(1.2, 0.8, 1.1));
}

TEST_CASE("proven arcs of S lie on the curve known by hand") {
  const ProblemStatement problem = swinging({{1, {0, 6}}, {2, {0.1, 0, 0.2}}});
  const Scene scene(problem);
  SeriesTrackerOptions sharp;
  sharp.tolerance = 1e-12;
  CertifiedTracker tracker(scene, sharp, {});
  tracker.keep_arcs();
  REQUIRE(tracker.run().proven);
  const double unit = std::ldexp(1.0, scene.unit_exponent());
  double lowest = 0, highest = 0;
  for (const ProvenArc& arc : tracker.arcs())
    for (int i = 0; i <= 8; ++i) {
      Eigen::VectorXd y;
      arc.curve.evaluate(arc.first + i * (arc.last - arc.first) / 8, y);
      const double t = y[3], b = left_length + 6 * t * t * (1 - t),
                   c = right_length + t * (1 - t) * (0.1 + 0.2 * t * t);
      const double x = (base_length * base_length + b * b - c * c) / (2 * base_length);
      lowest = std::min(lowest, t);
      highest = std::max(highest, t);
      CHECK(unit * y[0] == Approx(base_length).epsilon(1e-9));
      CHECK(unit * y[1] == Approx(x).margin(1e-6));
      CHECK(unit * unit * y[2] * y[2] == Approx(b * b - x * x).margin(1e-6));
    }
  // S turns where the triangle is flat: one side is as long as the other two together.
  const auto flatness = [](double t) {
    const double b = left_length + 6 * t * t * (1 - t), c = right_length + t * (1 - t) * (0.1 + 0.2 * t * t);
    return std::min({base_length + c - b, base_length + b - c, b + c - base_length});
  };
  CHECK(flatness(lowest) == Approx(0).margin(1e-2));
  CHECK(flatness(highest) == Approx(0).margin(1e-2));
  CHECK(lowest < -0.3);
  CHECK(highest > 1.1);
}

TEST_CASE("without a bend S runs off where all sides grow, and meets the target once on the way") {
  // 1 + t, 1 + t, 1 + 1.2t
  check_runs_off(ways, triangle({1, 1, 1}, {2, 2, 2.2}, {}), "forward", "t = infinity", 1);
  check_runs_off(ways, triangle({2, 2, 2.2}, {1, 1, 1}, {}), "backward", "t = -infinity", 0);
}

TEST_CASE("with sides that do not change S is a straight line, which runs off") {
  check_runs_off(ways, swinging({}), "forward", "t = infinity", 1);
}

TEST_CASE("a cubic that only shrinks on one side leaves the other open") {
  // Both sides are scaled by 1 + t(1 − t)(2 − t)/10, which is positive for all t ≥ 0 and grows.
  const auto scaled = [](double length) { return Coefficients{length / 5, -length / 10}; };
  // The lengths grow beyond what steps of a fixed size can follow, those of mode=paper.
  check_runs_off({ways[0], ways[2], ways[3]},
                 swinging({{0, scaled(base_length)}, {1, scaled(left_length)}, {2, scaled(right_length)}}),
                 "forward", "t = infinity", 1);
}

TEST_CASE("one bent constraint in the general form is tracked to the same bits") {
  for (ProblemStatement problem : {samples::k33(), samples::octahedron()}) {
    problem.interpolation = {4, 1.5};
    ProblemStatement general = problem;
    general.interpolation.bends = {{4, {1.5, 0, 0}}};
    for (Way way : ways) {
      way.options.erase("step_max");
      const SolveReport one = solved(problem, way), other = solved(general, way);
      CAPTURE(in_words(way));
      CHECK(one.status == other.status);
      CHECK(one.work.iterations == other.work.iterations);
      CHECK(one.work.newton_iterations == other.work.newton_iterations);
      REQUIRE(one.candidates.size() == other.candidates.size());
      for (std::size_t i = 0; i < one.candidates.size(); ++i)
        CHECK(one.candidates[i].figure.points == other.candidates[i].figure.points);
    }
  }
}

TEST_CASE("a quadratic that is followed as a polynomial has the same S") {
  for (ProblemStatement problem : {samples::k33(), samples::octahedron()}) {
    ProblemStatement general = problem;
    // The term of degree 3 is far below rounding.
    general.interpolation.bends = {{static_cast<int>(problem.constraints.size()) - 1, {2, 1e-40}}};
    for (const Way& way : ways) {
      if (way.options.count("step_max") > 0) continue;
      const SolveReport one = solved(problem, way), other = solved(general, way);
      CAPTURE(in_words(way), other.reason);
      CHECK(other.status == SolveStatus::complete);
      CHECK(static_cast<double>(other.work.iterations) ==
            Approx(static_cast<double>(one.work.iterations)).epsilon(0.1));
      REQUIRE(one.candidates.size() == other.candidates.size());
      for (std::size_t i = 0; i < one.candidates.size(); ++i)
        CHECK((one.candidates[i].figure.points - other.candidates[i].figure.points).norm() <= 1e-12);
    }
  }
}

TEST_CASE("S over polynomials changes no bit where the unit does") {
  ProblemStatement problem = samples::k33();
  problem.interpolation.bends = {{2, {0.5, 0.75}}, {8, {1, -0.5, 0.25}}};
  ProblemStatement larger = problem;
  for (DistanceConstraint& c : larger.constraints) c.given.value = std::ldexp(c.given.value, 70);
  larger.sketch = larger.sketch->scaled(70);
  for (BentLength& bent : *larger.interpolation.bends)
    for (double& c : bent.coefficients) c = std::ldexp(c, 70);
  for (const Way& way : {ways[0], ways[2], ways[3]}) {
    const SolveReport one = solved(problem, way), other = solved(larger, way);
    CAPTURE(in_words(way), one.reason);
    CHECK(one.status == other.status);
    CHECK(one.work.newton_iterations == other.work.newton_iterations);
    REQUIRE(one.candidates.size() == other.candidates.size());
    for (std::size_t i = 0; i < one.candidates.size(); ++i)
      CHECK(one.candidates[i].figure.points == other.candidates[i].figure.points);
  }
}
