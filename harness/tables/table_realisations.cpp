/// Minimally rigid graphs: how many realisations recursions count, and how many are found and certified at random lengths,
/// and how many are real at chosen ones.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "harness/instances/families.hpp"
#include "harness/instances/families_graphs.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

const Variant solved_by{"monodromy", {}};

std::optional<Natural> exact_count(const GraphMember& graph) {
  return graph.is_on_sphere ? count_on_sphere(graph.edges, {}) : count_in_plane(graph.edges, {});
}

/// Two mirror images of each class have the same frame.
constexpr double mirror_images = 2;

std::optional<double> in_frame(const std::optional<double>& classes) {
  return classes ? std::optional(mirror_images * *classes) : std::nullopt;
}

std::optional<double> found_in_frame(const CellRecord* cell) {
  return cell == nullptr ? std::nullopt : in_frame(number(cell->counts.complex_up_to_reflection));
}

std::optional<double> certified_in_frame(const CellRecord* cell) {
  if (cell == nullptr || !cell->proofs) return std::nullopt;
  return in_frame(static_cast<double>(cell->proofs->classes));
}

std::string family_of(const std::string& id) { return id.substr(0, id.find('@')); }

bool has_most(const std::string& id) { return family_of(id).ends_with("most"); }

std::string place_of(const GraphMember& graph) {
  return graph.is_on_sphere ? "on the sphere" : "in the plane";
}

TableRow graph_row(Table& table, const RunFile& run, const Publication& published, const std::string& id) {
  const GraphMember graph = *graph_member(id);
  const CellRecord* cell = run.find(solved_by.on(id));
  const std::string place = graph.is_on_sphere ? "sphere" : "plane";
  TableRow row{fmt::format("{} points, {}", graph.points, place_of(graph)), {}, {}};
  const auto exact = exact_count(graph);
  row.cells = {printed_entry(table, published.find("realisations", place, id, "")),
               exact ? TableCell{number_text(exact->approximate()), {}} : empty_entry(),
               answer_entry(table, cell, found_in_frame(cell)),
               answer_entry(table, cell, certified_in_frame(cell))};
  return row;
}

Table most_table(const RunFile& run, const Publication& published) {
  Table table;
  table.name = "realisations";
  table.caption = "The minimally rigid graphs with most realisations in the plane";
  table.groups = {{"", {"published", "exact"}}, {"random lengths", {"found", "certified"}}};
  for (const InstanceSummary& instance : run.instances)
    if (has_most(instance.id)) table.rows.push_back(graph_row(table, run, published, instance.id));
  table.remarks = {
      "Complex realisations with one edge held fixed, mirror images counted apart. exact: at generic "
      "lengths, by the "
      "recursion over bigraphs of Capco et al. 2018, on the sphere by that over cross ratios of Gallet, "
      "Grasegger and "
      "Schicho 2020. found: by monodromy, with its defaults. certified: so many are proven to exist.",
      "A graph on the sphere is solved as a cone in space: all its points at the distance 1 from a further "
      "one."};
  return table;
}

/// What is said of all graphs of a family.
struct Agreement {
  int graphs = 0;
  int counted_right = 0;    ///< as many are found as counted
  int certified_right = 0;  ///< as many are certified as counted
  double least = 0, most = 0;
};

Agreement agreement_in(const RunFile& run, const std::string& family) {
  Agreement all;
  for (const InstanceSummary& instance : run.instances) {
    if (family_of(instance.id) != family) continue;
    const auto exact = exact_count(*graph_member(instance.id));
    if (!exact) continue;
    const double count = exact->approximate();
    const CellRecord* cell = run.find(solved_by.on(instance.id));
    all.least = all.graphs == 0 ? count : std::min(all.least, count);
    all.most = std::max(all.most, count);
    ++all.graphs;
    all.counted_right += found_in_frame(cell) == count && cell->is_right();
    all.certified_right += certified_in_frame(cell) == count;
  }
  return all;
}

Table all_table(const RunFile& run) {
  Table table;
  table.name = "realisations-all";
  table.caption = "All minimally rigid graphs of so many points: how often the recursion and solutions agree";
  table.groups = {{"", {"graphs", "least", "most"}}, {"as many as counted", {"found", "certified"}}};
  std::vector<std::string> shown;
  for (const InstanceSummary& instance : run.instances) {
    const std::string family = family_of(instance.id);
    const std::optional<GraphMember> graph = graph_member(instance.id);
    if (!graph || has_most(instance.id) || std::ranges::count(shown, family) > 0) continue;
    shown.push_back(family);
    const Agreement all = agreement_in(run, family);
    TableRow row{fmt::format("{} points, {}", graph->points, place_of(*graph)), {}, {}};
    for (const double number :
         {double(all.graphs), all.least, all.most, double(all.counted_right), double(all.certified_right)})
      row.cells.push_back({number_text(number), {}});
    table.rows.push_back(std::move(row));
  }
  table.remarks = {
      "least, most: exact counts. found, certified: the number of graphs at whose random lengths monodromy "
      "finds, or "
      "certificates prove, as many realisations as the recursion counts. That there are 13, 70 and 608 "
      "graphs of 6, 7 "
      "and 8 points is OEIS A227117."};
  return table;
}

}  // namespace

const std::vector<std::string>& realisations_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all;
    for (const char* name :
         {"laman-most", "sphere-most", "laman-6", "laman-7", "laman-8", "sphere-6", "sphere-7", "sphere-8"})
      for (std::string& id : find_family(name)->members()) all.push_back(std::move(id));
    return all;
  }();
  return ids;
}

const std::vector<std::string>& records_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all{
        "octahedron-cyclohexane", "g16a", "g16b", "g24", "g32a", "g32b", "g48", "g160"};
    for (std::string& id : find_family("record")->members()) all.push_back(std::move(id));
    return all;
  }();
  return ids;
}

std::vector<Variant> realisations_variants() { return {solved_by}; }

std::vector<Table> build_realisations(const RunFile& run, const Publication& published) {
  std::vector<Table> tables{most_table(run, published), all_table(run)};
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

std::vector<Table> build_records(const RunFile& run, const Publication& published) {
  Table table;
  table.name = "records";
  table.caption = "Minimally rigid graphs at lengths with many real realisations";
  table.groups = {{"published", {"all", "real"}}, {"found", {"all", "real"}}, {"certified", {"all", "real"}}};
  for (const InstanceSummary& instance : run.instances) {
    const std::string& id = instance.id;
    const CellRecord* cell = run.find(solved_by.on(id));
    const auto real = cell == nullptr ? std::nullopt : number(cell->counts.real_up_to_reflection);
    table.rows.push_back(
        {id,
         {printed_entry(table, published.find("records", "all", id, "")),
          printed_entry(table, published.find("records", "real", id, "")),
          answer_entry(table, cell, found_in_frame(cell)), answer_entry(table, cell, in_frame(real)),
          answer_entry(table, cell, certified_in_frame(cell)),
          answer_entry(table, cell, in_frame(proven_real(cell)))},
         {}});
  }
  table.remarks = {
      "Realisations with a triangle held fixed, in the plane an edge, mirror images counted apart. all: "
      "complex ones. "
      "published, real: the most that is known of the graph. found: by monodromy, with its defaults. "
      "certified: so many "
      "are proven to exist, and to be real. record@…: lengths that scripts/sweep-records climbed to, from "
      "random ones or "
      "those of the instance that is named."};
  return {table};
}

}  // namespace gcs
