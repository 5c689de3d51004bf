/// Error against run time: every strategy over its accuracy settings, held against proven solutions.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "harness/drawings/svg_plot.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// By Newton's method in balls, after the strategy.
constexpr std::array more_digits{30, 60, 100};

/// What is exact to the last bit is drawn here: a tenth of the unit roundoff.
constexpr double least_error = 1e-17;

/// To which error a problem counts as solved in the profiles.
constexpr double solved_error = 1e-12;

/// Who follows S is held against those that do; all others find all real solutions when nothing is missed,
/// and some of them the complex ones too.
enum class Job { path, all };

Job job_of(const CellRecord& cell) {
  return cell.claim == Claim::on_path || cell.claim == Claim::on_path_of_core ? Job::path : Job::all;
}

bool is_flawless(const Accuracy& accuracy) { return accuracy.missed == 0U && accuracy.spurious == 0; }

std::vector<const CellRecord*> cells_of(const RunFile& run, const std::string& instance) {
  std::vector<const CellRecord*> cells;
  for (const CellRecord& cell : run.cells)
    if (cell.spec.instance == instance && cell.status != RunStatus::unsupported) cells.push_back(&cell);
  return cells;
}

// ---- tables

TableCell error_entry(Table& table, const CellRecord& cell, double Accuracy::*error) {
  if (!cell.accuracy) return answer_entry(table, &cell, std::nullopt);
  return {cell.accuracy->met == 0 ? "–" : fmt::format("{:.1e}", (*cell.accuracy).*error), {}};
}

TableCell count_entry(std::optional<std::uint64_t> count) {
  return count ? TableCell{std::to_string(*count), {}} : empty_entry();
}

TableRow precision_row(Table& table, const CellRecord& cell) {
  const std::optional<Accuracy>& accuracy = cell.accuracy;
  TableRow row{label_of(cell.spec), {}, {}};
  row.cells = {count_entry(accuracy ? std::optional(accuracy->met) : std::nullopt),
               count_entry(accuracy ? accuracy->missed : std::nullopt),
               count_entry(accuracy ? std::optional(accuracy->spurious) : std::nullopt),
               error_entry(table, cell, &Accuracy::largest_error),
               error_entry(table, cell, &Accuracy::median_error),
               time_entry(table, &cell)};
  for (const auto counter :
       {&WorkCounters::iterations, &WorkCounters::evaluations, &WorkCounters::factorisations})
    row.cells.push_back(answer_entry(table, &cell, static_cast<double>(cell.work.*counter)));
  return row;
}

Table build_instance(const RunFile& run, const InstanceSummary& instance) {
  Table table;
  table.name = "precision-" + instance.id;
  table.caption = "Error against run time: " + instance.id;
  table.groups = {{"solutions", {"met", "missed", "spurious"}},
                  {"error", {"largest", "median"}},
                  {"", {"time"}},
                  {"work", {"steps", "evaluations", "factorisations"}}};
  for (const CellRecord* cell : cells_of(run, instance.id)) table.rows.push_back(precision_row(table, *cell));
  table.remarks = {
      "Errors: largest distance of a point from its place in the proven solution, divided by the scene's "
      "size; "
      "largest and median over the solutions met.",
      "missed: of what the strategy claims to find, of all real ones where it claims some. spurious: listed, "
      "but further than a thousandth of the "
      "size from every proven solution, or listed twice. – where the reference cannot tell.",
      "Reference: " + instance.reference + ".",
      fmt::format("Times: preparing, solving and refining once on one thread, median of interleaved "
                  "repetitions; {}. {}.",
                  spread_remark, run.environment.cpu)};
  return table;
}

// ---- plots

/// Numbers of the strategies in the order of the run, for the same style in every plot.
std::map<std::string, int> styles_of(const RunFile& run) {
  std::map<std::string, int> styles;
  for (const CellRecord& cell : run.cells)
    if (cell.status != RunStatus::unsupported)
      styles.emplace(cell.spec.strategy, static_cast<int>(styles.size()));
  return styles;
}

/// In seconds. Flawed answers are not repeated: of these, what the assessed solve took.
std::optional<double> drawn_time(const CellRecord& cell) {
  if (const auto time = total_time(&cell)) return time->median;
  const bool is_timed = cell.status == RunStatus::complete && cell.warm_up_s > 0;
  return is_timed ? std::optional(cell.warm_up_s) : std::nullopt;
}

/// Decimal logarithms of time in seconds and of the largest error; nothing where there is no time.
std::optional<PlotPoint> place_of(const CellRecord& cell) {
  const auto time = drawn_time(cell);
  if (!time || !cell.accuracy || cell.accuracy->met == 0) return std::nullopt;
  const double floor = std::max(least_error * std::pow(10.0, -std::max(0, cell.spec.digits - 17)), 1e-300);
  return PlotPoint{std::log10(*time), std::log10(std::max(cell.accuracy->largest_error, floor))};
}

/// The cells that no other of the same job beats in time and in error.
PlotSeries pareto_front(const std::vector<const CellRecord*>& cells, Job job) {
  std::vector<PlotPoint> points;
  for (const CellRecord* cell : cells)
    if (const auto place = place_of(*cell);
        place && job_of(*cell) == job && cell->is_right() && is_flawless(*cell->accuracy))
      points.push_back(*place);
  std::sort(points.begin(), points.end());
  PlotSeries front{"", PlotMark::line, {}};
  for (const PlotPoint& point : points)
    if (front.points.empty() || point[1] < front.points.back()[1]) front.points.push_back(point);
  return front;
}

std::vector<PlotSeries> series_of(const std::vector<const CellRecord*>& cells,
                                  const std::map<std::string, int>& styles) {
  std::vector<PlotSeries> series{pareto_front(cells, Job::path), pareto_front(cells, Job::all)};
  series[series[0].points.empty() ? 1 : 0].label = "Pareto front";
  for (const auto& [strategy, style] : styles) {
    PlotSeries one{short_name(strategy), PlotMark::symbol, {}, style};
    for (const CellRecord* cell : cells)
      if (const auto place = place_of(*cell); place && cell->spec.strategy == strategy)
        one.points.push_back(*place);
    if (!one.points.empty()) series.push_back(std::move(one));
  }
  PlotSeries flawed{"missed, spurious or wrong", PlotMark::circle, {}};
  for (const CellRecord* cell : cells)
    if (const auto place = place_of(*cell); place && !(cell->is_right() && is_flawless(*cell->accuracy)))
      flawed.points.push_back(*place);
  if (!flawed.points.empty()) series.push_back(std::move(flawed));
  return series;
}

std::array<double, 2> range_of(const std::vector<PlotSeries>& series, std::size_t axis) {
  std::array<double, 2> range{1e300, -1e300};
  for (const PlotSeries& one : series)
    for (const PlotPoint& point : one.points)
      range = {std::min(range[0], point[axis]), std::max(range[1], point[axis])};
  return range;
}

std::optional<Drawing> draw_instance(const RunFile& run, const InstanceSummary& instance) {
  Plot plot;
  plot.description =
      "Error against run time on " + instance.id +
      ", one mark for each setting of a strategy; a Pareto front for the strategies that "
      "follow S and one for those that find all real solutions, or the complex ones too; an error below "
      "1e-17 is drawn there";
  plot.series = series_of(cells_of(run, instance.id), styles_of(run));
  const auto times = range_of(plot.series, 0), errors = range_of(plot.series, 1);
  if (times[0] > times[1]) return std::nullopt;
  plot.x = decades_over("time (s)", times[0], times[1]);
  plot.y = decades_over("largest error / size", errors[0], errors[1]);
  return Drawing{"precision-" + instance.id, to_svg(plot), plot.description};
}

/// The shortest time in which the strategy solves the instance with any setting, flawlessly and in doubles.
std::optional<double> best_time(const std::vector<const CellRecord*>& cells, const std::string& strategy,
                                Job job) {
  std::optional<double> best;
  for (const CellRecord* cell : cells) {
    const bool solves = cell->spec.strategy == strategy && cell->spec.digits == 0 && job_of(*cell) == job &&
                        cell->accuracy && is_flawless(*cell->accuracy) &&
                        cell->accuracy->largest_error <= solved_error;
    const auto time = solves ? total_time(cell) : std::nullopt;
    if (time) best = std::min(best.value_or(time->median), time->median);
  }
  return best;
}

/// By strategy, of each instance that any of them solves, the decimal logarithm of its time over the best.
std::map<std::string, std::vector<double>> ratios_of(const RunFile& run, Job job, int& problems) {
  std::map<std::string, std::vector<double>> ratios;
  for (const InstanceSummary& instance : run.instances) {
    const auto cells = cells_of(run, instance.id);
    std::map<std::string, double> times;
    for (const CellRecord* cell : cells)
      if (const auto time = best_time(cells, cell->spec.strategy, job)) times[cell->spec.strategy] = *time;
    if (times.empty()) continue;
    ++problems;
    double best = times.begin()->second;
    for (const auto& [strategy, time] : times) best = std::min(best, time);
    for (const auto& [strategy, time] : times) ratios[strategy].push_back(std::log10(time / best));
  }
  return ratios;
}

/// A performance profile (Dolan, Moré 2002).
std::optional<Drawing> draw_profile(const RunFile& run, Job job, const std::string& name,
                                    const std::string& what) {
  int problems = 0;
  auto ratios = ratios_of(run, job, problems);
  if (problems == 0) return std::nullopt;
  double widest = 1;
  for (const auto& [strategy, values] : ratios)
    widest = std::max(widest, *std::max_element(values.begin(), values.end()));
  const std::map<std::string, int> styles = styles_of(run);
  Plot plot;
  plot.description = fmt::format(
      "Performance profile: fraction of {} problems in which a strategy finds {} to an error of {:.0e}, "
      "within "
      "a factor of the best time",
      problems, what, solved_error);
  plot.x = decades_over("time / best time", 0, widest);
  plot.y = axis_over(fmt::format("fraction of {} problems", problems), 0, 1);
  for (auto& [strategy, values] : ratios) {
    std::sort(values.begin(), values.end());
    PlotSeries steps{short_name(strategy), PlotMark::steps, {{0, 0}}, styles.at(strategy)};
    for (std::size_t i = 0; i < values.size(); ++i)
      steps.points.push_back({values[i], static_cast<double>(i + 1) / problems});
    steps.points.push_back({plot.x.high, steps.points.back()[1]});
    plot.series.push_back(std::move(steps));
  }
  return Drawing{name, to_svg(plot), plot.description};
}

}  // namespace

std::vector<Variant> precision_variants(std::span<const StrategyEntry> strategies) {
  std::vector<Variant> variants;
  for (const StrategyEntry& entry : strategies) {
    const std::string name(entry.name);
    variants.push_back({name, {}});
    for (const OptionMap& setting : entry.accuracy_settings) variants.push_back({name, setting});
    for (const int digits : more_digits) variants.push_back({name, {}, {}, {}, digits});
  }
  return variants;
}

std::vector<Table> build_precision(const RunFile& run, const Publication&) {
  std::vector<Table> tables;
  for (const InstanceSummary& instance : run.instances) tables.push_back(build_instance(run, instance));
  return tables;
}

std::vector<Drawing> draw_precision(const RunFile& run) {
  std::vector<Drawing> drawings;
  const auto add = [&](std::optional<Drawing> drawing) {
    if (drawing) drawings.push_back(std::move(*drawing));
  };
  for (const InstanceSummary& instance : run.instances) add(draw_instance(run, instance));
  add(draw_profile(run, Job::path, "precision-profile-path", "all solutions on S"));
  add(draw_profile(run, Job::all, "precision-profile-all", "all real solutions, or the complex ones too,"));
  return drawings;
}

}  // namespace gcs
