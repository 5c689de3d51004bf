/// The scan over a grid against a slow direct loop, against the proven solutions, and against itself in other
/// units and on other numbers of threads.

#include "solvers/scanning/grid_scan.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solvers/figures/reflection_classes.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/scanning/plan_scan.hpp"
#include "solvers/scanning/step_pieces.hpp"
#include "solvers/scanning/step_places.hpp"
#include "solvers/strategies/plan_scan.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Point = Eigen::Vector3d;

/// Of four points with each of six others: three driving parameters, and no distance is checked before the
/// last point.
samples::Edges four_by_six() {
  samples::Edges edges;
  for (int a = 0; a < 4; ++a)
    for (int b = 4; b < 10; ++b) edges.push_back({a, b});
  return edges;
}

Scene random_scene(int dimension, int points, const samples::Edges& edges, RandomNumbers& random) {
  const Eigen::Matrix3Xd target = random.points(dimension, points, 1);
  const Eigen::Matrix3Xd sketch = random.points(dimension, points, 1);
  return Scene::unchecked(samples::between(dimension, edges, sketch, target));
}

Scene random_octahedron(RandomNumbers& random) {
  samples::Edges edges;
  for (const DistanceConstraint& c : samples::octahedron().constraints) edges.push_back(c.between);
  return random_scene(3, 6, edges, random);
}

Scene random_k33(RandomNumbers& random) {
  samples::Edges edges;
  for (const DistanceConstraint& c : samples::k33().constraints) edges.push_back(c.between);
  return random_scene(2, 6, edges, random);
}

GridScan grid_of(const ScanPlan& plan, double step, double delta) {
  GridScan asked;
  for (const auto& range : plan.ranges) asked.angles.push_back(grid_over(range, 0, step));
  asked.delta = delta;
  return asked;
}

std::int64_t count_of(const SolveReport& report, std::string_view name) {
  const auto found = std::find_if(report.particulars.begin(), report.particulars.end(),
                                  [&](const Particular& p) { return p.name == name; });
  return found == report.particulars.end() ? -1 : found->value;
}

/// The grid scan as its definition reads, without any of its short cuts: for every point of the grid and every
/// choice of signs all points are placed, by other formulas, and only then ρ is looked at.
class DirectLoop {
 public:
  explicit DirectLoop(const Scene& scene) : scene_(scene), plan_(derive_scan_plan(scene)) {}

  std::int64_t coarse(double step, double delta) const {
    std::vector<double> angles;
    return over_angles(angles, step * std::numbers::pi / 180, delta);
  }

 private:
  double length(const ScanSphere& sphere) const { return scene_.target_lengths()[sphere.constraint]; }

  std::int64_t over_angles(std::vector<double>& angles, double step, double delta) const {
    if (angles.size() == plan_.ranges.size()) return over_signs(angles, delta);
    const auto [low, high] = plan_.ranges[angles.size()];
    std::int64_t count = 0;
    for (int i = 0; low + i * step < high - 1e-9; ++i) {
      angles.push_back(low + i * step);
      count += over_angles(angles, step, delta);
      angles.pop_back();
    }
    return count;
  }

  std::int64_t over_signs(const std::vector<double>& angles, double delta) const {
    std::int64_t count = 0;
    for (unsigned signs = 0; signs < 1U << plan_.steps.size(); ++signs) {
      Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, scene_.point_count());
      bool exists = true;
      for (std::size_t k = 0; k < plan_.steps.size() && exists; ++k) {
        const ScanStep& step = plan_.steps[k];
        const bool has_two = step.freedom > 1 && step.angles() == 0 && !step.upper;
        const bool is_minus = (signs >> k & 1U) != 0;
        exists = (has_two || !is_minus) && place(step, angles, is_minus ? -1 : 1, points);
      }
      if (exists && rho(points) < delta) ++count;
    }
    return count;
  }

  double rho(const Eigen::Matrix3Xd& points) const {
    double rho = 0;
    for (std::size_t c = 0; c < scene_.problem().constraints.size(); ++c) {
      const auto [a, b] = scene_.problem().constraints[c].between;
      rho = std::max(rho, std::abs((points.col(a) - points.col(b)).norm() - scene_.target_lengths()[c]));
    }
    return rho;
  }

  bool place(const ScanStep& step, const std::vector<double>& angles, int sign,
             Eigen::Matrix3Xd& points) const {
    const auto center = [&](int i) -> Point { return points.col(step.spheres[i].center); };
    Point x = Point::Zero();
    if (step.freedom == 1) x[0] = length(step.spheres[0]);
    if (step.freedom == 2 && step.angles() == 1) {
      const double angle = angles[step.first_angle];
      x = center(0) + length(step.spheres[0]) * Point(std::cos(angle), std::sin(angle), 0);
    }
    if (step.freedom == 3 && step.angles() == 2) {
      x = center(0) + length(step.spheres[0]) *
                          (Eigen::AngleAxisd(angles[step.first_angle], Point::UnitZ()) *
                           Eigen::AngleAxisd(-angles[step.first_angle + 1], Point::UnitY()) * Point::UnitX());
    }
    if (step.freedom == 2 && step.angles() == 0) {  // the law of cosines, and the angle at the first centre
      const double a = length(step.spheres[0]), b = length(step.spheres[1]);
      const Point way = center(1) - center(0);
      const double cosine = (a * a + way.squaredNorm() - b * b) / (2 * a * way.norm());
      if (std::abs(cosine) > 1) return false;
      const double angle = std::atan2(way[1], way[0]) + sign * std::acos(cosine);
      x = center(0) + a * Point(std::cos(angle), std::sin(angle), 0);
    }
    if (step.freedom == 3 && step.angles() == 1) {  // a circle, turned from the direction seen upwards
      const double a = length(step.spheres[0]), b = length(step.spheres[1]);
      const Point way = center(1) - center(0);
      const double cosine = (a * a + way.squaredNorm() - b * b) / (2 * a * way.norm());
      if (std::abs(cosine) > 1) return false;
      const Point axis = way.normalized();
      const Point up = step.upper ? Point(0, 0, 1) : Point(0.36, 0.48, 0.8);
      const Point side = up.cross(axis).normalized();
      x = center(0) + a * cosine * axis +
          a * std::sqrt(1 - cosine * cosine) * (Eigen::AngleAxisd(angles[step.first_angle], axis) * side);
    }
    if (step.freedom == 3 && step.angles() == 0) {  // linear equations for the foot, and the height over it
      Eigen::Matrix3d rows;
      rows << (center(1) - center(0)).transpose(), (center(2) - center(0)).transpose(),
          (center(1) - center(0)).cross(center(2) - center(0)).transpose();
      Point right = Point::Zero();
      for (int i = 1; i < 3; ++i)
        right[i - 1] =
            (length(step.spheres[0]) * length(step.spheres[0]) -
             length(step.spheres[i]) * length(step.spheres[i]) + (center(i) - center(0)).squaredNorm()) /
            2;
      const Point foot = rows.fullPivLu().solve(right);
      const double square = length(step.spheres[0]) * length(step.spheres[0]) - foot.squaredNorm();
      if (square < 0) return false;
      x = center(0) + foot + sign * std::sqrt(square) * rows.row(2).transpose().normalized();
    }
    points.col(step.place) = x;
    return true;
  }

  const Scene& scene_;
  ScanPlan plan_;
};

void check_against_direct_loop(const Scene& scene, double step, double delta, std::int64_t at_least) {
  const ScanPlan plan = derive_scan_plan(scene);
  const SolveReport scan = grid_scan(SolveRequest(scene), plan, grid_of(plan, step, delta));
  const std::int64_t expected = DirectLoop(scene).coarse(step, delta);
  INFO(plan.angles() << " angles, step " << step << ", band " << delta);
  CHECK(scan.status == SolveStatus::complete);
  CHECK(expected >= at_least);
  CHECK(count_of(scan, "coarse_solutions") == expected);
}

/// The refined solutions are among the proven ones; how many of these are missed.
std::size_t missed(const Scene& scene, double step) {
  constexpr double band = 0.02;  // of the scene
  const ScanPlan plan = derive_scan_plan(scene);
  const ScanOutcome proven = scan_plan(SolveRequest(scene), plan, 10'000'000);
  REQUIRE(proven.end == ScanOutcome::End::complete);
  REQUIRE(proven.undecided.empty());
  const SolveReport scan = grid_scan(SolveRequest(scene), plan, grid_of(plan, step, band * scene.size()));
  std::vector<Figure> figures;
  for (const ScanSolution& solution : proven.solutions) figures.push_back(solution.figure);
  for (const Candidate& candidate : scan.candidates) figures.push_back(candidate.figure);
  const auto classes = static_cast<std::size_t>(reflection_classes(scene, figures, 1e-7).count());
  CHECK(classes == proven.solutions.size());
  CHECK(count_of(scan, "refined_solutions") == static_cast<std::int64_t>(scan.candidates.size()));
  CHECK(scan.candidates.size() <= proven.solutions.size());
  return proven.solutions.size() - scan.candidates.size();
}

const StrategyEntry& plan_scan() {
  const auto entries = all_strategies();
  return *std::find_if(entries.begin(), entries.end(),
                       [](const StrategyEntry& entry) { return entry.name == "plan-scan"; });
}

SolveReport published(const SolveRequest& request, OptionMap options) {
  options["method"] = "published";
  return plan_scan().make(complete_options(plan_scan(), options))->solve(request);
}

void check_same(const SolveReport& one, const SolveReport& other, double factor) {
  CHECK(one.particulars == other.particulars);
  CHECK(one.work.newton_iterations == other.work.newton_iterations);
  REQUIRE(one.candidates.size() == other.candidates.size());
  for (std::size_t i = 0; i < one.candidates.size(); ++i)
    CHECK(factor * one.candidates[i].figure.points == other.candidates[i].figure.points);
}

}  // namespace

TEST_CASE("coarse solutions are those that a direct loop over grid and signs finds") {
  RandomNumbers random(41);
  for (int i = 0; i < 10; ++i) {
    check_against_direct_loop(random_k33(random), 1, 0.1, 1);
    check_against_direct_loop(random_octahedron(random), 1, 0.1, 1);
  }
  for (int i = 0; i < 3; ++i) check_against_direct_loop(random_scene(3, 10, four_by_six(), random), 30, 1, 1);
  check_against_direct_loop(random_scene(2, 12, samples::dodecagon_edges(), random), 20, 1, 1);
}

TEST_CASE("steps place points where enclosures over the same angles have them") {
  RandomNumbers random(8);
  int compared = 0;
  const auto compare = [&](const Scene& scene) {
    const ScanPlan plan = derive_scan_plan(scene);
    const StepPlaces places(scene, plan);
    const StepPieces<3> pieces(target_squares(scene), plan.angles());
    Cell<3> cell;
    for (int i = 0; i < plan.angles(); ++i) {
      cell.mid[i] = random.uniform(plan.ranges[i][0], plan.ranges[i][1]);
      cell.half[i] = 1e-9;
    }
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, scene.point_count());
    std::vector<FormVector<3>> enclosures(scene.point_count());
    for (std::size_t k = 0; k < plan.steps.size(); ++k) {
      const ScanStep& step = plan.steps[k];
      std::array<double, 2> angles{};
      for (int i = 0; i < step.angles(); ++i) angles[i] = cell.mid[step.first_angle + i];
      const Places found = places.of(k, points, angles);
      const Pieces<3> enclosed = pieces.of(step, enclosures, cell, {});
      REQUIRE(static_cast<int>(enclosed.list.size()) == found.count);
      if (found.count == 0) return;
      for (int i = 0; i < found.count; ++i)
        for (int axis = 0; axis < 3; ++axis) {
          const AffineForm<3>& form = enclosed.list[i].position[axis];
          CHECK(std::abs(found.at[i][axis] - form.mid) <= form.radius() + 1e-12);
        }
      compared += found.count;
      const int one = random.index(found.count);
      points.col(step.place) = found.at[one];
      for (int axis = 0; axis < 3; ++axis) enclosures[step.place][axis].mid = points(axis, step.place);
    }
  };
  for (int i = 0; i < 20; ++i) {
    compare(random_k33(random));
    compare(random_octahedron(random));
    compare(random_scene(3, 10, four_by_six(), random));
  }
  CHECK(compared > 300);
}

// Within the same band a finer grid has points as near as one likes to every solution.
TEST_CASE("refined solutions are proven ones, and a grid fine enough finds them all") {
  RandomNumbers random(43);
  std::size_t of_coarse_grids = 0, of_fine_grids = 0;
  for (int i = 0; i < 10; ++i)
    for (const Scene& scene : {random_k33(random), random_octahedron(random)}) {
      of_coarse_grids += missed(scene, 30);
      of_fine_grids += missed(scene, 0.05);
    }
  CHECK(of_coarse_grids > 0);
  CHECK(of_fine_grids == 0);
}

TEST_CASE("a power of two changes nothing of a grid scan but the unit") {
  RandomNumbers random(44);
  for (int i = 0; i < 5; ++i) {
    const ProblemStatement problem = random_octahedron(random).problem();
    const SolveReport scan = published(SolveRequest(Scene::unchecked(problem)), {{"delta", "0.125"}});
    CHECK(count_of(scan, "coarse_solutions") > 0);
    for (const int exponent : {-60, -1, 60}) {
      ProblemStatement scaled = problem;
      for (DistanceConstraint& c : scaled.constraints) c.given.value = std::ldexp(c.given.value, exponent);
      scaled.sketch.reset();
      const std::string delta = Range<double>::text(std::ldexp(0.125, exponent));
      const Scene scene = Scene::unchecked(scaled);
      // Candidates are in the scene's unit, the same for all.
      check_same(scan, published(SolveRequest(scene), {{"delta", delta}}), 1);
      CHECK(count_of(published(SolveRequest(scene), {}), "coarse_solutions") ==
            count_of(published(SolveRequest(Scene::unchecked(problem)), {}), "coarse_solutions"));
    }
  }
}

TEST_CASE("a grid scan is the same on any number of threads") {
  RandomNumbers random(45);
  const Scene scene = random_scene(3, 10, four_by_six(), random);
  const OptionMap options{{"step", "20"}};
  const SolveReport alone = published(SolveRequest(scene, {.threads = 1}), options);
  CHECK(count_of(alone, "refined_solutions") > 1);
  for (const int threads : {2, 50})
    check_same(alone, published(SolveRequest(scene, {.threads = threads}), options), 1);
}

TEST_CASE("a stop is honoured within a grid of three angles") {
  struct Stopper final : Monitor {
    std::stop_source source;
    double last = -1;
    void progress(std::string_view, double fraction) override {
      CHECK(fraction > last);
      last = fraction;
      if (fraction >= 0.1) source.request_stop();
    }
  };
  RandomNumbers random(46);
  const Scene scene = random_scene(3, 10, four_by_six(), random);
  Stopper stopper;
  const SolveReport stopped = published(
      SolveRequest(scene, {.stop = stopper.source.get_token(), .monitor = &stopper}), {{"step", "15"}});
  CHECK(stopped.status == SolveStatus::stopped);
  const SolveReport whole = published(SolveRequest(scene), {{"step", "15"}});
  CHECK(whole.work.evaluations == 12 * 12 * 24);  // the mirrors halve the first two turns
  CHECK(stopped.work.evaluations > 0);
  CHECK(stopped.work.evaluations < whole.work.evaluations / 2);
  CHECK(count_of(stopped, "coarse_solutions") <= count_of(whole, "coarse_solutions"));
}

TEST_CASE("a grid too large, or empty, is refused with the reason") {
  RandomNumbers random(47);
  const Scene scene = random_scene(3, 10, four_by_six(), random);
  const SolveReport large = published(SolveRequest(scene), {{"step", "0.1"}});
  CHECK(large.status == SolveStatus::gave_up);
  CHECK_THAT(large.reason, Catch::StartsWith("the grid has ") && Catch::Contains("max_points"));
  CHECK(published(SolveRequest(scene), {{"step", "30"}, {"max_points", "431"}}).status ==
        SolveStatus::gave_up);
  CHECK(published(SolveRequest(scene), {{"step", "30"}, {"max_points", "432"}}).status ==
        SolveStatus::complete);
  const SolveReport empty = published(SolveRequest(scene), {{"start", "359"}, {"step", "30"}});
  CHECK(empty.status == SolveStatus::gave_up);
  CHECK_THAT(empty.reason, Catch::StartsWith("the grid is empty"));
}
