#include "harness/results/result_io.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/cli/solve_summary.hpp"
#include "harness/tests/instances/toy_scene.hpp"
#include "solvers/running/errors.hpp"

using namespace gcs;
using Json = nlohmann::json;

namespace {

SolveRun toy_run() {
  const Scene scene(toy::instance().problem);
  SolveRun run;
  run.strategy = "toy";
  run.options = {{"step", "0.1"}};
  run.seed = 3;
  run.status = RunStatus::complete;
  run.claim = Claim::on_path;
  static_cast<Assessment&>(run) = assess(scene, toy::good_report(scene));
  run.work.iterations = 694;
  run.work.smallest_step = 0.01;
  run.timing = {0.25, 0.5, 0.125, 7};
  return run;
}

std::string text_of(const SolveRun& run) {
  return result_text(toy::instance(), run, {"a cpu", "a compiler", "-O2", "abc+dirty", 2, "AVX2"});
}

Json parsed(const SolveRun& run) { return Json::parse(text_of(run)); }

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a result has every field of its format") {
  const Json result = parsed(toy_run());
  CHECK(keys(result) == Names{"claim",  "counts",   "ends",   "environment", "escaping",  "failed_checks",
                              "format", "frame",    "graph",  "instance",    "motions",   "options",
                              "path",   "proofs",   "reason", "seed",        "solutions", "statistics",
                              "status", "strategy", "timing", "totals"});
  CHECK(result["format"] == "gcsbench-result/1");
  CHECK(result["strategy"] == "toy");
  CHECK(result["options"] == Json{{"step", "0.1"}});
  CHECK(result["seed"] == 3);
  CHECK(result["status"] == "complete");
  CHECK(result["reason"] == "");
  CHECK(result["claim"] == "on path");
  CHECK(result["timing"] == Json{{"wall_s", 0.25},
                                 {"cpu_s", 0.5},
                                 {"prepare_s", 0.125},
                                 {"recalled_steps", 7},
                                 {"certify_s", nullptr}});
  CHECK(result["environment"] == Json{{"cpu", "a cpu"},
                                      {"compiler", "a compiler"},
                                      {"flags", "-O2"},
                                      {"commit", "abc+dirty"},
                                      {"threads", 2},
                                      {"instructions", "AVX2"}});
}

TEST_CASE("a result as CBOR says what the JSON does, digit for digit") {
  SolveRun run = toy_run();
  run.escaping = {run.solutions[0].placement()};
  for (AssessedSolution& solution : run.solutions) solution.residual = 0.1 + 0.2;
  for (const Instance& instance : {toy::instance(), load_instance("icosahedron")}) {
    const SolveRun& shown = instance.id == "icosahedron" ? SolveRun() : run;
    std::string json, cbor;
    write_result(instance, shown, {}, [&](std::string_view piece) { json += piece; });
    write_result(
        instance, shown, {}, [&](std::string_view piece) { cbor += piece; }, form_of("a.cbor"));
    CHECK(cbor.size() < json.size());
    std::string converted;
    rewrite_result(
        cbor, "f", [&](std::string_view piece) { converted += piece; }, json_form);
    CHECK(converted == json);
  }
  CHECK(form_of("cbor").begin == "{");
}

TEST_CASE("a result is rewritten while it is read") {
  const std::string json = result_text(toy::instance(), toy_run(), {});
  const std::string cut_off = json.substr(0, json.find("\"path\""));
  std::string written;
  CHECK_THROWS_AS(rewrite_result(
                      cut_off, "f", [&](std::string_view piece) { written += piece; }, json_form),
                  InputError);
  CHECK(json.starts_with(written));
  CHECK(written.size() > json.find("\"solutions\""));
}

TEST_CASE("counts that are not determined are null") {
  const Json counts = parsed(toy_run())["counts"];
  CHECK(counts == Json{{"convention", "up to reflection"},
                       {"real", nullptr},
                       {"complex", nullptr},
                       {"real_up_to_reflection", nullptr},
                       {"complex_up_to_reflection", nullptr},
                       {"generic", nullptr},
                       {"on_path", 2},
                       {"paths", 1},
                       {"at_infinity", 0},
                       {"singular", 0},
                       {"failed_paths", 0},
                       {"certified", nullptr}});
}

TEST_CASE(
    "counts are in the convention of the scene, and those up to reflection null where mirror images are "
    "two") {
  const auto counts_of = [](const Instance& instance) {
    SolveRun run;
    run.counts.real_up_to_reflection = 2;
    run.counts.complex_up_to_reflection = 6;
    return Json::parse(result_text(instance, run, {}))["counts"];
  };
  Instance instance = toy::instance();
  Json counts = counts_of(instance);
  CHECK(counts["convention"] == "up to reflection");
  CHECK(counts["real"] == 2);
  CHECK(counts["complex_up_to_reflection"] == 6);
  instance.problem.relations.push_back({"o", "orientation", {{0}, {1}, {2}}, Relation::Form::none, {}, 1});
  counts = counts_of(instance);
  CHECK(counts["convention"] == "up to motion");
  CHECK(counts["real"] == 2);
  CHECK(counts["complex"] == 6);
  CHECK(counts["real_up_to_reflection"].is_null());
  CHECK(counts["complex_up_to_reflection"].is_null());
}

TEST_CASE("the frame says which element is put where") {
  CHECK(parsed(toy_run())["frame"] == Json{{"origin", "p1"}, {"axis", "p2"}});
  const Instance anchored = load_instance("tangents-durand");
  const Json frame = Json::parse(result_text(anchored, {}, {}))["frame"];
  CHECK(keys(frame) == Names{"fixed"});
  CHECK(frame["fixed"].size() == 4);
}

TEST_CASE("a count that a double cannot hold is a decimal string") {
  SolveRun run = toy_run();
  run.counts.paths = 9007199254740992u;
  run.counts.generic = 9007199254740993u;
  const Json counts = parsed(run)["counts"];
  CHECK(counts["paths"] == 9007199254740992u);
  CHECK(counts["generic"] == "9007199254740993");
}

TEST_CASE("solutions have plain numbers, as many as the dimension") {
  const Json solutions = parsed(toy_run())["solutions"];
  REQUIRE(solutions.size() == 2);
  CHECK(keys(solutions[0]) == Names{"certified", "condition", "error_bound", "lines", "multiplicity",
                                    "points", "real", "residual"});
  CHECK(solutions[0]["points"] == Json{{"p1", {0, 0}}, {"p2", {6, 0}}, {"p3", {3, 4}}, {"p4", {0, -8}}});
  CHECK(solutions[0]["lines"] == Json::object());
  CHECK(solutions[0]["real"] == true);
  CHECK(solutions[0]["multiplicity"] == 1);
  CHECK(solutions[0]["error_bound"].is_null());
  CHECK(solutions[0]["certified"] == false);
}

TEST_CASE("the path names solutions, or null where they were left out") {
  SolveRun run = toy_run();
  CHECK(parsed(run)["path"][1] == Json{{"solution", 0}, {"direction", -1}});
  keep_first(run, 1);
  CHECK(parsed(run)["path"][0] == Json{{"solution", nullptr}, {"direction", 1}});
  run.claim = Claim::all_real;
  CHECK(parsed(run)["path"].is_null());
}

TEST_CASE("the graph names the constraint that each curve lacks, and solutions as the path does") {
  SolveRun run = toy_run();
  CHECK(parsed(run)["graph"].is_null());
  run.curves.push_back({0, PathRecord::End::closed, "", true, {{1, 1}, {0, -1}}});
  keep_first(run, 1);
  const std::string id = toy::instance().problem.constraints[0].id;
  CHECK(parsed(run)["graph"] ==
        Json::array({Json{{"constraint", id},
                          {"end", "closed"},
                          {"cause", ""},
                          {"proven", true},
                          {"crossings", Json::array({Json{{"solution", nullptr}, {"direction", 1}},
                                                     Json{{"solution", 0}, {"direction", -1}}})}}}));
}

TEST_CASE("figures along a curve are written where they were kept") {
  SolveRun run = toy_run();
  const Figure figure = run.solutions[0].placement();
  run.curves.push_back({0, PathRecord::End::closed, "", false, {{1, 1}}, {figure, figure}, {1}});
  const Json curve = parsed(run)["graph"][0];
  CHECK(curve["places"] == Json::array({1}));
  REQUIRE(curve["figures"].size() == 2);
  const ProblemStatement problem = toy::instance().problem;
  for (std::size_t i = 0; i < problem.points.size(); ++i)
    CHECK(curve["figures"][1][i] == parsed(run)["solutions"][0]["points"][problem.points[i]]);
}

TEST_CASE("a motion is written with the curve that was followed, if there is one") {
  SolveRun run = toy_run();
  const Figure figure = run.solutions[0].placement();
  run.motions.resize(2);
  run.motions[0].coincident = {{0, 1}};
  run.motions[0].figure = figure;
  Motion& apparent = run.motions[1];
  apparent.is_proven = false;
  apparent.figure = figure;
  apparent.curve = {{figure, figure, figure}, PathRecord::End::at_infinity, 0.5};
  const Json motions = parsed(run)["motions"];
  CHECK(motions[0]["proven"] == true);
  CHECK(motions[0]["curve"].is_null());
  CHECK(motions[1]["proven"] == false);
  CHECK(motions[1]["curve"]["end"] == "at infinity");
  CHECK(motions[1]["curve"]["residual"] == 0.5);
  CHECK(motions[1]["curve"]["figures"].size() == 3);
}

TEST_CASE("ends that are alike are counted together") {
  SolveRun run = toy_run();
  CHECK(parsed(run)["ends"] ==
        Json::parse(
            R"([{"end": "closed", "cause": "", "winding_number": null, "exponent": null, "proven": false,
                 "paths": 1}])"));
  using End = PathRecord::End;
  const PathRecord twofold{End::singular, "", 0, {}, 2, 0}, escaped{End::at_infinity, "", 0, {}, 2, 2},
      lost{End::failed, "its steps became too small", 0, {}, 0, 0};
  run.ends = ends_of({escaped, twofold, lost, escaped, escaped});
  CHECK(parsed(run)["ends"] == Json::parse(R"([
    {"end": "singular", "cause": "", "winding_number": 2, "exponent": null, "proven": false, "paths": 1},
    {"end": "at infinity", "cause": "", "winding_number": 2, "exponent": [1, 1], "proven": false,
     "paths": 3},
    {"end": "failed", "cause": "its steps became too small", "winding_number": null, "exponent": null,
     "proven": false, "paths": 1}])"));
}

TEST_CASE("what is proven of a path is told apart from what is only found") {
  SolveRun run = toy_run();
  CHECK_THAT(solve_summary(toy::instance(), run), !Catch::Contains("proven"));
  PathRecord found;
  found.end = PathRecord::End::closed;
  PathRecord proven = found;
  proven.proven = true;
  run.ends = ends_of({found, proven});
  CHECK(parsed(run)["ends"].size() == 2);
  CHECK(parsed(run)["ends"][1]["proven"] == true);
  CHECK_THAT(solve_summary(toy::instance(), run), Catch::Contains("1 path closes; the order and number"));
}

TEST_CASE("the summary says how fast paths escape") {
  SolveRun run = toy_run();
  using End = PathRecord::End;
  const auto escaped = [](int w, int k) { return PathRecord{End::at_infinity, "", 0, {}, w, k}; };
  run.ends = ends_of({escaped(1, 1), escaped(1, 2), escaped(2, 2), escaped(2, 1)});
  CHECK_THAT(solve_summary(toy::instance(), run),
             Catch::Contains("1 path like 1/(1-t)^(1/2), 2 like 1/(1-t), 1 like 1/(1-t)^2"));
}

TEST_CASE("statistics are counts, or null where a strategy has no such thing") {
  const Json statistics = parsed(toy_run())["statistics"];
  CHECK(keys(statistics) == Names{"evaluations", "factorisations", "iterations", "jacobians",
                                  "max_driving_parameters", "mean_driving_parameters", "newton_iterations",
                                  "partial_evaluations", "plan_changes", "rejected_steps", "smallest_step"});
  CHECK(statistics["iterations"] == 694);
  CHECK(statistics["smallest_step"] == 0.01);
  CHECK(statistics["plan_changes"] == 0);
  CHECK(statistics["max_driving_parameters"].is_null());
}

TEST_CASE("counts that only a strategy knows are among the statistics") {
  SolveRun run = toy_run();
  run.particulars = {{"coarse_solutions", 224}};
  CHECK(parsed(run)["statistics"]["coarse_solutions"] == 224);
}

TEST_CASE("the instance keeps its decimal text") {
  const std::string text = text_of(toy_run());
  CHECK_THAT(text, Catch::Contains("\"length\": 5.0"));
  CHECK(Json::parse(text)["instance"] == Json::parse(toy::instance_text()));
}

TEST_CASE("numbers read back as the same doubles and infinity is null") {
  SolveRun run = toy_run();
  run.solutions[0].residual = 0.1 + 0.2;
  run.solutions[0].figure.points(0, 2) = -0.0;
  run.solutions[1].condition = std::numeric_limits<double>::infinity();
  const std::string text = text_of(run);
  const Json solutions = Json::parse(text)["solutions"];
  CHECK(solutions[0]["residual"] == 0.1 + 0.2);
  CHECK(solutions[1]["condition"].is_null());
  CHECK_THAT(text, !Catch::Contains("-0,"));
}

TEST_CASE("a run that never started has no claim and no solutions") {
  SolveRun run;
  run.strategy = "toy";
  run.status = RunStatus::unsupported;
  run.reason = "it says \"no\"";
  const Json result = parsed(run);
  CHECK(result["claim"].is_null());
  CHECK(result["solutions"] == Json::array());
  CHECK(result["path"].is_null());
  CHECK(result["reason"] == "it says \"no\"");
  CHECK(result["counts"]["paths"].is_null());
}

TEST_CASE("failed checks are in the result") {
  SolveRun run = toy_run();
  run.failed_checks = {{"residual", "too large"}};
  CHECK(parsed(run)["failed_checks"] == Json::array({{{"name", "residual"}, {"what", "too large"}}}));
}

TEST_CASE("each solution has a line of its own") {
  const std::string text = text_of(toy_run());
  CHECK(text.back() == '\n');
  CHECK(std::count(text.begin(), text.end(), '\n') == 1 + 22 + 2 + 1 + 1);
}
