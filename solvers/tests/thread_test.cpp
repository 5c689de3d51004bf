/// More threads give the same report, bit for bit; under the thread sanitizer: without a data race.
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <iterator>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>

#include "solvers/answers/assess.hpp"
#include "solvers/answers/certify.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/reading/instance_parser.hpp"

namespace gcs {
namespace {

ProblemStatement shipped(const std::string& id) {
  std::ifstream file(std::string(GCSBENCH_SOURCE_DIR "/instances/") + id + ".json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return parse_instance(text, id, id).problem;
}

SolveReport solved(const Scene& scene, std::string_view name, const OptionMap& given, int threads,
                   const std::stop_token& stop = {}) {
  for (const StrategyEntry& entry : all_strategies()) {
    if (entry.name != name) continue;
    const std::unique_ptr<Strategy> strategy = entry.make(complete_options(entry, given));
    const SolveRequest request(scene, {.threads = threads, .stop = stop});
    strategy->prepare(request);
    return strategy->solve(request);
  }
  throw std::invalid_argument("no such strategy");
}

void check_same(const Figure& a, const Figure& b) {
  CHECK(a.points == b.points);
  CHECK(a.is_real() == b.is_real());
  if (!a.is_real()) CHECK(a.imaginary == b.imaginary);
}

void check_threads(const std::string& id, std::string_view name, const OptionMap& given) {
  const ProblemStatement problem = shipped(id);
  const Scene scene(problem);
  const SolveReport one = solved(scene, name, given, 1), four = solved(scene, name, given, 4);
  REQUIRE(one.status == SolveStatus::complete);
  CHECK(four.status == one.status);
  REQUIRE(one.candidates.size() == four.candidates.size());
  REQUIRE(!one.candidates.empty());
  for (std::size_t i = 0; i < one.candidates.size(); ++i)
    check_same(one.candidates[i].figure, four.candidates[i].figure);
}

}  // namespace

TEST_CASE("loops of monodromy are the same for any number of threads") {
  check_threads("disulfide", "monodromy", {});
}

TEST_CASE("polyhedral homotopies are the same for any number of threads") {
  check_threads("k33", "polyhedral", {{"formulation", "spheres"}});
  check_threads("k33", "polyhedral", {{"formulation", "coordinates"}});
}

TEST_CASE("boxes and grids are the same for any number of threads") {
  check_threads("octahedron", "box-subdivision", {});
  check_threads("k33", "plan-scan", {{"method", "published"}, {"step", "2"}});
}

TEST_CASE("certificates are the same for any number of threads") {
  const ProblemStatement problem = shipped("octahedron");
  const Scene scene(problem);
  const SolveReport report = solved(scene, "monodromy", {}, 4);
  const auto proven = [&](int threads) {
    Assessment assessment = assess(scene, report);
    certify(scene, theoretical_counts(problem), report.generic_member, {.threads = threads}, assessment);
    return assessment;
  };
  const Assessment one = proven(1), four = proven(4);
  CHECK(one.counts == four.counts);
  REQUIRE(one.counts.certified);
  CHECK(*one.counts.certified == 8);  // Cayley–Menger: 8 pairs of squared diagonals (Hoffmann and Yuan)
  for (std::size_t i = 0; i < one.solutions.size(); ++i)
    CHECK(one.solutions[i].error_bound == four.solutions[i].error_bound);
}

TEST_CASE("a solve on several threads hears that it is to stop") {
  const ProblemStatement problem = shipped("icosahedron");
  const Scene scene(problem);
  std::stop_source stop;
  std::thread clock([&] {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    stop.request_stop();
  });
  const SolveReport report = solved(scene, "monodromy", {}, 4, stop.get_token());
  clock.join();
  CHECK(report.status == SolveStatus::stopped);
}

}  // namespace gcs
