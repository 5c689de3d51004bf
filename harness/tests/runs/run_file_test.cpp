#include "harness/runs/run_file.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/tests/runs/toy_run.hpp"
#include "solvers/reading/json_document.hpp"

using namespace gcs;

TEST_CASE("a record reads back as what was written") {
  const RunFile record = toy::run_record();
  const std::string text = to_json_text(record);
  const RunFile again = parse_run_file(text, "run.json");
  CHECK(to_json_text(again) == text);

  REQUIRE(again.cells.size() == record.cells.size());
  const CellRecord& cell = again.cells.front();
  CHECK(cell.spec == record.cells.front().spec);
  CHECK(cell.status == RunStatus::complete);
  CHECK(cell.counts.on_path == 4u);
  CHECK_FALSE(cell.counts.generic.has_value());
  CHECK(cell.work.iterations == record.cells.front().work.iterations);
  REQUIRE(cell.repetitions.size() == record.cells.front().repetitions.size());
  CHECK(cell.repetitions[1].wall_s == record.cells.front().repetitions[1].wall_s);
  CHECK(again.environment.commit == record.environment.commit);
  CHECK(again.instances.front().equations == 12);
  REQUIRE(again.instances.front().lengths.size() == 1);
  CHECK(again.instances.front().lengths.front().text == "1.10");
  REQUIRE(again.instances.front().limit);
  CHECK_FALSE(again.instances.front().limit->is_exact);
  CHECK(again.instances.front().limit->all_signs == "64");
  CHECK(again.instances.front().limit->bound.reference.size() == 3);
  CHECK_FALSE(again.instances.back().limit);
}

TEST_CASE("infinite numbers read back, and bytes that are no text do no harm") {
  RunFile record = toy::run_record();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  record.cells[0].residual = infinite;
  record.cells[0].accuracy = Accuracy{1, 0, 0, 1e-16, 1e-16, infinite, 1};
  record.sessions[0].folder = "/r\xe9sultats";
  const RunFile again = parse_run_file(to_json_text(record), "run.json");
  CHECK(again.cells[0].residual == infinite);
  CHECK(again.cells[0].accuracy->largest_condition == infinite);
  CHECK(again.cells[0].accuracy->largest_error == 1e-16);
  CHECK(again.sessions[0].folder == "/r\uFFFDsultats");
}

TEST_CASE("particulars, solutions, curves and whether positions are given read back") {
  RunFile record = toy::run_record();
  record.instances.back().has_given_positions = true;
  record.cells.front().particulars = {{"coarse_solutions", 224}, {"a_first_by_order_not_by_name", 1}};
  record.cells.front().solutions = {{true, 4, {{"p1", {0.1, -2, 3}}}}, {false, 1, {}}};
  record.curves = {{"hoffmann-yuan", 9.15, {0, 1}, {0.1 / 3, 9}}};
  const RunFile again = parse_run_file(to_json_text(record), "run.json");
  const CellRecord& cell = again.cells.front();
  CHECK(cell.particulars == record.cells.front().particulars);
  CHECK(cell.particular("coarse_solutions") == 224);
  CHECK_FALSE(cell.particular("refined_solutions"));
  REQUIRE(cell.solutions.size() == 2);
  CHECK(cell.solutions[0].multiplicity == 4);
  CHECK(cell.solutions[0].points.at("p1") == std::array<double, 3>{0.1, -2, 3});
  CHECK_FALSE(cell.solutions[1].is_real);
  CHECK(again.instances.back().has_given_positions);
  CHECK_FALSE(again.instances.front().has_given_positions);
  REQUIRE(again.curves.size() == 1);
  CHECK(again.curves[0].given == 9.15);
  CHECK(again.curves[0].gap == record.curves[0].gap);
  REQUIRE(again.tables.size() == record.tables.size());
  CHECK(again.tables[0].instances == record.tables[0].instances);
}

TEST_CASE("the points of a bound read back, and a run from before has none") {
  const std::vector<std::vector<std::string>> points{{"p1", "p2", "p3"}, {"p2", "p3", "p4", "p5"}};
  for (const auto& [name, member] :
       {std::pair("ring", &BoundNames::ring), {"at_infinity", &BoundNames::at_infinity}}) {
    RunFile record = toy::run_record();
    record.instances.front().limit->bound.*member = points;
    nlohmann::json json = nlohmann::json::parse(to_json_text(record));
    CHECK(parse_run_file(json.dump(), "run.json").instances.front().limit->bound.*member == points);
    json["instances"][0]["complex_limit"].erase(name);
    CHECK((parse_run_file(json.dump(), "run.json").instances.front().limit->bound.*member).empty());
  }
}

TEST_CASE("whether S is proven reads back, and a run from before says of none that it is") {
  RunFile record = toy::run_record();
  record.cells.front().is_path_proven = true;
  nlohmann::json json = nlohmann::json::parse(to_json_text(record));
  const RunFile again = parse_run_file(json.dump(), "run.json");
  CHECK(again.cells[0].is_path_proven);
  CHECK_FALSE(again.cells[1].is_path_proven);
  json["cells"][0].erase("path_proven");
  CHECK_FALSE(parse_run_file(json.dump(), "run.json").cells[0].is_path_proven);
}

TEST_CASE("sessions and plans read back, and a run from before them has none") {
  RunFile record = toy::run_record();
  record.cells.front().planned = 7;
  record.cells.front().warm_up_s = 0.1;
  record.cells.front().limit_s = 0.3;
  const RunFile again = parse_run_file(to_json_text(record), "run.json");
  REQUIRE(again.sessions.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const RunSession &now = again.sessions[i], &then = record.sessions[i];
    CHECK(now.started == then.started);
    CHECK(now.arguments == then.arguments);
    CHECK(now.folder == then.folder);
    CHECK(now.load_average == then.load_average);
    CHECK(now.repetitions == then.repetitions);
    CHECK(now.budget_s == then.budget_s);
    CHECK(now.cell_limit_s == then.cell_limit_s);
    CHECK(now.total_limit_s == then.total_limit_s);
  }
  CHECK(again.cells.front().planned == 7);
  CHECK(again.cells.front().warm_up_s == 0.1);
  CHECK(again.cells.front().limit_s == 0.3);

  nlohmann::json json = nlohmann::json::parse(to_json_text(record));
  json.erase("sessions");
  for (nlohmann::json& cell : json["cells"])
    for (const char* name : {"planned", "warm_up_s", "limit_s"}) cell.erase(name);
  const RunFile old = parse_run_file(json.dump(), "run.json");
  CHECK(old.sessions.empty());
  CHECK(old.cells.front().planned == 0);
  CHECK_FALSE(old.cells.front().limit_s);
}

TEST_CASE("a cell is found by instance, strategy and options") {
  const RunFile record = toy::run_record();
  CHECK(record.find({"octahedron", "rcp", {}}) != nullptr);
  CHECK(record.find({"octahedron", "rcp", {{"mode", "paper"}}}) != nullptr);
  CHECK(record.find({"octahedron", "rcp", {{"mode", "other"}}}) == nullptr);
  CHECK(record.find({"k33", "rcp", {}}) == nullptr);
}

TEST_CASE("what is no run is refused with the file's name") {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_run_file(text, "FILE");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(message("{"), Catch::StartsWith("FILE: "));
  CHECK_THAT(message("[]"), Catch::Contains("gcsbench-run/1"));
  CHECK_THAT(message(R"({"format": "gcsbench-run/2"})"), Catch::Contains("gcsbench-run/2"));
  CHECK_THAT(message(R"({"format": "gcsbench-run/1"})"), Catch::Contains("started"));
  std::string text = to_json_text(toy::run_record());
  text.replace(text.find("\"complete\""), 10, "\"finished\"");
  CHECK_THAT(message(text), Catch::Contains("finished"));
  CHECK_THROWS_AS(load_run_file(std::filesystem::path("no") / "such" / "run.json"), InputError);
}
