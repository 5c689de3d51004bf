#include "harness/solving/start_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "harness/tests/braced_k44.hpp"
#include "harness/tests/contract/problem_restatements.hpp"
#include "harness/tests/test_folder.hpp"

using namespace gcs;
using Json = nlohmann::json;

namespace {

SolveRun solved(const ProblemStatement& problem, const OptionMap& options) {
  return run_strategy(find_strategy("monodromy"), options, Scene(problem), {});
}

ProblemStatement problem_of(const std::string& id) { return load_instance(id).problem; }

std::optional<std::int64_t> particular(const SolveRun& run, const std::string& name) {
  for (const Particular& count : run.particulars)
    if (count.name == name) return count.value;
  return std::nullopt;
}

void check_same_solutions(const SolveRun& a, const SolveRun& b) {
  const auto &ours = a.solutions, &theirs = b.solutions;
  REQUIRE(ours.size() == theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    CHECK(ours[i].figure.points == theirs[i].figure.points);
    CHECK(ours[i].figure.imaginary == theirs[i].figure.imaginary);
  }
}

/// The message with which a start system is refused for the problem.
std::string refusal(const ProblemStatement& problem, const std::filesystem::path& file) {
  try {
    solved(problem, {{"start", file.string()}});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The file with one value replaced is refused with that place and word.
void check_refused(const std::filesystem::path& file, const Json& sound, const std::string& pointer,
                   const Json& value, const std::string& place, const std::string& word) {
  Json spoiled = sound;
  spoiled[Json::json_pointer(pointer)] = value;
  write_file(file, spoiled.dump());
  const std::string message = refusal(problem_of("octahedron"), file);
  INFO(message);
  CHECK(message.starts_with(file.string() + ": " + place + ": "));
  CHECK(message.find(word) != std::string::npos);
}

}  // namespace

TEST_CASE("what a search has found serves again, to the same bits") {
  const TestFolder folder;
  const std::string file = (folder / "start.json").string();
  // Bartzos et al. 2020 for the octahedron; what polyhedral finds for g16a; Mourrain 1993 for the platform.
  for (const auto& [id, classes] :
       {std::pair("octahedron", 8U), std::pair("g16a", 8U), std::pair("platform", 40U)}) {
    const SolveRun found = solved(problem_of(id), {{"save_start", file}});
    const SolveRun again = solved(problem_of(id), {{"start", file}});
    CHECK(again.status == RunStatus::complete);
    CHECK(again.counts.generic == classes);
    CHECK(particular(again, "stored_solutions") == classes);
    CHECK(particular(again, "trace_solutions") == particular(found, "trace_solutions"));
    CHECK(again.work.iterations < found.work.iterations);
    check_same_solutions(found, again);
  }
}

TEST_CASE("a stored start serves other lengths") {
  const TestFolder folder;
  const std::string file = (folder / "start.json").string();
  std::mt19937_64 random(3);
  const ProblemStatement problem = problem_of("octahedron");
  solved(problem, {{"save_start", file}});
  for (int i = 0; i < 5; ++i) {
    const SolveRun run = solved(contract::with_random_targets(problem, random), {{"start", file}});
    CHECK(run.status == RunStatus::complete);
    CHECK(run.counts.complex_up_to_reflection == 8U);
  }
}

TEST_CASE("a stored start is no more complete than the search that found it") {
  const TestFolder folder;
  const std::string file = (folder / "start.json").string();
  const ProblemStatement open = braced_k44();
  const SolveRun first = solved(open, {{"save_start", file}, {"trace", "off"}});
  REQUIRE(first.status == RunStatus::partial);
  const SolveRun again = solved(open, {{"start", file}});
  CHECK(again.status == RunStatus::partial);
  CHECK_FALSE(again.counts.generic);
  CHECK_THAT(again.reason,
             Catch::Contains(fmt::format("the stored start has {} classes", first.solutions.size())) &&
                 Catch::Contains("was not tested"));
}

TEST_CASE("a count makes a stored start complete by itself") {
  const TestFolder folder;
  const std::string file = (folder / "start.json").string();
  solved(problem_of("octahedron"), {{"save_start", file}});
  Json start = Json::parse(content_of(file));
  start["search"]["end"] = "quiet";
  write_file(file, start.dump());
  CHECK(solved(problem_of("octahedron"), {{"start", file}}).status == RunStatus::complete);
  // The claim of an edited file does not count: one solution fewer is not all.
  start["search"]["end"] = "complete";
  start["search"]["solutions"] = 7;
  start["solutions"].erase(3);
  write_file(file, start.dump());
  const SolveRun fewer = solved(problem_of("octahedron"), {{"start", file}});
  CHECK(fewer.status == RunStatus::partial);
  CHECK_THAT(fewer.reason, Catch::Contains("the stored start has 7 classes"));
}

TEST_CASE("a start system that is none is refused with the place") {
  const TestFolder folder;
  const std::filesystem::path file = folder / "start.json";
  solved(problem_of("octahedron"), {{"save_start", file.string()}});
  const Json sound = Json::parse(content_of(file));
  const Json& solutions = sound["solutions"];
  const double x = solutions[3][0][0];
  check_refused(file, sound, "/format", "gcsbench-start/2", "/format", "gcsbench-start/1");
  check_refused(file, sound, "/equations/2", "(x0-x3)^2", "/equations/2", "save_start");
  check_refused(file, sound, "/search/end", "completed", "/search/end", "did you mean 'complete'");
  check_refused(file, sound, "/search/paths", -1, "/search/paths", "whole number");
  check_refused(file, sound, "/search/solutions", 9, "/solutions", "there are 8 solutions");
  check_refused(file, sound, "/trace", 1, "/trace", "an object");
  check_refused(file, sound, "/squares/0", Json::array({1.0, 2.0, 3.0}), "/squares/0", "complex number");
  check_refused(file, sound, "/squares/0", Json::array({0.0, 0.0}), "/solutions/0", "no solution");
  check_refused(file, sound, "/solutions/2", Json::array(), "/solutions/2", "exactly");
  check_refused(file, sound, "/solutions/2/1", "1", "/solutions/2/1", "complex number");
  check_refused(file, sound, "/solutions/3/0/0", x * (1 + 1e-6), "/solutions/3", "no solution");
  // The square of 1e200 is no finite number.
  check_refused(file, sound, "/solutions/3/0/0", 1e200, "/solutions/3", "no solution");
  check_refused(file, sound, "/solutions/5", solutions[1], "/solutions/5", "solution 1 again");
  check_refused(file, sound, "/extra", 1, "/extra", "unknown field");
}

TEST_CASE("a start system of another graph is refused") {
  const TestFolder folder;
  const std::filesystem::path file = folder / "start.json";
  solved(problem_of("octahedron"), {{"save_start", file.string()}});
  CHECK_THAT(refusal(problem_of("k33"), file),
             Catch::Contains("/equations/") && Catch::Contains("the graph and frame that it was made for"));
}

TEST_CASE("files for start systems that cannot be read or written are refused") {
  const TestFolder folder;
  const ProblemStatement problem = problem_of("octahedron");
  CHECK_THAT(refusal(problem, folder / "none.json"), Catch::Contains("there is no such file"));
  write_file(folder / "half.json", "{\"format\": ");
  CHECK_THAT(refusal(problem, folder / "half.json"), Catch::Contains("half.json"));
  CHECK_THROWS_AS(solved(problem, {{"save_start", (folder / "none" / "start.json").string()}}), OutputError);
  CHECK_THROWS_AS(solved(problem, {{"start", "a"}, {"save_start", "b"}}), OptionError);
  CHECK_THROWS_AS(solved(problem, {{"start", ""}}), OptionError);
}
