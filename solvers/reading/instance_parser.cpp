#include "solvers/reading/instance_parser.hpp"

#include <filesystem>
#include <set>

#include "solvers/elements/general_structure.hpp"
#include "solvers/reading/frame_completion.hpp"
#include "solvers/reading/instance_bodies.hpp"
#include "solvers/reading/instance_constraints.hpp"
#include "solvers/reading/instance_format.hpp"
#include "solvers/reading/instance_hints.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/instance_positions.hpp"
#include "solvers/reading/json_cursor.hpp"
#include "solvers/reading/text_input.hpp"
#include "solvers/structure/structure.hpp"

namespace gcs {
namespace {

/// The rigidity analysis takes time cubic and memory quadratic in the number of entities.
constexpr std::size_t entity_limit = 2000;

std::string read_id(const JsonCursor& root, const std::string& expected) {
  const JsonCursor cursor = root.required("id");
  const std::string id = cursor.name();
  if (id.find('/') != std::string::npos)
    cursor.fail("the id has a '/'", "results are files of that name: leave it out");
  if (!expected.empty() && id != expected) {
    cursor.fail("the id is '" + id + "', but the file is called '" + expected + "'",
                "make the id the file's name without .json");
  }
  return id;
}

int read_dimension(const JsonCursor& root) {
  const JsonCursor cursor = root.required("dimension");
  const Decimal dimension = cursor.number();
  if (dimension.value != 2 && dimension.value != 3) {
    cursor.fail("the dimension is " + dimension.text, "give 2 or 3");
  }
  return static_cast<int>(dimension.value);
}

std::vector<std::string> read_names(const JsonCursor& list, InstanceFormat format,
                                    std::set<std::string>& taken) {
  std::vector<std::string> names;
  for (const JsonCursor& element : list.elements()) {
    names.push_back(element.name());
    if (!taken.insert(names.back()).second) {
      element.fail(
          "the name '" + names.back() + "' is given twice",
          format == InstanceFormat::distances ? "points and lines need different names" : distinct_names);
    }
  }
  return names;
}

void read_lines(const JsonCursor& lines, InstanceFormat format, std::set<std::string>& taken,
                ProblemStatement& problem) {
  problem.lines = read_names(lines, format, taken);
  if (format == InstanceFormat::general || problem.dimension == 3 || problem.lines.empty()) return;
  lines.fail("lines are for space only", general_format_remedy("leave them out or give \"dimension\": 3"));
}

void read_planes(const JsonCursor& planes, std::set<std::string>& taken, ProblemStatement& problem) {
  problem.planes = read_names(planes, InstanceFormat::general, taken);
  if (problem.dimension == 2 && !problem.planes.empty()) refuse_planes_in_the_plane(planes);
}

/// Of gcsbench-instance/1: "points and lines".
void refuse_crowd(const JsonCursor& points, InstanceFormat format, std::size_t count) {
  if (count <= entity_limit) return;
  points.fail("there are " + std::to_string(count) +
                  (format == InstanceFormat::distances ? " points and lines" : " elements"),
              "this program takes up to " + std::to_string(entity_limit));
}

void read_entities(const JsonCursor& root, InstanceFormat format, ProblemStatement& problem) {
  std::set<std::string> taken;
  const JsonCursor points = root.required("points");
  problem.points = read_names(points, format, taken);
  if (format == InstanceFormat::distances && problem.points.empty())
    points.fail("there is no point", general_format_remedy("name the points"));
  if (const auto lines = root.optional("lines")) read_lines(*lines, format, taken, problem);
  if (const auto planes = root.optional("planes")) read_planes(*planes, taken, problem);
  const auto bodies = root.optional("bodies");
  if (bodies) append_body_elements(*bodies, taken, problem);
  if (problem.entity_count() == 0) points.fail("there is no element", "name points, lines, planes or bodies");
  refuse_crowd(points, format, taken.size());
  if (bodies) read_bodies(*bodies, problem);
  problem.fixed_points.resize(problem.points.size());
  problem.fixed_lines.resize(problem.lines.size());
  problem.fixed_planes.resize(problem.planes.size());
}

void refuse_two_frames(const JsonCursor& root, const ProblemStatement& problem) {
  const auto reference = root.optional("reference");
  if (reference && problem.has_fixed())
    reference->fail("fixed positions and a reference exclude each other", "give one of the two");
}

void read_frame(const JsonCursor& root, ProblemStatement& problem) {
  if (const auto reference = root.optional("reference")) {
    read_reference(*reference, problem);
  } else if (!problem.bodies.empty() && !problem.has_fixed()) {
    problem.reference_body = 0;
  }
}

/// Whether as many conditions as freedoms are in the right places.
void check_structure(const JsonCursor& root, InstanceFormat format, const ProblemStatement& problem,
                     const std::string& file) {
  if (problem.is_general()) return;
  if (problem.constraints.empty())
    root.required("constraints").fail("there is no constraint", "give the distances that are to hold");
  if (const auto fixed = root.optional("fixed")) {
    if (format == InstanceFormat::general) require_still(*fixed, problem);
    check_fixed(*fixed, problem);
  }
  require_well_posed(problem, file);
}

ProblemStatement read_problem(const JsonCursor& root, InstanceFormat format, const std::string& file) {
  ProblemStatement problem;
  problem.dimension = read_dimension(root);
  read_entities(root, format, problem);
  if (const auto fixed = root.optional("fixed")) {
    read_fixed(*fixed, problem);
    if (format == InstanceFormat::distances) require_still(*fixed, problem);
    check_fixed_bodies(*fixed, problem);
  }
  read_constraints(root.required("constraints"), format, problem);
  refuse_two_frames(root, problem);
  if (const auto fixed = root.optional("fixed"); fixed && format == InstanceFormat::general)
    complete_frame(*fixed, problem);
  check_structure(root, format, problem, file);
  read_frame(root, problem);
  if (const auto sketch = root.optional("sketch")) read_sketch(*sketch, format, problem);
  if (const auto choice = root.optional("interpolation")) {
    problem.interpolation = read_interpolation(*choice, problem);
  }
  if (const auto plan = root.optional("construction"))
    problem.construction = read_construction(*plan, problem);
  return problem;
}

PublishedFigure read_published(const JsonCursor& cursor) {
  cursor.allow_members({"quantity", "convention", "value", "source", "by"});
  const auto by = cursor.optional("by");
  return {cursor.required("quantity").text(), cursor.required("convention").text(),
          cursor.required("value").number().value, cursor.required("source").text(), by ? by->text() : ""};
}

std::string optional_text(const JsonCursor& root, std::string_view name) {
  const auto found = root.optional(name);
  return found ? found->text() : std::string();
}

}  // namespace

Instance::Instance() = default;
Instance::Instance(const Instance&) = default;
Instance::Instance(Instance&&) noexcept = default;
Instance& Instance::operator=(const Instance&) = default;
Instance& Instance::operator=(Instance&&) noexcept = default;
Instance::~Instance() = default;

Instance parse_instance(std::string_view text, const std::string& file, const std::string& expected_id) {
  Instance instance = parse_statement(text, file, expected_id);
  if (instance.problem.is_general()) require_general_well_posed(instance.problem, file);
  return instance;
}

Instance parse_statement(std::string_view text, const std::string& file, const std::string& expected_id) {
  Instance instance;
  instance.document = parse_json(text, file);
  const JsonCursor root(instance.document, file);
  const InstanceFormat format = read_format(root);
  check_fields(root, format);
  instance.id = read_id(root, expected_id);
  instance.title = optional_text(root, "title");
  instance.notes = optional_text(root, "notes");
  instance.origin = file;
  instance.problem = read_problem(root, format, file);
  if (const auto published = root.optional("published")) {
    for (const JsonCursor& element : published->elements())
      instance.published.push_back(read_published(element));
  }
  const auto sketch = root.optional("sketch");
  if (sketch && !instance.problem.is_general()) check_sketch_frame(*sketch, instance);
  return instance;
}

Instance read_instance(const std::string& file, const std::string& remedy) {
  const std::string text = read_file(file, remedy);
  std::error_code ignored;
  const bool has_name = std::filesystem::is_regular_file(file, ignored);
  return parse_instance(text, file, has_name ? std::filesystem::path(file).stem().string() : std::string());
}

}  // namespace gcs
