/// Table 2 of Hoffmann and Yuan: the 24 solutions of their example, each against the nearest of ours.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "harness/tables/pyramid_solutions.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// Half a unit in the last printed place; what is more is not rounding. (The last bits of the decimal numbers
/// themselves are let through.)
double rounding_of(const std::string& printed) {
  const std::size_t point = printed.find('.');
  const auto places = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
  return 0.5 * std::pow(10.0, -places) * (1 + 1e-9);
}

double number_of(const std::string& printed) { return std::strtod(printed.c_str(), nullptr); }

/// How printed points compare with a solution.
struct Comparison {
  int agreeing = 0;          ///< coordinates that agree to rounding
  int coordinates = 0;       ///< in all
  double difference = 0;     ///< the largest
  std::set<std::string> at;  ///< points with a coordinate that does not agree

  bool agrees() const { return agreeing == coordinates; }
  bool is_nearer_than(const Comparison& other) const {
    return agreeing != other.agreeing ? agreeing > other.agreeing : difference < other.difference;
  }
};

Comparison compared(const std::vector<PrintedPoint>& points, const RecordedSolution& solution) {
  Comparison result;
  for (const PrintedPoint& point : points) {
    const auto ours = solution.points.find(point.name);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ++result.coordinates;
      const double difference = ours == solution.points.end()
                                    ? std::numeric_limits<double>::infinity()
                                    : std::abs(ours->second[axis] - number_of(point.printed[axis]));
      result.difference = std::max(result.difference, difference);
      if (difference <= rounding_of(point.printed[axis]))
        ++result.agreeing;
      else
        result.at.insert(point.name);
    }
  }
  return result;
}

/// The solution with which most coordinates agree: a single misprint does not lead to another one.
std::size_t nearest(const std::vector<PrintedPoint>& points, const std::vector<RecordedSolution>& ours) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < ours.size(); ++i)
    if (compared(points, ours[i]).is_nearer_than(compared(points, ours[best]))) best = i;
  return best;
}

std::string coordinates_text(const PrintedPoint& point) {
  return fmt::format("({}, {}, {})", point.printed[0], point.printed[1], point.printed[2]);
}

/// The printed points with the known corrections in their places.
std::vector<PrintedPoint> corrected(const PrintedSolution& printed) {
  std::vector<PrintedPoint> points = printed.points;
  for (PrintedPoint& point : points)
    for (const PrintedPoint& right : printed.corrected)
      if (right.name == point.name) point = right;
  return points;
}

/// What is known of a row that does not agree with our solution.
std::string explanation(const PrintedSolution& printed, const RecordedSolution& ours) {
  const Comparison with = compared(corrected(printed), ours);
  if (!printed.correction || !with.agrees()) return "Differs from ours by more than rounding.";
  std::string text = "Known to be wrong.";
  for (const PrintedPoint& point : printed.corrected)
    text += fmt::format(" {} = {} instead leaves a difference of {:.4f}.", point.name,
                        coordinates_text(point), with.difference);
  return fmt::format("{} {} ({})", text, printed.correction->reason, printed.correction->source);
}

class Builder {
 public:
  explicit Builder(const RunFile& run) : cell_(richest_cell(run, pyramid_instance)) {
    ours_ = fixed_frame_solutions(cell_);
    table_.name = "hoffmann-yuan-solutions";
    table_.caption = "Hoffmann, Yuan, Table 2: the solutions of 5p1L as published, against ours";
    table_.stub = "number";
  }

  void add(const PrintedSolution& printed) {
    if (table_.groups.empty()) add_columns(printed);
    TableRow row{std::to_string(printed.number), {}, {}};
    for (const PrintedPoint& point : printed.points) row.cells.push_back({coordinates_text(point), {}});
    row.cells.push_back(ours_.empty() ? TableCell{"not measured", {}} : difference_entry(printed, row));
    table_.rows.push_back(std::move(row));
  }

  Table take(const Publication& paper) {
    table_.remarks = {
        "Frame: the line on the x-axis, p5 on the z-axis. Difference: the largest of the twelve coordinates, "
        "between the published one, rounded to two decimals, and ours, unrounded; rounding explains 0.005."};
    if (cell_ != nullptr)
      table_.remarks.push_back(
          fmt::format("Ours: {}, {} solutions; the {} rows are {} of them.", label_of(cell_->spec),
                      ours_.size(), table_.rows.size(),
                      matched_.size() == table_.rows.size() ? "as many" : std::to_string(matched_.size())));
    table_.remarks.push_back("Published: " + paper.citation + ", Table 2.");
    return std::move(table_);
  }

 private:
  void add_columns(const PrintedSolution& printed) {
    ColumnGroup published{"published", {}};
    for (const PrintedPoint& point : printed.points) published.columns.push_back(point.name);
    table_.groups = {std::move(published), {"ours", {"largest difference"}}};
  }

  TableCell difference_entry(const PrintedSolution& printed, TableRow& row) {
    const std::size_t match = nearest(printed.points, ours_);
    matched_.insert(match);
    const Comparison comparison = compared(printed.points, ours_[match]);
    TableCell entry{fmt::format("{:.4f}", comparison.difference), {}};
    if (comparison.agrees()) return entry;
    const int note = table_.footnote(explanation(printed, ours_[match]));
    entry.notes.push_back(note);
    for (std::size_t i = 0; i < printed.points.size(); ++i)
      if (comparison.at.count(printed.points[i].name) > 0) row.cells[i].notes.push_back(note);
    return entry;
  }

  const CellRecord* cell_;
  std::vector<RecordedSolution> ours_;
  std::set<std::size_t> matched_;  ///< of ours
  Table table_;
};

}  // namespace

Table build_pyramid_solutions(const RunFile& run, const Publication& paper) {
  Builder builder(run);
  for (const PrintedSolution& solution : paper.solutions)
    if (solution.place == "table 2" && solution.instance == pyramid_instance) builder.add(solution);
  return builder.take(paper);
}

}  // namespace gcs
