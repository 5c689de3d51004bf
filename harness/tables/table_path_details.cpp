/// Table 2 of Imbach, Mathis, Schreck: details about tracking S without and with a construction plan.

#include <fmt/format.h>

#include <array>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

constexpr const char* printed_in = "table 2";

using Number = std::optional<double>;

Number median_s(const CellRecord& cell) {
  const auto time = total_time(&cell);
  return time ? Number(time->median) : std::nullopt;
}

Number ms_per_iteration(const CellRecord& cell) {
  const Number time = median_s(cell);
  if (!time || cell.work.iterations == 0) return std::nullopt;
  return *time * 1e3 / static_cast<double>(cell.work.iterations);
}

/// Durations, and what is computed from them, are withheld with a wrong answer.
enum class Kind { duration, per_duration, answer };

/// A line of the paper's table: what it is called there and here, and where a cell keeps it.
struct Quantity {
  const char* row;
  const char* label;
  Number (*of)(const CellRecord&);
  Kind kind;
  bool of_plans_only;  ///< the paper prints it for the tracking with plans only
};

constexpr std::array quantities{
    Quantity{"time_s", "time t", median_s, Kind::duration, false},
    Quantity{"smallest_step", "smallest δ", [](const CellRecord& c) { return c.work.smallest_step; },
             Kind::answer, false},
    Quantity{"iterations", "iterations i", [](const CellRecord& c) { return Number(c.work.iterations); },
             Kind::answer, false},
    Quantity{"ms_per_iteration", "t/i in ms", ms_per_iteration, Kind::per_duration, false},
    Quantity{"plan_changes", "plan changes", [](const CellRecord& c) { return Number(c.work.plan_changes); },
             Kind::answer, true},
    Quantity{"mean_driving_parameters", "mean driving parameters",
             [](const CellRecord& c) { return c.work.mean_driving_parameters; }, Kind::answer, true},
    Quantity{"max_driving_parameters", "max driving parameters",
             [](const CellRecord& c) {
               return c.work.max_driving_parameters ? Number(*c.work.max_driving_parameters) : std::nullopt;
             },
             Kind::answer, true},
};

/// A column of every instance and the paper's method in it.
struct Column {
  const char* title;
  const char* method;
  bool with_plan;
};
constexpr std::array columns{Column{"without", "tracking S", false}, Column{"with", "Algorithm 1", true}};

/// Rows under one heading: which variant stands in each of the columns; nullopt: none.
struct Block {
  std::string heading;
  std::array<std::optional<Variant>, 2> variants;
  bool beside_published = false;
};

std::vector<Block> blocks() {
  const OptionMap paper_mode{{"mode", "paper"}};
  return {{"mode=paper, beside the published figures",
           {Variant{"full-space", paper_mode}, Variant{"rcp", paper_mode}},
           true},
          {"mode=paper with as=printed, beside the published figures",
           {std::nullopt, Variant{"rcp", {{"as", "printed"}, {"mode", "paper"}}}},
           true},
          {"mode=fast", {Variant{"full-space", {}}, Variant{"rcp", {}}}, false},
          {"mode=paper with twice the stated largest steps (0.2 and 0.1), beside the published figures",
           {Variant{"full-space", {{"mode", "paper"}, {"step_max", "0.2"}}},
            Variant{"rcp", {{"mode", "paper"}, {"step_max", "0.1"}}}},
           true},
          {"mode=paper with step_max=0.05, as the paper has it with a plan",
           {Variant{"full-space", {{"mode", "paper"}, {"step_max", "0.05"}}}, std::nullopt},
           false}};
}

class Builder {
 public:
  Builder(const RunFile& run, const Publication& paper) : run_(run), paper_(paper) {
    table_.name = "table2";
    table_.caption = "Table 2: tracking S without and with a construction plan, published and ours";
    for (const InstanceSummary& instance : run.instances) {
      table_.groups.push_back({instance.id, {columns[0].title, columns[1].title}});
    }
  }

  void equations() {
    add_row("m (equations)", [](const InstanceSummary& instance, int) {
      return TableCell{number_text(instance.equations), {}};
    });
  }

  void add_block(const Block& block) {
    table_.rows.push_back({block.heading, {}, {}});
    for (const Quantity& quantity : quantities) {
      if (!applies(block, quantity)) continue;
      if (block.beside_published) add_published(block, quantity);
      add_ours(block, quantity);
      if (block.beside_published) add_ratio(block, quantity);
    }
  }

  Table take() {
    table_.remarks = {
        "without: full-space for the paper's tracking of S without a plan; with: rcp for its Algorithm 1. "
        "Ratio: "
        "ours / published.",
        defaults_remark,
        "δ: the length of a step along S in (X, t), X in the file's unit with mode=paper, otherwise in the "
        "scene's.",
        "Times: preparing and solving once on one thread, median of interleaved repetitions; " +
            std::string(spread_remark) + ". Published times: " + paper_.machine +
            "; ours: " + run_.environment.cpu + ".",
        "Published: " + paper_.citation + ".",
    };
    return std::move(table_);
  }

 private:
  static bool applies(const Block& block, const Quantity& quantity) {
    return !quantity.of_plans_only || block.variants[1].has_value();
  }

  const CellRecord* cell(const Block& block, const InstanceSummary& instance, int column) const {
    return block.variants[column] ? run_.find(block.variants[column]->on(instance.id)) : nullptr;
  }

  const PrintedFigure* printed(const Quantity& quantity, const InstanceSummary& instance, int column) const {
    return paper_.find(printed_in, quantity.row, instance.id, columns[column].method);
  }

  static bool is_shown(const Block& block, const Quantity& quantity, int column) {
    return block.variants[column] && (columns[column].with_plan || !quantity.of_plans_only);
  }

  void add_published(const Block& block, const Quantity& quantity) {
    add_row(std::string(quantity.label) + ": published", [&](const InstanceSummary& instance, int column) {
      return block.variants[column] ? printed_entry(table_, printed(quantity, instance, column))
                                    : empty_entry();
    });
  }

  void add_ours(const Block& block, const Quantity& quantity) {
    const std::string label = std::string(quantity.label) + (block.beside_published ? ": ours" : "");
    add_row(label, [&](const InstanceSummary& instance, int column) {
      return is_shown(block, quantity, column) ? entry(quantity, cell(block, instance, column))
                                               : empty_entry();
    });
  }

  TableCell entry(const Quantity& quantity, const CellRecord* cell) {
    const bool wants_time = quantity.kind != Kind::answer;
    if (quantity.kind == Kind::duration || (wants_time && !total_time(cell))) return time_entry(table_, cell);
    return answer_entry(table_, cell, cell == nullptr ? std::nullopt : quantity.of(*cell));
  }

  void add_ratio(const Block& block, const Quantity& quantity) {
    add_row(std::string(quantity.label) + ": ratio", [&](const InstanceSummary& instance, int column) {
      const CellRecord* found = cell(block, instance, column);
      if (found == nullptr || !is_shown(block, quantity, column)) return empty_entry();
      return ratio_entry(found->status == RunStatus::complete ? quantity.of(*found) : std::nullopt,
                         printed(quantity, instance, column));
    });
  }

  /// `make` makes the entry of an instance and a column (0: without a plan, 1: with).
  template <typename Make>
  void add_row(const std::string& label, Make make) {
    TableRow row{label, {}, {}};
    for (const InstanceSummary& instance : run_.instances) {
      for (int column = 0; column < 2; ++column) row.cells.push_back(make(instance, column));
    }
    table_.rows.push_back(std::move(row));
  }

  const RunFile& run_;
  const Publication& paper_;
  Table table_;
};

}  // namespace

std::vector<Variant> table2_variants() {
  std::vector<Variant> variants;
  for (const Block& block : blocks()) {
    for (const auto& variant : block.variants) {
      if (variant) variants.push_back(*variant);
    }
  }
  return variants;
}

std::vector<Table> build_table2(const RunFile& run, const Publication& paper) {
  Builder builder(run, paper);
  builder.equations();
  for (const Block& block : blocks()) builder.add_block(block);
  return {builder.take(), build_ratios(run, paper), build_costs(run)};
}

}  // namespace gcs
