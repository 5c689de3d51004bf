/// The examples of Hoffmann and Yuan beside ours: 5p1L with its lengths, scans and figure, and 6p.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harness/drawings/svg_plot.hpp"
#include "harness/tables/pyramid_solutions.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// Step of the angle in degrees and half-width of the band, as options take them.
struct ScanSetting {
  const char* step;
  const char* delta;

  Variant variant() const {
    return {"theta-scan", {{"method", "published"}, {"dtheta", step}, {"delta", delta}}, {pyramid_instance}};
  }
  std::string printed_as() const { return fmt::format("dtheta={} delta={}", step, delta); }
};

constexpr std::array scan_settings{ScanSetting{"1", "0.1"},   ScanSetting{"1", "0.2"},
                                   ScanSetting{"1", "0.5"},   ScanSetting{"1", "1"},
                                   ScanSetting{"0.1", "0.2"}, ScanSetting{"0.1", "1"}};

const std::vector<std::string>& octahedra() {
  static const std::vector<std::string> ids{"octahedron", "octahedron-cyclohexane"};
  return ids;
}

Variant algebraic() { return {"cayley-menger", {}, octahedra()}; }

bool shows(const RunFile& run, const std::string& id) {
  return std::any_of(run.instances.begin(), run.instances.end(),
                     [&](const InstanceSummary& instance) { return instance.id == id; });
}

std::string times_remark(const RunFile& run) {
  return fmt::format(
      "Times: preparing and solving once on one thread, median of interleaved repetitions; {}. {}.",
      spread_remark, run.environment.cpu);
}

/// The printed length between the two, or nullptr.
const PrintedFigure* printed_length(const Publication& paper, const GivenLength& length) {
  const std::string row = length.between[0] + "–" + length.between[1];
  const auto found =
      std::find_if(paper.figures.begin(), paper.figures.end(), [&](const PrintedFigure& figure) {
        return figure.place == "table 1" && figure.instance == pyramid_instance && figure.row == row;
      });
  return found == paper.figures.end() ? nullptr : &*found;
}

Table build_lengths(const InstanceSummary& instance, const Publication& paper) {
  Table table;
  table.name = "hoffmann-yuan-lengths";
  table.caption = "Hoffmann, Yuan, Table 1: the lengths of 5p1L";
  table.stub = "between";
  table.groups = {{"", {"symbol", "published", "instance"}}};
  for (const GivenLength& length : instance.lengths) {
    const PrintedFigure* figure = printed_length(paper, length);
    TableCell ours{length.text + (length.is_squared ? " (squared)" : ""), {}};
    if (figure != nullptr && figure->printed != ours.text)
      ours.notes.push_back(table.footnote("Not the number that the paper prints."));
    table.rows.push_back({length.between[0] + "–" + length.between[1],
                          {figure == nullptr ? empty_entry() : TableCell{figure->by, {}},
                           printed_entry(table, figure), std::move(ours)},
                          {}});
  }
  table.remarks = {"All lengths in one unit, which the paper does not name.",
                   "Published: " + paper.citation + ", Table 1."};
  return table;
}

TableCell particular_entry(Table& table, const CellRecord* cell, std::string_view name) {
  return answer_entry(table, cell, particular(cell, name));
}

Table build_scans(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "hoffmann-yuan-scans";
  table.caption = "Hoffmann, Yuan, section 4.4: coarse and refined solutions of 5p1L by the scan over θ";
  table.stub = "step, band";
  table.groups = {
      {"coarse", {"published", "ours"}}, {"refined", {"published", "ours"}}, {"time", {"published", "ours"}}};
  for (const ScanSetting& setting : scan_settings) {
    const CellRecord* cell = run.find(setting.variant().on(pyramid_instance));
    const auto printed = [&](const std::string& row) {
      return printed_entry(table, paper.find("section 4.4", row, pyramid_instance, setting.printed_as()));
    };
    TableRow row{fmt::format("dθ = {}°, δ = {}", setting.step, setting.delta), {}, {}};
    row.cells = {printed("coarse"),  particular_entry(table, cell, "coarse_solutions"),
                 printed("refined"), particular_entry(table, cell, "refined_solutions"),
                 printed("time_s"),  time_entry(table, cell)};
    table.rows.push_back(std::move(row));
  }
  table.remarks = {
      "Counted in the 'fixed frame' (line on the x-axis, p5 on the z-axis): the mirror images x → −x and y → "
      "−y apart. Angles θ = 0°, dθ, 2 dθ, …; the band is |d34(θ) − d34| < δ.",
      paper.instance_remarks.at(pyramid_instance), times_remark(run),
      "Published times: " + paper.machine + ".", "Published: " + paper.citation + ", section 4.4."};
  return table;
}

/// A row of the table of 6p: what is printed, and what `entry` makes of the cell of each octahedron.
template <typename Entry>
void add_octahedron_row(Table& table, const RunFile& run, const std::string& label, TableCell printed,
                        const Entry& entry) {
  TableRow row{label, {std::move(printed)}, {}};
  for (const std::string& id : octahedra())
    if (shows(run, id)) row.cells.push_back(entry(run.find(algebraic().on(id))));
  table.rows.push_back(std::move(row));
}

Table build_octahedra(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "hoffmann-yuan-6p";
  table.caption = "Hoffmann, Yuan, section 4.1: the octahedral problem 6p";
  table.groups = {{"published", {""}}};
  for (const std::string& id : octahedra())
    if (shows(run, id)) table.groups.push_back({id, {""}});
  const auto printed = [&](const std::string& row) {
    return printed_entry(table, paper.find("section 4.1", row, "6p", ""));
  };
  // From the coefficients of our two equations.
  const auto total_degree = [&](const CellRecord* cell) {
    TableCell entry = particular_entry(table, cell, "total_degree");
    entry.notes.push_back(table.footnote(
        "Of two equations in two squared diagonals, the product of the degrees of their terms. Of degree 2 "
        "in each diagonal, they have 8 common zeros, 16 solutions with mirror images."));
    return entry;
  };
  // Of each class the fixed frame has two mirror images.
  const auto twice = [&](std::optional<Natural> Counts::*count) {
    return [&table, count](const CellRecord* cell) {
      const bool counted = cell != nullptr && cell->counts.*count;
      return answer_entry(table, cell,
                          counted ? std::optional(2 * (cell->counts.*count)->approximate()) : std::nullopt);
    };
  };
  add_octahedron_row(table, run, "total degree", printed("total degree"), total_degree);
  add_octahedron_row(table, run, "finite roots", printed("finite roots"),
                     twice(&Counts::complex_up_to_reflection));
  add_octahedron_row(table, run, "real roots", printed("real roots"), twice(&Counts::real_up_to_reflection));
  add_octahedron_row(table, run, "time", empty_entry(),
                     [&table](const CellRecord* cell) { return time_entry(table, cell); });
  table.remarks = {"Ours: cayley-menger. Counted in the 'fixed frame': mirror images apart.",
                   paper.instance_remarks.at("octahedron"), times_remark(run),
                   "Published: " + paper.citation + ", section 4.1."};
  return table;
}

/// Angle of p1 around the line in degrees, in [0, 360).
double angle_of(const RecordedSolution& solution) {
  const auto& p1 = solution.points.at("p1");
  const double degrees = std::atan2(p1[2], p1[1]) * 180 / std::numbers::pi;
  return degrees < 0 ? degrees + 360 : degrees;
}

/// From the first to the last angle of any series, in whole multiples of 30°.
PlotAxis angle_axis(const std::vector<PlotSeries>& series) {
  constexpr double tick = 30;
  double first = 360, last = 0;
  for (const PlotSeries& one : series)
    for (const PlotPoint& point : one.points) {
      first = std::min(first, point[0]);
      last = std::max(last, point[0]);
    }
  const double low = tick * std::floor(first / tick);
  return {"θ (degrees)", low, std::max(low + tick, tick * std::ceil(last / tick)), tick};
}

Plot curve_plot(const RecordedCurve& curve, const std::vector<RecordedSolution>& solutions) {
  PlotSeries branches{"branches", PlotMark::dot, {}};
  for (std::size_t i = 0; i < curve.gap.size(); ++i)
    branches.points.push_back({curve.theta[i], curve.gap[i]});
  PlotSeries found{"solutions", PlotMark::circle, {}};
  for (const RecordedSolution& solution : solutions)
    found.points.push_back({angle_of(solution), curve.given});
  Plot plot;
  plot.description = "The distance of p3 and p4 over the angle of p1 around the line, on all branches";
  plot.x = angle_axis({branches, found});
  const auto [low, high] = std::minmax_element(curve.gap.begin(), curve.gap.end());
  plot.y =
      axis_over("d₃₄(θ) (unit of the instance)", std::min(*low, curve.given), std::max(*high, curve.given));
  PlotSeries given{fmt::format("d₃₄ = {:.6g}", curve.given),
                   PlotMark::line,
                   {{plot.x.low, curve.given}, {plot.x.high, curve.given}}};
  plot.series = {std::move(branches), std::move(given), std::move(found)};
  return plot;
}

}  // namespace

const std::vector<std::string>& pyramid_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all{pyramid_instance};
    all.insert(all.end(), octahedra().begin(), octahedra().end());
    return all;
  }();
  return ids;
}

/// The paper's scans, and the one that excludes others than those found, which decides on their number.
std::vector<Variant> pyramid_variants() {
  std::vector<Variant> variants;
  for (const ScanSetting& setting : scan_settings) variants.push_back(setting.variant());
  variants.push_back({"theta-scan", {}, {pyramid_instance}});
  variants.push_back(algebraic());
  return variants;
}

std::vector<Table> build_pyramid(const RunFile& run, const Publication& paper) {
  std::vector<Table> tables;
  for (const InstanceSummary& instance : run.instances)
    if (instance.id == pyramid_instance)
      tables = {build_lengths(instance, paper), build_pyramid_solutions(run, paper), build_scans(run, paper)};
  const bool any_octahedron = std::any_of(octahedra().begin(), octahedra().end(),
                                          [&](const std::string& id) { return shows(run, id); });
  if (any_octahedron) tables.push_back(build_octahedra(run, paper));
  return tables;
}

std::vector<Drawing> draw_pyramid(const RunFile& run) {
  std::vector<Drawing> drawings;
  for (const RecordedCurve& curve : run.curves) {
    if (!shows(run, curve.instance) || curve.gap.empty()) continue;
    const std::vector<RecordedSolution> solutions = fixed_frame_solutions(richest_cell(run, curve.instance));
    const Plot plot = curve_plot(curve, solutions);
    drawings.push_back({curve.instance + "-curve", to_svg(plot), plot.description});
  }
  return drawings;
}

}  // namespace gcs
