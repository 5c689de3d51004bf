/// The chain of rockers against its figures at each t, which circles in the plane give one after the other.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "harness/instances/families.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"

using namespace gcs;

namespace {

/// The figures that the lengths at one t allow, with the first two points in place and no rocker turned over.
class FiguresByCircles {
 public:
  FiguresByCircles(const ProblemStatement& problem, double t)
      : problem_(problem), t_(t), at_(problem.points.size()) {
    at_[1] = {length(0), 0};
  }

  int count(std::size_t point = 2) {
    if (point == at_.size()) return 1;
    std::vector<std::size_t> given;
    for (std::size_t c = 0; c < problem_.constraints.size(); ++c)
      if (later_end(c) == point) given.push_back(c);
    REQUIRE(given.size() == 2);
    const std::size_t a = earlier_end(given[0]), b = earlier_end(given[1]);
    const double radius = length(given[0]), other = length(given[1]);
    const double dx = at_[b].x - at_[a].x, dy = at_[b].y - at_[a].y, apart = std::hypot(dx, dy);
    const double along = (radius * radius - other * other + apart * apart) / (2 * apart);
    const double square = radius * radius - along * along;
    if (square < 0) return 0;
    int figures = 0;
    for (const double side : {1.0, -1.0}) {
      if (is_rigid(a, b, given) && side != side_in_sketch(a, b, point)) continue;
      const double up = side * std::sqrt(square);
      at_[point] = {at_[a].x + (along * dx - up * dy) / apart, at_[a].y + (along * dy + up * dx) / apart};
      figures += count(point + 1);
    }
    return figures;
  }

 private:
  struct Place {
    double x = 0, y = 0;
  };

  std::size_t end(std::size_t c, bool later) const {
    const auto [a, b] = problem_.constraints[c].between;
    return static_cast<std::size_t>(later ? std::max(a, b) : std::min(a, b));
  }
  std::size_t later_end(std::size_t c) const { return end(c, true); }
  std::size_t earlier_end(std::size_t c) const { return end(c, false); }
  bool is_bent(std::size_t c) const { return static_cast<int>(c) == problem_.interpolation.bent; }

  /// [I] §7.3.1.
  double length(std::size_t c) const {
    const double target = problem_.constraints[c].given.value,
                 bend = is_bent(c) ? problem_.interpolation.bend : 0;
    const auto& points = problem_.sketch->points;
    const double sketched =
        (points.col(static_cast<int>(earlier_end(c))) - points.col(static_cast<int>(later_end(c)))).norm();
    return -bend * t_ * t_ + (target - sketched + bend) * t_ + sketched;
  }

  /// Whether a triangle on a and b, which cannot turn over.
  bool is_rigid(std::size_t a, std::size_t b, const std::vector<std::size_t>& given) const {
    for (std::size_t c = 0; c < problem_.constraints.size(); ++c)
      if (earlier_end(c) == std::min(a, b) && later_end(c) == std::max(a, b))
        return !is_bent(given[0]) && !is_bent(given[1]);
    return false;
  }

  double side_in_sketch(std::size_t a, std::size_t b, std::size_t point) const {
    const auto& points = problem_.sketch->points;
    const auto ia = static_cast<int>(a), ib = static_cast<int>(b), ip = static_cast<int>(point);
    const Eigen::Vector3d base = points.col(ib) - points.col(ia), arm = points.col(ip) - points.col(ia);
    return base.x() * arm.y() - base.y() * arm.x() > 0 ? 1 : -1;
  }

  const ProblemStatement& problem_;
  double t_;
  std::vector<Place> at_;
};

ProblemStatement chain(int rockers) { return load_member("rocker-chain@" + std::to_string(rockers)).problem; }

/// Where S turns, two figures come or go.
int turns_by_circles(const ProblemStatement& problem) {
  int before = 0, ends = 0;
  for (double t = -0.3; t < 1.4; t += 0.002) {
    const int now = FiguresByCircles(problem, t).count();
    ends += std::abs(now - before);
    before = now;
  }
  REQUIRE(before == 0);
  return ends / 2;
}

SolveRun solved(const ProblemStatement& problem, const std::string& strategy, const OptionMap& options) {
  return run_strategy(find_strategy(strategy), options, Scene(problem), {});
}

}  // namespace

TEST_CASE(
    "a chain of rockers has twice as many figures with each, and turns twice as often and two times more") {
  int figures = 1, turns = 0;
  for (int rockers = 1; rockers <= 8; ++rockers) {
    INFO(rockers);
    const ProblemStatement problem = chain(rockers);
    CHECK(FiguresByCircles(problem, 1).count() == (figures *= 2));
    CHECK(turns_by_circles(problem) == (turns = 2 * turns + 2));
  }
}

TEST_CASE("all figures of a chain of rockers are on S, proven") {
  for (int rockers = 1; rockers <= 6; ++rockers) {
    INFO(rockers);
    const ProblemStatement problem = chain(rockers);
    const SolveRun run = solved(problem, "full-space", {{"mode", "certified"}});
    REQUIRE(run.ends.size() == 1);
    CHECK(run.ends.front().proven);
    CHECK(static_cast<int>(run.crossings.size()) == FiguresByCircles(problem, 1).count());
  }
}

TEST_CASE("every turn of a chain of rockers costs the plan an exchange") {
  for (int rockers = 1; rockers <= 6; ++rockers) {
    INFO(rockers);
    const ProblemStatement problem = chain(rockers);
    const int turns = turns_by_circles(problem);
    const SolveRun published = solved(problem, "rcp", {{"mode", "paper"}, {"step_max", "0.025"}});
    const SolveRun by_series = solved(problem, "rcp", {});
    for (const SolveRun& run : {published, by_series}) {
      CHECK(run.status == RunStatus::complete);
      CHECK(static_cast<int>(run.crossings.size()) == FiguresByCircles(problem, 1).count());
      CHECK(run.work.plan_changes >= turns);
    }
    const auto exchanges = std::find_if(published.particulars.begin(), published.particulars.end(),
                                        [](const Particular& count) { return count.name == "exchanges"; });
    REQUIRE(exchanges != published.particulars.end());
    CHECK(exchanges->value == turns);
  }
}
