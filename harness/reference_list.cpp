#include "harness/reference_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "harness/json_cursor.hpp"
#include "harness/solve_run.hpp"
#include "harness/stop_conditions.hpp"
#include "harness/text_input.hpp"
#include "solvers/model/reflection_classes.hpp"
#include "solvers/tracking/certified_tracker.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {
namespace {

constexpr std::string_view format_name = "gcsbench-reference/1";

/// Proven solutions closer together than this of the scene's size are the same, found twice; so close ones of
/// different classes would have condition numbers beyond what a list of solutions in doubles can tell.
constexpr double same_place = 1e-9;

// ---- the shipped lists

double decimal_value(const JsonCursor& cursor) {
  const std::string text = cursor.text();
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0')
    cursor.fail("'" + text + "' is no number", "give a decimal number as a text");
  return value;
}

/// Sets the numbers of one vector; `im` is null for a real one.
void read_vector(const JsonCursor& cursor, int dimension, Eigen::Ref<Eigen::Vector3d> re, double* im) {
  const auto entries = cursor.elements(static_cast<std::size_t>(dimension), "coordinates");
  for (int axis = 0; axis < dimension; ++axis) {
    const JsonCursor& entry = entries[static_cast<std::size_t>(axis)];
    if (im == nullptr) {
      re[axis] = decimal_value(entry);
      continue;
    }
    const auto parts = entry.elements(2, "numbers, re and im");
    re[axis] = decimal_value(parts[0]);
    im[axis] = decimal_value(parts[1]);
  }
}

LinePosition zero_line() { return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}; }

Figure read_figure(const JsonCursor& cursor, const Problem& problem) {
  const bool is_real = cursor.required("real").value().boolean;
  const auto count = static_cast<Eigen::Index>(problem.points.size());
  Figure figure{Eigen::Matrix3Xd::Zero(3, count), {}};
  if (!is_real) figure.imaginary = Eigen::Matrix3Xd::Zero(3, count);
  const JsonCursor points = cursor.required("points");
  for (Eigen::Index i = 0; i < count; ++i)
    read_vector(points.required(problem.points[static_cast<std::size_t>(i)]), problem.dimension,
                figure.points.col(i), is_real ? nullptr : figure.imaginary.col(i).data());
  for (const std::string& name : problem.lines) {
    const JsonCursor line = cursor.required("lines").required(name);
    LinePosition& re = figure.lines.emplace_back(zero_line());
    LinePosition* im = is_real ? nullptr : &figure.imaginary_lines.emplace_back(zero_line());
    read_vector(line.required("point"), 3, re.point, im == nullptr ? nullptr : im->point.data());
    read_vector(line.required("direction"), 3, re.direction, im == nullptr ? nullptr : im->direction.data());
  }
  return figure;
}

std::optional<std::string> shipped_file(const std::string& id) {
  const std::filesystem::path below = std::filesystem::path("results") / "reference" / (id + ".json");
  for (const auto& file : {below, std::filesystem::path(GCSBENCH_SOURCE_DIR) / below})
    if (std::filesystem::is_regular_file(file)) return file.string();
  return std::nullopt;
}

ReferenceList read_list(const JsonCursor& root, const Problem& problem, const std::string& file) {
  ReferenceList list;
  const JsonCursor origin = root.required("origin");
  const std::string claim = origin.required("claim").text();
  list.source = file;
  list.has_all_complex = claim == word(Claim::all_complex) && !origin.required("only_real").value().boolean;
  list.has_all_real = claim == word(Claim::all_complex) || claim == word(Claim::all_real);
  for (const JsonCursor& solution : root.required("solutions").elements())
    list.figures.push_back(read_figure(solution, problem));
  return list;
}

// ---- lists made now

void pool(const Scene& scene, const SolveRun& run, ReferenceList& list) {
  for (const AssessedSolution& solution : run.assessment.solutions)
    if (solution.certified) list.figures.push_back(solution.figure);
  const bool is_proven = run.status == RunStatus::complete && run.assessment.failed_checks.empty();
  list.has_all_complex = list.has_all_complex || (is_proven && run.claim == Claim::all_complex);
  list.has_all_real =
      list.has_all_real || list.has_all_complex || (is_proven && run.claim == Claim::all_real);
  std::vector<Figure> scaled;
  for (const Figure& figure : list.figures) scaled.push_back(scene.in_scene_unit(figure));
  std::vector<Figure> distinct;
  for (const int first : reflection_classes(scene, scaled, same_place).first)
    distinct.push_back(list.figures[static_cast<std::size_t>(first)]);
  list.figures = std::move(distinct);
}

ReferenceList list_found_now(const Scene& scene, double limit_s, Monitor& progress) {
  ReferenceList list;
  list.source = "proven in this run";
  RunLimits limits;
  limits.time_limit_s = limit_s;
  limits.certify = true;
  for (const StrategyEntry& entry : all_strategies()) {
    if (interrupted()) break;
    progress.progress("reference, " + std::string(entry.name), -1);
    pool(scene, run_strategy(entry, {}, scene, limits), list);
  }
  return list;
}

/// Empty where S is not proven in time or a crossing is not in the list.
std::optional<std::vector<bool>> known_on_path(const Scene& scene, const ReferenceList& list,
                                               double limit_s) {
  if (why_not_proven(scene)) return std::nullopt;
  const StopWatch watch(limit_s);
  CertifiedTracker tracker(scene, {}, {watch.token(), nullptr});
  const SolveReport report =
      path_report(scene, tracker.run(), [&](const Eigen::VectorXd& y) { return tracker.figure(y); });
  if (report.status != SolveStatus::complete) return std::nullopt;
  std::vector<Figure> figures;
  for (const Figure& figure : list.figures) figures.push_back(scene.in_scene_unit(figure));
  for (const Candidate& candidate : report.candidates) figures.push_back(candidate.figure);
  const ReflectionClasses classes = reflection_classes(scene, figures, same_place);
  std::vector<bool> on_path(list.figures.size(), false);
  for (std::size_t i = on_path.size(); i < figures.size(); ++i) {
    const auto same = static_cast<std::size_t>(classes.first[static_cast<std::size_t>(classes.class_of[i])]);
    if (same >= on_path.size()) return std::nullopt;
    on_path[same] = true;
  }
  return on_path;
}

}  // namespace

std::optional<ReferenceList> shipped_reference(const Instance& instance) {
  const auto file = shipped_file(instance.id);
  if (!file) return std::nullopt;
  const JsonValue document = parse_json(read_file(*file, "run scripts/make-references"), *file);
  const JsonCursor root(document, *file);
  const JsonCursor format = root.required("format");
  if (format.text() != format_name)
    format.fail("the format is '" + format.text() + "'", fmt::format("it must be '{}'", format_name));
  if (to_text(root.required("instance").value(), -1) != to_text(instance.document, -1)) return std::nullopt;
  return read_list(root, instance.problem, *file);
}

ReferenceList reference_for(const Instance& instance, const Scene& scene, double limit_s, Monitor& progress) {
  const auto shipped = shipped_reference(instance);
  ReferenceList list = shipped ? *shipped : list_found_now(scene, limit_s, progress);
  list.on_path = known_on_path(scene, list, limit_s);
  return list;
}

}  // namespace gcs
