#include "harness/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gcs {

std::span<const TableKind> table_kinds() {
  static const std::array kinds{
      TableKind{"table1", "numbers of solutions and running times (Imbach et al., Table 1)", table1_variants,
                build_table1, ""},
      TableKind{"table2", "details of tracking S (Imbach et al., Table 2), and ratios of times",
                table2_variants, build_table2, ""},
      TableKind{"hoffmann-yuan", "five points and a line (Hoffmann, Yuan, Tables 1 and 2)", nullptr, nullptr,
                "this version has no strategy for points and a line"},
      TableKind{"tangents", "lines at given distances from four points", nullptr, nullptr,
                "this version has no strategy for points and a line"},
      TableKind{"ablation", "one option of a strategy changed at a time", ablation_variants, build_ablation,
                ""},
  };
  return kinds;
}

const TableKind* find_table(std::string_view name) {
  const auto kinds = table_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const TableKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

const std::vector<std::string>& paper_instances() {
  static const std::vector<std::string> ids{"octahedron", "disulfide", "dodecagon", "icosahedron"};
  return ids;
}

TableSet build_tables(const RunRecord& run, const Publication& paper) {
  TableSet set;
  for (const std::string& name : run.tables) {
    const TableKind* kind = find_table(name);
    if (kind == nullptr) {
      set.lines.push_back(fmt::format("{}: this version knows no such table", name));
    } else if (!kind->unavailable.empty()) {
      set.lines.push_back(fmt::format("{}: not measured, {}", name, kind->unavailable));
    } else {
      for (Table& table : kind->build(run, paper)) set.tables.push_back(std::move(table));
    }
  }
  set.measurements = build_measurements(run);
  return set;
}

}  // namespace gcs
