/// What strategies find against the proven solutions in results/reference: every certified solution lies
/// within its error bound of one of them, and no two at the same.

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"

using namespace gcs;
using Json = nlohmann::json;

namespace {

Json reference(const std::string& instance) {
  std::ifstream file(std::string(GCSBENCH_SOURCE_DIR) + "/results/reference/" + instance + ".json");
  REQUIRE(file);
  return Json::parse(file);
}

/// The largest distance of a point from its place in a real reference solution, in the file's unit.
double distance(const ProblemStatement& problem, const Figure& figure, const Json& solution) {
  double largest = 0;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const Json& place = solution["points"][problem.points[i]];
    double square = 0;
    for (int axis = 0; axis < problem.dimension; ++axis) {
      const double exact = std::stod(place[static_cast<std::size_t>(axis)].get<std::string>());
      square += std::pow(figure.points(axis, static_cast<Eigen::Index>(i)) - exact, 2);
    }
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

void check(const std::string& id, const std::string& strategy) {
  INFO(id << ", " << strategy);
  const Instance instance = load_instance(id);
  RunLimits limits;
  limits.certify = true;
  const SolveRun run = run_strategy(find_strategy(strategy), {}, Scene(instance.problem), limits);
  const Json solutions = reference(id)["solutions"];
  std::set<std::size_t> met;
  for (const AssessedSolution& solution : run.solutions) {
    if (!solution.figure.is_real()) continue;
    REQUIRE(solution.certified);
    // The reference's digits are rounded to doubles here.
    const Figure placement = solution.placement();
    const double bound = *solution.error() + 1e-15 * placement.points.cwiseAbs().maxCoeff();
    std::size_t nearest = solutions.size();
    for (std::size_t i = 0; i < solutions.size(); ++i)
      if (solutions[i]["real"] == true && distance(instance.problem, placement, solutions[i]) <= bound)
        nearest = i;
    REQUIRE(nearest < solutions.size());
    CHECK(met.insert(nearest).second);
  }
}

}  // namespace

TEST_CASE("certified solutions are those of the references") {
  check("octahedron", "cayley-menger");
  check("octahedron-cyclohexane", "plan-scan");
  check("k33", "rcp");
  check("prism", "plan-scan");
  check("disulfide", "full-space");
  check("disulfide", "plan-scan");
  check("hoffmann-yuan", "theta-scan");
}

TEST_CASE("the references are of the shipped instances, as they are") {
  for (const std::string id : {"octahedron", "disulfide", "hoffmann-yuan", "tangents-durand"}) {
    INFO(id);
    const Json document = Json::parse(to_text(load_instance(id).document, -1));
    CHECK(reference(id)["instance"] == document);
  }
}
