/// Table 1 of Imbach, Mathis, Schreck: numbers of solutions and running times.

#include <fmt/format.h>

#include <algorithm>

#include "harness/results/exec_strategy.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

constexpr const char* place = "table 1";

/// One line of the paper's table: the row and method it is filed under.
struct PaperRow {
  std::string row;
  std::string by;
};

/// First with 2^m paths, as HOM4PS-2.0 is inferred to have followed.
std::vector<Variant> complex_variants() {
  return {{"polyhedral", {{"formulation", "coordinates"}}}, {"polyhedral", {}}, {"monodromy", {}}};
}

class Builder {
 public:
  Builder(const RunFile& run, const Publication& paper) : run_(run), paper_(paper) {
    table_.name = "table1";
    table_.caption = "Table 1: numbers of solutions and running times, published and ours";
    for (const InstanceSummary& instance : run.instances) {
      table_.groups.push_back({instance.id, {"published", "ours", "ratio"}});
    }
  }

  void heading(const std::string& label) { table_.rows.push_back({label, {}, {}}); }

  void equations() {
    add_row("m (equations)", {"equations", ""},
            [](const InstanceSummary& instance, const PrintedFigure* figure) {
              const double ours = instance.equations;
              return std::pair{TableCell{number_text(ours), {}}, ratio_entry(ours, figure)};
            });
  }

  /// How many solutions there are, by the first strategy that claims to have all of them. `copies` is how
  /// often the paper counts a class.
  template <class Copies>
  void all_solutions(const std::string& label, const PaperRow& paper_row,
                     std::optional<Natural> Counts::*count, const Copies& copies) {
    add_row(label, paper_row, [&](const InstanceSummary& instance, const PrintedFigure* figure) {
      const auto has_all = [&](const CellRecord& cell) {
        return cell.spec.instance == instance.id && cell.is_right() && cell.counts.*count;
      };
      const auto cell = std::find_if(run_.cells.begin(), run_.cells.end(), has_all);
      if (cell == run_.cells.end()) return unanswered(instance);
      const double classes = (cell->counts.*count)->approximate();
      const double value = classes * copies(instance);
      const std::string note = fmt::format(
          "By {}: {} {}, {}.", label_of(cell->spec), number_text(classes),
          instance.has_given_positions ? "with the positions that are given" : "up to reflection",
          standing(cell->proofs, *(cell->counts.*count), count == &Counts::real_up_to_reflection));
      return std::pair{TableCell{number_text(value), {table_.footnote(note)}}, ratio_entry(value, figure)};
    });
  }

  /// How many complex solutions there can be.
  void complex_limit(const std::string& label) {
    add_row(label, {label, ""}, [&](const InstanceSummary& instance, const PrintedFigure*) {
      if (!instance.limit) return std::pair{TableCell{"not known", {}}, empty_entry()};
      const int note = table_.footnote(limit_origin(*instance.limit));
      return std::pair{TableCell{instance.limit->all_signs, {note}}, empty_entry()};
    });
  }

  void solutions_on_path(const Variant& variant) {
    add_row("on S: " + label(variant), {"on path", ""},
            [&](const InstanceSummary& instance, const PrintedFigure* figure) {
              const CellRecord* cell = run_.find(variant.on(instance.id));
              const bool complete = cell != nullptr && cell->status == RunStatus::complete;
              return std::pair{answer_entry(table_, cell, on_path(cell)),
                               ratio_entry(complete ? on_path(cell) : std::nullopt, figure)};
            });
  }

  void times(const std::string& method, const Variant& variant) {
    add_row(method + ": " + label(variant), {"time_s", method},
            [&](const InstanceSummary& instance, const PrintedFigure* figure) {
              const CellRecord* cell = run_.find(variant.on(instance.id));
              const auto time = total_time(cell);
              const auto median = time ? std::optional(time->median) : std::nullopt;
              return std::pair{time_entry(table_, cell), ratio_entry(median, figure)};
            });
  }

  Table take() {
    table_.remarks = {
        "Ratio: ours / published.",
        defaults_remark,
        "complex: 'all signs', every solution counted 2^d times, once for each change of signs of the d "
        "axes. "
        "real: 'up to reflection'. on S: solutions on the path S through the sketch, 'up to reflection'.",
        "Beside the times of HOM4PS-2.0 stand those of our polyhedral homotopies, with 2^m paths in the "
        "coordinates, as many as HOM4PS-2.0 is inferred to have followed (it is not printed), and with few "
        "in another formulation, and of "
        "monodromy, for the same solutions.",
        "one solution at most: Newton's method from the sketch in all coordinates, the same in the driving "
        "parameters of the plan ([4] in the paper's list), and S up to its first solution ([11]).",
        "Times: preparing and solving once on one thread, median of interleaved repetitions; " +
            std::string(spread_remark) + ". Published times: " + paper_.machine +
            "; ours: " + run_.environment.cpu + ".",
    };
    for (const InstanceSummary& instance : run_.instances) {
      const auto remark = paper_.instance_remarks.find(instance.id);
      if (remark != paper_.instance_remarks.end()) table_.remarks.push_back(remark->second);
    }
    table_.remarks.push_back("Published: " + paper_.citation + ".");
    return std::move(table_);
  }

 private:
  /// Where no list is complete: what was not run for want of time.
  std::pair<TableCell, TableCell> unanswered(const InstanceSummary& instance) {
    const std::vector<Variant> variants = complex_variants();
    for (auto variant = variants.rbegin(); variant != variants.rend(); ++variant) {  // the fastest first
      const CellRecord* cell = run_.find(variant->on(instance.id));
      if (cell && cell->status == RunStatus::timed_out)
        return {answer_entry(table_, cell, std::nullopt), empty_entry()};
    }
    return {TableCell{"not measured", {}}, empty_entry()};
  }

  /// Whether a number of solutions is proven.
  static std::string standing(const std::optional<RecordedProofs>& proofs, const Natural& count,
                              bool of_real) {
    if (!proofs) return "found, not certified";
    const std::uint64_t certified = of_real ? proofs->real : proofs->classes;
    if (Natural(certified) != count) return fmt::format("found, {} of them certified", certified);
    return (of_real ? proofs->decides_real : proofs->is_complete)
               ? "proven: all certified, and no lengths have more complex ones"
               : "all certified; that there are no more is found, not proven";
  }

  static std::string label(const Variant& variant) { return label_of(variant.on("")); }

  /// `make_ours` makes our entry and the ratio.
  template <typename MakeOurs>
  void add_row(const std::string& label, const PaperRow& paper_row, MakeOurs make_ours) {
    TableRow row{label, {}, {}};
    for (const InstanceSummary& instance : run_.instances) {
      const PrintedFigure* figure = paper_.find(place, paper_row.row, instance.id, paper_row.by);
      TableCell published = printed_entry(table_, figure);
      auto [ours, ratio] = make_ours(instance, figure);
      for (TableCell* cell : {&published, &ours, &ratio}) row.cells.push_back(std::move(*cell));
    }
    table_.rows.push_back(std::move(row));
  }

  const RunFile& run_;
  const Publication& paper_;
  Table table_;
};

std::vector<Variant> path_variants() {
  return {{"full-space", {}},
          {"full-space", {{"mode", "paper"}}},
          {"rcp", {}},
          {"rcp", {{"mode", "paper"}}},
          {"rcp", {{"as", "printed"}, {"mode", "paper"}}}};
}

/// What finds one solution at most, from the sketch.
std::vector<Variant> baselines() {
  return {{"full-space", {{"mode", "newton"}}},
          {"rcp", {{"mode", "newton"}}},
          {"full-space", {{"until", "first"}}},
          {"rcp", {{"until", "first"}}}};
}

const Variant algebraic{"cayley-menger", {}};

/// Those that the run has measured, in its order.
std::vector<std::string> external_programs(const RunFile& run) {
  std::vector<std::string> programs;
  for (const CellRecord& cell : run.cells)
    if (exec_command(cell.spec.strategy) &&
        std::find(programs.begin(), programs.end(), cell.spec.strategy) == programs.end())
      programs.push_back(cell.spec.strategy);
  return programs;
}

}  // namespace

std::vector<Variant> table1_variants() {
  std::vector<Variant> variants = path_variants();
  for (const Variant& variant : baselines()) variants.push_back(variant);
  variants.push_back(algebraic);
  for (const Variant& variant : complex_variants()) variants.push_back(variant);
  return variants;
}

std::vector<Table> build_table1(const RunFile& run, const Publication& paper) {
  const std::vector<Variant> variants = path_variants();
  Builder builder(run, paper);
  builder.equations();
  builder.heading("Number of solutions");
  builder.all_solutions("complex", {"complex", "HOM4PS-2.0"}, &Counts::complex_up_to_reflection,
                        [](const InstanceSummary& instance) {
                          return sign_patterns(instance.has_given_positions, instance.dimension);
                        });
  builder.complex_limit("complex, at most");
  builder.all_solutions("real (up to reflections)", {"real", ""}, &Counts::real_up_to_reflection,
                        [](const InstanceSummary&) { return 1; });
  for (const Variant& variant : variants) builder.solutions_on_path(variant);
  builder.heading("Running times");
  for (const Variant& variant : complex_variants()) builder.times("HOM4PS-2.0", variant);
  for (const Variant& variant : variants) {
    builder.times(variant.strategy == "rcp" ? "Algorithm 1" : "tracking S", variant);
  }
  for (const Variant& variant : baselines()) builder.times("one solution at most", variant);
  builder.times("all solutions", algebraic);
  for (const std::string& program : external_programs(run)) builder.times("external", {program, {}});
  return {builder.take()};
}

}  // namespace gcs
