/// What each way to write 6p, 4p1L and 5p1L as equations costs, as Hoffmann and Yuan compare them: systematic, algebraic,
/// geometric, computational. What they state stands beside what is measured of the systems themselves.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// A system, and who solves it.
struct WrittenWay {
  const char* problem;  ///< as the paper calls it
  const char* label;
  const char* stated;  ///< `by` of the degree that the paper states; empty: none
  Variant variant;
  /// What is counted of the system comes from this one, where it is not `variant`.
  std::optional<Variant> counted_by = {};
  const char* degree = "total_degree";  ///< the particular that is the degree
  bool only_degree = false;             ///< others are of a system before it
};

constexpr std::array problems{std::pair{"6p", "octahedron"}, std::pair{"4p1L", "tangents-durand"},
                              std::pair{"5p1L", "hoffmann-yuan"}};

WrittenWay by_paths(const char* problem, const char* id, const char* label, const char* stated,
                    OptionMap options) {
  return {problem, label, stated, {"system-paths", std::move(options), {id}}};
}

/// One polynomial whose real roots are counted by theorem.
Variant exact_octahedron() { return {"cayley-menger", {{"method", "univariate"}}, {"octahedron"}}; }

std::vector<WrittenWay> octahedron_ways() {
  const char* id = "octahedron";
  const Variant exact = exact_octahedron();
  return {
      by_paths("6p", id, "systematic: nine quadrics", "", {{"system", "quadrics"}}),
      by_paths("6p", id, "systematic: after Gaussian elimination", "", {{"system", "echelon"}}),
      by_paths("6p", id, "systematic: three quartics, from x^d = 1", "quartics", {{"start", "total-degree"}}),
      by_paths("6p", id, "systematic: three quartics, from mixed cells", "quartics", {}),
      {"6p", "algebraic: two determinants, eigenvalues", "diagonals", {"cayley-menger", {}, {id}}, exact},
      {"6p", "geometric: one polynomial, exact", "univariate", exact, {}, "eliminated_degree", true},
      {"6p", "computational: scan of a plan", "", {"plan-scan", {}, {id}}}};
}

std::vector<WrittenWay> tangent_ways() {
  const auto published = [](const char* system) {
    return Variant{"sphere-tangents", {{"method", "published"}, {"system", system}}, {"tangents-durand"}};
  };
  return {{"4p1L", "algebraic: six quadrics, (1) to (6)", "quadrics", published("quadrics")},
          {"4p1L", "algebraic: the point eliminated", "cubic", published("cubic")},
          {"4p1L", "ours: eigenvalues", "", {"sphere-tangents", {}, {"tangents-durand"}}}};
}

std::vector<WrittenWay> pyramid_ways() {
  const char* id = "hoffmann-yuan";
  return {
      by_paths("5p1L", id, "algebraic: twelve quadrics, (7)", "quadrics", {{"system", "quadrics"}}),
      by_paths("5p1L", id, "algebraic: (7) after Gaussian elimination", "echelon", {{"system", "echelon"}}),
      by_paths("5p1L", id, "geometric: p1 by a parameter, (8) and (9)", "", {{"system", "parametrised"}}),
      {"5p1L",
       "computational: scan over θ, published",
       "",
       {"theta-scan", {{"method", "published"}, {"dtheta", "1"}, {"delta", "0.2"}}, {id}}},
      {"5p1L", "computational: scan over θ, events", "", {"theta-scan", {}, {id}}}};
}

std::vector<WrittenWay> all_ways() {
  std::vector<WrittenWay> all = octahedron_ways();
  for (const auto& more : {tangent_ways(), pyramid_ways()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// A number that the cell has, whatever became of its answer: that is in a footnote.
TableCell counted_entry(Table& table, const CellRecord* cell, std::optional<double> value) {
  if (cell == nullptr || cell->status == RunStatus::complete) return answer_entry(table, cell, value);
  TableCell entry = value ? TableCell{number_text(*value), {}} : empty_entry();
  if (value) entry.notes = answer_entry(table, cell, value).notes;
  return entry;
}

TableCell fact_entry(Table& table, const CellRecord* cell, std::string_view name) {
  return counted_entry(table, cell, particular(cell, name));
}

void add_system(Table& table, const RunFile& run, const WrittenWay& way, const std::string& id,
                TableRow& row) {
  const CellRecord* cell = run.find((way.counted_by ? *way.counted_by : way.variant).on(id));
  for (const char* name : {"unknowns", "terms"})
    row.cells.push_back(way.only_degree ? empty_entry() : fact_entry(table, cell, name));
  row.cells.push_back(fact_entry(table, cell, way.degree));
  for (const char* name : {"homogeneous_bound", "mixed_volume"})
    row.cells.push_back(way.only_degree ? empty_entry() : fact_entry(table, cell, name));
}

void add_paths(Table& table, const CellRecord* cell, TableRow& row) {
  const auto all = tracked_paths(cell);
  const auto of_paths = [&](std::optional<double> count) {
    return all ? counted_entry(table, cell, count.value_or(0)) : empty_entry();
  };
  row.cells.push_back(all ? of_paths(all) : empty_entry());
  row.cells.push_back(of_paths(finite_path_ends(cell)));
  row.cells.push_back(of_paths(particular(cell, "extraneous_ends")));
  row.cells.push_back(of_paths(all ? static_cast<double>(cell->counts.at_infinity.value_or(0)) : 0));
}

/// Where the answer is not right there is no median, but what the one solve took.
TableCell any_time_entry(Table& table, const CellRecord* cell) {
  if (cell == nullptr || cell->is_right() || cell->status != RunStatus::partial)
    return time_entry(table, cell);
  return {duration_text(cell->warm_up_s) + " (1 run)", time_entry(table, cell).notes};
}

TableRow way_row(Table& table, const RunFile& run, const Publication& paper, const WrittenWay& way,
                 const std::string& id) {
  const CellRecord* cell = run.find(way.variant.on(id));
  TableRow row{way.label, {}, {}};
  row.cells.push_back(printed_entry(
      table,
      *way.stated == '\0' ? nullptr : paper.find("sections 4.1 and 4.2", "degree", way.problem, way.stated)));
  add_system(table, run, way, id, row);
  add_paths(table, cell, row);
  const bool any = cell != nullptr;
  row.cells.push_back(
      counted_entry(table, cell, any ? number(cell->counts.complex_up_to_reflection) : std::nullopt));
  row.cells.push_back(
      counted_entry(table, cell, any ? number(cell->counts.real_up_to_reflection) : std::nullopt));
  row.cells.push_back(any_time_entry(table, cell));
  return row;
}

}  // namespace

const std::vector<std::string>& three_ways_instances() {
  static const std::vector<std::string> ids{problems[0].second, problems[1].second, problems[2].second};
  return ids;
}

std::vector<Variant> three_ways_variants() {
  std::vector<Variant> variants;
  for (const WrittenWay& way : all_ways()) variants.push_back(way.variant);
  return variants;
}

std::vector<Table> build_three_ways(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "three-ways";
  table.caption = "Hoffmann, Yuan: three ways to solve, and what each way to write the problem costs";
  table.stub = "system";
  table.groups = {{"", {"stated"}},
                  {"the system", {"unknowns", "terms", "total degree", "m-homogeneous", "mixed volume"}},
                  {"paths", {"tracked", "finite", "extraneous", "infinite"}},
                  {"solutions", {"complex", "real"}},
                  {"", {"time"}}};
  for (const auto& [problem, id] : problems) {
    const bool is_shown =
        std::ranges::find(run.instances, std::string(id), &InstanceSummary::id) != run.instances.end();
    if (!is_shown) continue;
    table.rows.push_back({fmt::format("{}: {}", problem, id), {}, {}});
    for (const WrittenWay& way : all_ways())
      if (std::string_view(way.problem) == problem) table.rows.push_back(way_row(table, run, paper, way, id));
  }
  table.remarks = {
      "Stated: the number of solutions, paths or the degree that the paper gives for the system. All else is "
      "counted from the polynomials with the instance's numbers, and from the paths.",
      "m-homogeneous: the smallest multihomogeneous Bézout number that a search over groups of unknowns "
      "found. Mixed volume: of cells that are proven one by one in integers, and proven where it is that "
      "number, which none is above. Finite: "
      "ends of paths in C^n, extraneous ones included, which solve the equations but not the problem. "
      "Solutions: up to "
      "reflection, once each.",
      "Written out in solvers/systems/README.md, with what is misprinted.",
      fmt::format("Times: preparing, solving and counting what the system costs, on one thread, median of "
                  "interleaved "
                  "repetitions; {}. {}.",
                  spread_remark, run.environment.cpu),
      "Published: " + paper.citation + ", sections 4.1 and 4.2."};
  if (const auto real = particular(run.find(exact_octahedron().on("octahedron")), "proven_real_solutions"))
    table.remarks.insert(
        table.remarks.begin() + 2,
        fmt::format("6p: the exact polynomial has {} real roots, by Sturm's theorem: so many "
                    "real solutions there are in the fixed frame, mirror images apart.",
                    *real));
  return {table};
}

}  // namespace gcs
