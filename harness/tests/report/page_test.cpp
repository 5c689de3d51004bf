#include "harness/report/page.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "harness/drawings/html_text.hpp"
#include "harness/report/html_table.hpp"
#include "harness/report/page_data.hpp"
#include "harness/report/page_scene.hpp"
#include "harness/report/verdicts.hpp"
#include "harness/tables/table_writer.hpp"
#include "harness/tests/occurrences.hpp"
#include "harness/tests/runs/stored_scenes.hpp"
#include "harness/tests/runs/toy_run.hpp"

using namespace gcs;

namespace {

PageRun toy_page_run() {
  RunFile record = toy::run_record();
  TableSet tables = build_tables(record, load_publications());
  PageRun run{"toy & co", std::move(record), std::move(tables), {}};
  run.scenes.emplace("octahedron", stored_scene(load_instance("octahedron")));
  return run;
}

nlohmann::json data_of(const std::string& page) {
  const std::string_view start = "id=\"page-data\">";
  const std::size_t first = page.find(start) + start.size();
  return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
}

const Verdict& verdict_on(const std::vector<Verdict>& all, const std::string& quantity) {
  return *std::find_if(all.begin(), all.end(), [&](const Verdict& one) { return one.quantity == quantity; });
}

}  // namespace

TEST_CASE("texts stay texts in HTML and in scripts") {
  CHECK(html_escaped("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
  const std::string hostile = nlohmann::json("</script><!-- <b>").dump();
  const std::string escaped = script_escaped(hostile);
  CHECK(escaped.find('<') == std::string::npos);
  CHECK(nlohmann::json::parse(escaped) == "</script><!-- <b>");
  CHECK(html_anchor("flat@1e-8 <") == "flat-1e-8--");
}

TEST_CASE("a table in HTML has its entries, and a footnote for every link") {
  const TableSet set = build_tables(toy::run_record(), load_publications());
  for (const Table& table : set.tables) {
    CAPTURE(table.name);
    const std::string html = to_html(table, "run7-");
    std::size_t entries = 0, links = 0;
    for (const TableRow& row : table.rows) {
      entries += row.cells.size();
      links += row.notes.size();
      for (const TableCell& cell : row.cells) links += cell.notes.size();
    }
    CHECK(occurrences(html, "<td>") == entries);
    CHECK(occurrences(html, "href=\"#run7-") == links);
    for (std::size_t i = 1; i <= table.footnotes.size(); ++i)
      CHECK(occurrences(html, "id=\"run7-" + table.name + "-note-" + std::to_string(i) + "\"") == 1);
  }
}

TEST_CASE("headers of tables have a title for every column") {
  Table table;
  table.name = "t";
  table.groups = {{"a", {"1", "2"}}, {"", {"3"}}};
  table.rows = {{"row", {{"x", {}}, {"y", {}}, {"z", {}}}, {}}};
  const std::string both = to_html(table);
  CHECK(occurrences(both, "scope=\"colgroup\"") == 2);
  CHECK(occurrences(both, "scope=\"col\"") == 4);
  table.groups = {{"a", {""}}, {"b", {""}}, {"c", {""}}};
  const std::string one_row = to_html(table);
  CHECK(occurrences(one_row, "scope=\"colgroup\"") == 0);
  CHECK(one_row.find("<th scope=\"col\">b</th>") != std::string::npos);
}

TEST_CASE("a page shows every instance of every run once, and needs nothing else") {
  std::vector<PageRun> runs;
  runs.push_back(toy_page_run());
  runs.push_back(toy_page_run());
  const std::string page = page_html(runs, load_publications());
  for (const InstanceSummary& instance : runs[0].record.instances)
    CHECK(occurrences(page, "id=\"scene-" + instance.id + "\"") == 1);
  CHECK(page.find("Nothing is stored of this instance") != std::string::npos);
  CHECK(page.find("toy &amp; co") != std::string::npos);
  CHECK(occurrences(page, "<h1>") == 1);
  for (const std::string_view fetched : {"src=", "<link", "@import", "url("})
    CHECK(page.find(fetched) == std::string::npos);

  const nlohmann::json data = data_of(page);
  REQUIRE(data["scenes"].size() == 1);
  const nlohmann::json& scene = data["scenes"][0];
  const StoredScene& stored = runs[0].scenes.at("octahedron");
  CHECK(scene["edges"].size() == stored.record.instance.problem.constraints.size());
  CHECK(scene["solutions"].size() == stored.record.solutions.size());
  CHECK(scene["path"]["rows"].size() == stored.path->corners.size());
  CHECK(scene["path"]["stops"].size() == 4);
  for (const auto& row : scene["path"]["rows"]) REQUIRE(row.size() == 2 + scene["path"]["moving"].size());
}

TEST_CASE("scripts get planes, bodies and how these are turned") {
  const auto data_of_scene = [](const std::string& id) {
    const StoredScene scene = stored_scene(load_instance(id));
    return nlohmann::json::parse(page_data({&scene}))["scenes"][0];
  };
  const nlohmann::json planes = data_of_scene("octahedral-3p3h");
  CHECK(planes["planes"].size() == 3);
  CHECK(planes["edges"].size() == 9);
  CHECK(planes["solutions"][0]["planes"].size() == 3);

  const nlohmann::json platform = data_of_scene("planar-platform");
  REQUIRE(platform["bodies"].size() == 2);
  CHECK(platform["bodies"][1]["elements"] == std::vector<int>{3, 4, 5});
  // The base stands as the file has it; the platform is turned as its points are, b2 from b1 at (−0.975807, 1.429743).
  for (const auto& solution : platform["solutions"]) {
    CHECK(solution["turns"][0][0][0].get<double>() == Approx(1));
    const auto& turn = solution["turns"][1];
    const auto& points = solution["points"];
    for (int axis = 0; axis < 2; ++axis)
      CHECK(turn[axis][0].get<double>() * -0.975807 + turn[axis][1].get<double>() * 1.429743 ==
            Approx(points[4][axis].get<double>() - points[3][axis].get<double>()).margin(1e-9));
  }
}

TEST_CASE("figures of a scene are its graph, its interpretation tree and its path") {
  const auto drawings = draw_scene(stored_scene(load_instance("octahedron")));
  REQUIRE(drawings.size() == 3);
  CHECK(drawings[0].name == "graph-octahedron");
  CHECK(drawings[1].name == "tree-octahedron");
  CHECK(drawings[2].name == "path-octahedron");
  CHECK(draw_scene(stored_scene(load_instance("tangents-durand"))).size() == 1);
}

TEST_CASE("a printed number is refuted, proven or open as ours is") {
  RunFile run = toy::run_record();
  Publications papers = load_publications();
  for (auto& [name, paper] : papers)
    for (PrintedFigure& figure : paper.figures) figure.chosen.clear();
  const InstanceSummary& octahedron = run.instances[0];
  auto all = verdicts(run, octahedron, nullptr, papers);
  CHECK(verdict_on(all, "complex").printed_standing == VerdictStanding::refuted);
  CHECK(verdict_on(all, "complex").our_standing == VerdictStanding::open);
  CHECK(verdict_on(all, "real").printed_standing == VerdictStanding::open);
  CHECK(verdict_on(all, "on S").our_standing == VerdictStanding::open);

  for (CellRecord& cell : run.cells)
    if (cell.spec.strategy == "cayley-menger") cell.proofs = RecordedProofs{8, 4, true, true};
  all = verdicts(run, octahedron, nullptr, papers);
  CHECK(verdict_on(all, "complex").our_standing == VerdictStanding::proven);
  CHECK(verdict_on(all, "real").printed_standing == VerdictStanding::proven);
  for (CellRecord& cell : run.cells) {
    if (!cell.proofs) continue;
    cell.proofs->real = 3;
    cell.counts.real_up_to_reflection = Natural(3);
  }
  CHECK(verdict_on(verdicts(run, octahedron, nullptr, papers), "real").printed_standing ==
        VerdictStanding::refuted);

  const StoredScene scene = stored_scene(load_instance("octahedron"));
  CHECK(verdict_on(verdicts(run, octahedron, &scene, papers), "on S").printed_standing ==
        VerdictStanding::proven);
}

TEST_CASE("a cell whose path is proven to close proves what is on S, where no scene is stored") {
  RunFile run = toy::run_record();
  const auto on_path = [&] {
    return verdict_on(verdicts(run, run.instances[0], nullptr, load_publications()), "on S");
  };
  CHECK(on_path().our_standing == VerdictStanding::open);
  run.cells[1].is_path_proven = true;
  CHECK(on_path().our_standing == VerdictStanding::proven);
  CHECK(on_path().reason.find("(full-space mode=paper)") != std::string::npos);
  run.cells[1].difference = "It is wrong.";
  CHECK(on_path().our_standing == VerdictStanding::open);
}

TEST_CASE("a number in the convention of its scene is held against ours as it is") {
  RunFile run = toy::run_record();
  InstanceSummary& platform = run.instances[0];
  platform.id = "platform";
  run.cells = {toy::with_all(toy::cell({"platform", "monodromy", {}}, 0, 0, 1), 2, 40)};
  run.cells[0].proofs = RecordedProofs{40, 2, true, true};
  const auto printed = [&] {
    return verdict_on(verdicts(run, platform, nullptr, load_publications()), "complex").printed_standing;
  };
  CHECK(printed() == VerdictStanding::open);
  platform.convention = "up to motion";
  CHECK(printed() == VerdictStanding::proven);
}

// 132 of 160 realisations, with a triangle held: two of each class up to reflection.
TEST_CASE("the most that is known of a graph is proven by lengths with as many, and refuted by none") {
  RunFile run = toy::run_record();
  run.instances[0].id = "record@g160";
  const auto real = [&](std::uint64_t classes) {
    run.cells = {toy::with_all(toy::cell({"record@g160", "monodromy", {}}, 0, 0, 1), classes, 80)};
    run.cells[0].proofs = RecordedProofs{80, classes, true, true};
    return verdict_on(verdicts(run, run.instances[0], nullptr, load_publications()), "real");
  };
  CHECK(real(66).printed == "at least 132 (fixed frame)");
  CHECK(real(66).printed_standing == VerdictStanding::proven);
  CHECK(real(68).printed_standing == VerdictStanding::proven);
  CHECK(real(65).printed_standing == VerdictStanding::open);
}

TEST_CASE("distinct lines are held against ours one by one") {
  RunFile run = toy::run_record();
  run.instances[0].id = "tangents-fourfold";
  run.cells = {toy::with_all(toy::cell({"tangents-fourfold", "sphere-tangents", {}}, 0, 0, 1), 3, 3)};
  run.cells[0].proofs = RecordedProofs{3, 3, true, true};
  const Verdict real = verdict_on(verdicts(run, run.instances[0], nullptr, load_publications()), "real");
  CHECK(real.printed == "3 (lines, distinct)");
  CHECK(real.printed_standing == VerdictStanding::proven);
}

TEST_CASE("what an instance was chosen for proves nothing of the paper's") {
  RunFile run = toy::run_record();
  for (CellRecord& cell : run.cells)
    if (cell.spec.strategy == "cayley-menger") cell.proofs = RecordedProofs{8, 4, true, true};
  const Verdict real = verdict_on(verdicts(run, run.instances[0], nullptr, load_publications()), "real");
  CHECK(real.our_standing == VerdictStanding::proven);
  CHECK(real.printed_standing == VerdictStanding::open);
  CHECK(real.reason.find("chosen") != std::string::npos);
}

TEST_CASE("a number that does not come out is open, and not refuted") {
  RunFile run = toy::run_record();
  InstanceSummary icosahedron = run.instances[0];
  icosahedron.id = "icosahedron";
  const Verdict on_path = verdict_on(verdicts(run, icosahedron, nullptr, load_publications()), "on S");
  CHECK(on_path.printed_standing == VerdictStanding::open);
  CHECK(on_path.reason.find("none with the graph of the icosahedron") != std::string::npos);
}

TEST_CASE("a scan of ours proves that no real solution is missing, and a program's claim does not") {
  RunFile run = toy::run_record();
  CellRecord& cell = run.cells.front();
  cell.status = RunStatus::complete;
  cell.difference.clear();
  cell.claim = Claim::all_real;
  cell.counts.real_up_to_reflection = Natural(4);
  cell.proofs = RecordedProofs{4, 4, false, false};
  cell.spec.strategy = "plan-scan";
  const auto standing = [&] {
    return verdict_on(verdicts(run, run.instances[0], nullptr, {}), "real").our_standing;
  };
  CHECK(standing() == VerdictStanding::proven);
  cell.spec.strategy = "exec:scan";
  CHECK(standing() == VerdictStanding::open);
}

TEST_CASE("solutions in clusters are all with multiplicities, and their number is not proven") {
  RunFile run = toy::run_record();
  for (CellRecord& cell : run.cells)
    if (cell.spec.strategy == "cayley-menger") cell.proofs = RecordedProofs{0, 0, true, false};
  const Verdict complex =
      verdict_on(verdicts(run, run.instances[0], nullptr, load_publications()), "complex");
  CHECK(complex.ours == "8");
  CHECK(complex.our_standing == VerdictStanding::open);
  CHECK(complex.reason.find("clusters") != std::string::npos);
}

TEST_CASE("papers say nothing of another instance by the same name") {
  RunFile run = toy::run_record();
  run.instances[0].is_shipped = false;
  for (const Verdict& one : verdicts(run, run.instances[0], nullptr, load_publications())) {
    CHECK(one.printed.empty());
    CHECK_FALSE(one.printed_standing);
  }
  const TableSet tables = build_tables(run, load_publications());
  CHECK(to_markdown(tables.tables.front()).find("72") == std::string::npos);
  CHECK(std::ranges::any_of(tables.lines,
                            [](const std::string& line) { return line.starts_with("octahedron:"); }));
}
