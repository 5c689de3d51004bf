#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// By value and solution: the solutions on the curve through it.
using Curves = std::map<std::pair<int, int>, std::set<int>>;

/// Of a graph in the plane, whose sketch is the one solution that is known before any curve is walked.
ProblemStatement at_a_solution(int points, RandomNumbers& random) {
  const Eigen::Matrix3Xd figure = random.points(2, points, 2);
  ProblemStatement problem =
      samples::between(2, samples::random_rigid_graph(2, points, random), figure, figure);
  problem.interpolation.bends.emplace();
  return problem;
}

SolveReport explored(const Scene& scene) {
  const std::span<const StrategyEntry> all = all_strategies();
  const auto entry = std::ranges::find(all, "explore", &StrategyEntry::name);
  return entry->make(complete_options(*entry, {{"starts", "0"}, {"reduce", "off"}}))
      ->solve(SolveRequest(scene));
}

std::set<int> on(const CurveRecord& curve) {
  std::set<int> solutions;
  for (const Crossing& crossing : curve.path.crossings) solutions.insert(crossing.candidate);
  return solutions;
}

Curves curves_of(const SolveReport& report) {
  Curves curves;
  for (const CurveRecord& curve : report.curves)
    for (const int solution : on(curve)) curves[{curve.released, solution}] = on(curve);
  return curves;
}

std::set<int> component_of_first(const Curves& curves) {
  std::set<int> reached{0};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [through, members] : curves)
      if (reached.contains(through.second)) reached.insert(members.begin(), members.end());
  }
  return reached;
}

/// How many curves are walked, in the order of the report, until all of these solutions are met.
int curves_walked(const SolveReport& report, std::size_t goal) {
  std::set<int> met{0};
  int walked = 0;
  for (const CurveRecord& curve : report.curves) {
    if (met.size() == goal) break;
    met.merge(on(curve));
    ++walked;
  }
  return walked;
}

/// The same from the solution that was found first, one value after the other.
int curves_in_plain_order(Curves curves, int values, std::size_t goal) {
  std::vector<int> met{0};
  int walked = 0;
  for (int round = 0; met.size() < goal; ++round)
    for (int value = 0; value < values && met.size() < goal; ++value)
      for (std::size_t i = 0; i < met.size(); ++i) {
        const auto curve = curves.find({value, met[i]});
        if (curve == curves.end()) continue;
        const std::set<int> members = curve->second;
        for (const int member : members) {
          curves.erase({value, member});
          if (std::ranges::find(met, member) == met.end()) met.push_back(member);
        }
        ++walked;
        break;
      }
  return walked;
}

}  // namespace

TEST_CASE("solutions are met after two thirds of the curves that the plain order walks") {
  RandomNumbers random(7);
  int own = 0, plain = 0;
  for (int graph = 0; graph < 8; ++graph) {
    const ProblemStatement problem = at_a_solution(10, random);
    const SolveReport report = explored(Scene(problem));
    const Curves curves = curves_of(report);
    const std::size_t goal = component_of_first(curves).size();
    own += curves_walked(report, goal);
    plain += curves_in_plain_order(curves, static_cast<int>(problem.constraints.size()), goal);
  }
  INFO(own << " and " << plain);
  CHECK(3 * own <= 2 * plain);
  CHECK(plain > 0);
}
