/// Results are written, spoiled and verified: every kind of spoiling is caught under its own name.

#include "harness/results/verify.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "harness/results/result_io.hpp"
#include "harness/results/strategy_choice.hpp"
#include "solvers/answers/certify.hpp"

using namespace gcs;
using Json = nlohmann::json;

namespace {

struct Case {
  std::string instance;
  std::string strategy;
};

/// Points in the plane and in space, real and complex, on a path and all; a line that the frame holds, and
/// one beside given points.
const std::vector<Case> cases{{"k33", "rcp"},
                              {"octahedron", "cayley-menger"},
                              {"octahedron-cyclohexane", "cayley-menger"},
                              {"disulfide", "full-space"},
                              {"hoffmann-yuan", "theta-scan"},
                              {"tangents-durand", "sphere-tangents"}};

Json result_of(const Case& one, int threads = 1) {
  const Instance instance = load_instance(one.instance);
  RunLimits limits;
  limits.certify = true;
  limits.threads = threads;
  const SolveRun run = run_strategy(find_strategy(one.strategy), {}, Scene(instance.problem), limits);
  REQUIRE(run.status == RunStatus::complete);
  CHECK(run.failed_checks.empty());
  return Json::parse(result_text(instance, run, {}));
}

std::set<std::string> mismatches(const Json& result) {
  std::set<std::string> names;
  for (const FailedCheck& mismatch : verify(parse_result(result.dump(), "result.json"), 2).mismatches)
    names.insert(mismatch.name);
  return names;
}

using CheckNames = std::set<std::string>;

/// The first number that is not 0 among the coordinates of the solution's points or lines.
double& first_coordinate(Json& solution, const char* entities) {
  std::vector<Json*> open{&solution[entities]};
  while (!open.empty()) {
    Json* value = open.back();
    open.pop_back();
    if (value->is_number_float() && value->get<double>() != 0) return value->get_ref<double&>();
    if (value->is_structured())
      for (Json& part : *value) open.push_back(&part);
  }
  throw std::logic_error("a solution without coordinates");
}

}  // namespace

TEST_CASE("ill-conditioned solutions of a general scene are verified without bounds of their own") {
  const Instance instance = load_instance("dietmaier");
  const SolveRun run = run_strategy(find_strategy("polyhedral"), {}, Scene(instance.problem), {});
  REQUIRE(run.status == RunStatus::complete);
  CHECK(mismatches(Json::parse(result_text(instance, run, {}))).empty());
}

TEST_CASE("what a strategy finds is certified, and its result verified from the file alone") {
  for (const Case& one : cases) {
    INFO(one.instance << ", " << one.strategy);
    const Json result = result_of(one);
    CHECK(result["counts"]["certified"] == result["solutions"].size());
    for (const Json& solution : result["solutions"]) {
      CHECK(solution["certified"] == true);
      CHECK(solution["error_bound"].get<double>() > 0);
    }
    CHECK(mismatches(result).empty());
  }
}

TEST_CASE("certified facts are the same for any number of threads") {
  for (const Case& one : cases) {
    const Json alone = result_of(one), shared = result_of(one, 3);
    INFO(one.instance);
    for (const char* member : {"proofs", "counts", "solutions"}) CHECK(alone[member] == shared[member]);
    const StoredResult stored = parse_result(alone.dump(), "result.json");
    const Proofs first = verify(stored, 1).proofs, second = verify(stored, 3).proofs;
    CHECK(first.classes == second.classes);
    CHECK(first.most_bits == second.most_bits);
  }
}

TEST_CASE("touching spheres have three tangents of multiplicity four, which are all there are") {
  const Scene scene(load_instance("tangents-fourfold").problem);
  RunLimits limits;
  limits.certify = true;
  for (const std::string strategy : {"sphere-tangents", "monodromy"}) {
    SolveRun run = run_strategy(find_strategy(strategy), {}, scene, limits);
    REQUIRE(run.proofs);
    INFO(strategy);
    CHECK(run.proofs->classes == 3);
    CHECK(run.proofs->real == 3);
    CHECK(run.proofs->clusters == 3);
    CHECK(run.proofs->in_clusters == 12);
    CHECK(run.proofs->multiple == 3);
    CHECK(run.proofs->are_complete());
    CHECK(run.proofs->decide_real());
    CHECK(run.failed_checks.empty());

    // Another multiplicity is refuted, and a line that is listed twice counts once.
    run.solutions[0].multiplicity = 3;
    run.solutions.push_back(run.solutions[1]);
    certify(scene, theoretical_counts(scene.problem()), {}, {}, run);
    REQUIRE(run.failed_checks.size() == 2);
    for (const FailedCheck& check : run.failed_checks) CHECK(check.name == "certificate");
    CHECK(run.proofs->classes == 2);
    CHECK(run.proofs->in_clusters == 12);
  }
}

TEST_CASE("a figure that is its own mirror image is one class, and proven where it has fractions") {
  // (0, 0), (3, 0), (0, 4) and (1, 1), all in a plane of space, or the last one 1e-20 above it.
  const auto proofs_at = [](const std::string& square) {
    const auto distance = [](const char* between, const std::string& value) {
      return R"({"type": "distance", "between": [)" + std::string(between) + "], " + value + "}";
    };
    const std::string text = R"({"format": "gcsbench-instance/1", "id": "flat", "dimension": 3,
      "points": ["a", "b", "c", "d"], "constraints": [)" +
                             distance(R"("a", "b")", R"("length": 3)") + "," +
                             distance(R"("b", "c")", R"("length": 5)") + "," +
                             distance(R"("c", "a")", R"("length": 4)") + "," +
                             distance(R"("b", "d")", R"("squared": 5)" + square) + "," +
                             distance(R"("c", "d")", R"("squared": 10)" + square) + "," +
                             distance(R"("d", "a")", R"("squared": 2)" + square) + "]}";
    RunLimits limits;
    limits.certify = true;
    SolveRun run = run_strategy(find_strategy("monodromy"), {},
                                Scene(parse_instance(text, "flat.json").problem), limits);
    return *run.proofs;
  };
  const Proofs flat = proofs_at("");
  CHECK(flat.classes == 1);
  CHECK(flat.real == 1);
  CHECK(flat.multiple == 1);
  CHECK(flat.with_multiplicities() == 1);
  CHECK(flat.decide_real());
  CHECK(proofs_at("." + std::string(39, '0') + "1").multiple == 0);
}

TEST_CASE("a solution at infinity is proven anew from a file, and counted once") {
  // An equator of the octahedron sums to 0, 1.8 + 1.8 = 1.9 + 1.7: one class of 8 is at infinity.
  const Json result = result_of({"escaping@0", "monodromy"});
  CHECK(result["proofs"]["at_infinity"] == 1);
  CHECK(result["proofs"]["complete"] == true);
  CHECK(verify(parse_result(result.dump(), "result.json"), 1).proofs.are_complete());

  Json twice = result;
  twice["escaping"].push_back(result["escaping"][0]);
  CHECK(verify(parse_result(twice.dump(), "result.json"), 1).proofs.at_infinity == 1);

  Json without = result;
  without["escaping"].clear();
  const Proofs proofs = verify(parse_result(without.dump(), "result.json"), 1).proofs;
  CHECK(proofs.at_infinity == 0);
  CHECK(!proofs.are_complete());
}

TEST_CASE("proofs that are stopped leave a list without objections") {
  const Scene scene(load_instance("octahedron").problem);
  SolveRun run = run_strategy(find_strategy("cayley-menger"), {}, scene, {});
  std::stop_source stop;
  stop.request_stop();
  certify(scene, theoretical_counts(scene.problem()), {}, {.stop = stop.get_token()}, run);
  CHECK(run.failed_checks.empty());
  CHECK(run.proofs->classes == 0);
  CHECK(run.solutions.size() == 8);
}

TEST_CASE("counts that one side does not know are caught") {
  Json result = result_of(cases[1]);
  result["totals"] = {{"real", nullptr}, {"complex", nullptr}, {"generic", nullptr}};
  CHECK(mismatches(result).count("count") == 1);
  result = result_of(cases[1]);
  result["counts"] = Json::object();
  result["totals"] = {{"real", 4}, {"complex", nullptr}, {"generic", nullptr}};
  CHECK(mismatches(result).count("count") == 1);
}

TEST_CASE("totals that the list and theory contradict are caught") {
  Json result = result_of(cases[1]);
  const std::uint64_t complex = result["solutions"].size();
  const auto with_totals = [&](std::uint64_t real, std::uint64_t all, const char* status) {
    Json other = result;
    other["status"] = status;
    other["totals"] = {{"real", real}, {"complex", all}, {"generic", result["counts"]["generic"]}};
    other["counts"]["real_up_to_reflection"] = real;
    other["counts"]["complex_up_to_reflection"] = all;
    other["counts"]["certified"] = other["solutions"].size();
    return mismatches(other);
  };
  CHECK(with_totals(4, complex, "complete").empty());
  CHECK(with_totals(4, complex - 1, "partial").count("count") == 1);  // fewer than are listed
  CHECK(with_totals(4, 100, "partial").count("count") == 1);          // more than there can be
  result["solutions"].erase(complex - 1);
  CHECK(with_totals(4, complex, "partial").empty());
  CHECK(with_totals(4, complex, "complete").count("count") == 1);  // not all are listed
  result = result_of(cases[1]);
  result["counts"]["generic"] = 999;
  CHECK(mismatches(result).count("count") == 1);
}

TEST_CASE("words that a result cannot have are refused") {
  for (const char* member : {"status", "claim"}) {
    Json result = result_of(cases[1]);
    result[member] = "all complexx";
    CHECK_THROWS_AS(parse_result(result.dump(), "result.json"), InputError);
  }
}

TEST_CASE("a shifted solution is caught") {
  for (const Case& one : cases) {
    INFO(one.instance);
    Json result = result_of(one);
    const bool has_free_line = one.instance == "tangents-durand";
    first_coordinate(result["solutions"][0], has_free_line ? "lines" : "points") += 1e-9;
    CHECK(mismatches(result) == CheckNames{"solution"});
    // Where no bound is stated the scene's size sets it.
    result["solutions"][0]["error_bound"] = nullptr;
    CHECK(mismatches(result) == CheckNames{"solution"});
  }
}

TEST_CASE("a shift of what the frame or the file gives is caught") {
  Json result = result_of({"octahedron", "cayley-menger"});
  result["solutions"][0]["points"]["p1"] = {1e-9, 0, 0};
  CHECK(mismatches(result) == CheckNames{"solution"});
  result = result_of({"tangents-durand", "sphere-tangents"});
  Json& centre = result["solutions"][0]["points"].begin().value();
  centre[0] = centre[0].get<double>() + 1e-9;
  CHECK(mismatches(result) == CheckNames{"solution"});
  result = result_of({"hoffmann-yuan", "theta-scan"});
  result["solutions"][0]["lines"].begin().value()["direction"] = {1, 1e-9, 0};
  CHECK(mismatches(result) == CheckNames{"solution"});
  result = result_of({"hoffmann-yuan", "theta-scan"});
  result["solutions"][0]["lines"].begin().value()["point"] = {0, 1e-9, 0};
  CHECK(mismatches(result) == CheckNames{"solution"});
}

TEST_CASE("a duplicate is caught, and a mirror image too") {
  for (const Case& one : cases) {
    INFO(one.instance);
    Json result = result_of(one);
    result["solutions"].push_back(result["solutions"][0]);
    CHECK(mismatches(result).count("class") == 1);
  }
  Json result = result_of({"octahedron", "cayley-menger"});
  Json image = result["solutions"][0];
  for (Json& point : image["points"]) point[2] = -point[2].get<double>();
  result["solutions"].push_back(image);
  CHECK(mismatches(result).count("class") == 1);
}

TEST_CASE("a wrong multiplicity is caught") {
  for (const Case& one : cases) {
    INFO(one.instance);
    Json result = result_of(one);
    result["solutions"][0]["multiplicity"] = 7;
    if (!result["counts"]["singular"].is_null()) result["counts"]["singular"] = 1;
    CHECK(mismatches(result) == CheckNames{"multiplicity"});
  }
}

TEST_CASE("multiple solutions are verified with their multiplicities") {
  const Instance instance = load_instance("tangents-fourfold");
  const SolveRun run = run_strategy(find_strategy("sphere-tangents"), {}, Scene(instance.problem), {});
  Json result = Json::parse(result_text(instance, run, {}));
  CHECK(mismatches(result).empty());
  result["solutions"][0]["multiplicity"] = 2;
  CHECK(mismatches(result) == CheckNames{"multiplicity"});
}

TEST_CASE("a dropped solution is caught") {
  for (const Case& one : cases) {
    INFO(one.instance);
    Json result = result_of(one);
    result["solutions"].erase(result["solutions"].size() - 1);
    if (result["path"].is_array())
      for (Json& crossing : result["path"])
        if (crossing["solution"] == result["solutions"].size()) crossing["solution"] = nullptr;
    CHECK(mismatches(result).count("count") == 1);
  }
}

TEST_CASE("a solution without its conjugate is caught even where counts are adjusted") {
  // Of the disulfide's 32 classes 14 are complex, in pairs.
  Json result = result_of({"disulfide", "polyhedral"});
  const std::size_t left = result["solutions"].size() - 1;
  REQUIRE(result["solutions"][left]["real"] == false);
  result["solutions"].erase(left);
  for (const char* count : {"complex", "complex_up_to_reflection"}) result["counts"][count] = left;
  result["counts"]["certified"] = left;
  CHECK(mismatches(result) == CheckNames{"conjugate"});
}

TEST_CASE("solutions of other lengths are caught") {
  for (const Case& one : cases) {
    INFO(one.instance);
    Json result = result_of(one);
    Json& constraint = result["instance"]["constraints"][0];
    Json& given = constraint.contains("length") ? constraint["length"] : constraint["squared"];
    given = given.get<double>() * (1 + 1e-6);
    CHECK(mismatches(result).count("solution") == 1);
  }
}

TEST_CASE("a real solution that is listed as complex is caught") {
  Json result = result_of({"octahedron", "cayley-menger"});
  Json& solution = result["solutions"][0];
  solution["real"] = false;
  for (Json& point : solution["points"])
    for (Json& coordinate : point) coordinate = Json::array({coordinate, 0.0});
  CHECK(mismatches(result).count("real") == 1);
}

TEST_CASE("another convention, and counts by it that the list contradicts, are caught") {
  Json result = result_of(cases[1]);
  CHECK(result["counts"]["convention"] == "up to reflection");
  result["counts"]["convention"] = "up to motion";
  CHECK(mismatches(result) == CheckNames{"convention"});
  result = result_of(cases[1]);
  result["counts"]["real_up_to_reflection"] = 5;
  CHECK(mismatches(result) == CheckNames{"count"});
  // Results of earlier versions have neither.
  result = result_of(cases[1]);
  for (const char* member : {"convention", "real", "complex"}) result["counts"].erase(member);
  CHECK(mismatches(result).empty());
}

TEST_CASE("a result says the same in whatever order its members stand") {
  const Json result = result_of({"k33", "rcp"});
  nlohmann::ordered_json turned;
  for (auto member = result.rbegin(); member != result.rend(); ++member)
    turned[member.key()] = member.value();
  REQUIRE(turned.begin().key() == "totals");
  const Answer first = parse_result(result.dump(), "a.json").answer;
  const Answer second = parse_result(turned.dump(), "b.json").answer;
  CHECK(first.solutions.size() == result["solutions"].size());
  REQUIRE(second.solutions.size() == first.solutions.size());
  for (std::size_t i = 0; i < first.solutions.size(); ++i)
    CHECK(second.solutions[i].figure.points == first.solutions[i].figure.points);
  CHECK(second.counts.real_up_to_reflection == first.counts.real_up_to_reflection);
}

TEST_CASE("a file that is no result is refused with its place") {
  CHECK_THROWS_WITH(parse_result("{\"format\": \"gcsbench-run/1\"}", "a.json"),
                    Catch::StartsWith("a.json: /format"));
  Json result = result_of({"k33", "rcp"});
  REQUIRE(result["solutions"].size() > 1);
  result["solutions"][1]["points"].erase("p3");
  CHECK_THROWS_WITH(parse_result(result.dump(), "a.json"), Catch::StartsWith("a.json: /solutions/1/points"));
}
