#include "solvers/reading/instance_parser.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "solvers/reading/instance_hints.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/instance_positions.hpp"
#include "solvers/reading/json_cursor.hpp"
#include "solvers/reading/text_input.hpp"
#include "solvers/structure/structure.hpp"

namespace gcs {
namespace {

constexpr const char* format_name = "gcsbench-instance/1";

/// The rigidity analysis takes time cubic and memory quadratic in the number of entities.
constexpr std::size_t entity_limit = 2000;

void check_format(const JsonCursor& root) {
  const JsonCursor format = root.required("format");
  const std::string name = format.text();
  if (name != format_name) {
    format.fail("the format is '" + name + "'", std::string("this program reads '") + format_name + "'");
  }
}

void check_fields(const JsonCursor& root) {
  for (const std::string_view kind : {"planes", "angles", "incidences", "circles"}) {
    if (const auto found = root.optional(kind)) {
      found->fail(std::string(kind) + " are not supported", "give points, lines, and distances between them");
    }
  }
  root.allow_members({"format", "id", "title", "dimension", "points", "lines", "fixed", "constraints",
                      "reference", "sketch", "interpolation", "construction", "published", "notes"});
}

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

std::vector<std::string> read_names(const JsonCursor& list, std::set<std::string>& taken) {
  std::vector<std::string> names;
  for (const JsonCursor& element : list.elements()) {
    names.push_back(element.name());
    if (!taken.insert(names.back()).second) {
      element.fail("the name '" + names.back() + "' is given twice", "points and lines need different names");
    }
  }
  return names;
}

void read_entities(const JsonCursor& root, ProblemStatement& problem) {
  std::set<std::string> taken;
  const JsonCursor points = root.required("points");
  problem.points = read_names(points, taken);
  if (problem.points.empty()) points.fail("there is no point", "name the points");
  if (const auto lines = root.optional("lines")) {
    problem.lines = read_names(*lines, taken);
    if (problem.dimension == 2 && !problem.lines.empty()) {
      lines->fail("lines are for space only", "leave them out or give \"dimension\": 3");
    }
  }
  if (taken.size() > entity_limit) {
    points.fail("there are " + std::to_string(taken.size()) + " points and lines",
                "this program takes up to " + std::to_string(entity_limit));
  }
}

void check_type(const JsonCursor& constraint) {
  const JsonCursor cursor = constraint.required("type");
  const std::string type = cursor.text();
  if (type == "distance") return;
  const bool incidence = type == "incidence" || type == "coincidence" || type == "on";
  cursor.fail("constraints of type '" + type + "' are not supported",
              std::string("the only known type is 'distance'") +
                  (incidence ? "; a point on a line is a distance of length 0" : ""));
}

std::array<int, 2> read_between(const JsonCursor& constraint, const ProblemStatement& problem) {
  const JsonCursor between = constraint.required("between");
  const auto ends = between.elements(2, "names of points or lines");
  const std::array<int, 2> result{entity_number(problem, ends[0].name(), ends[0]),
                                  entity_number(problem, ends[1].name(), ends[1])};
  if (result[0] == result[1]) {
    between.fail("'" + problem.name(result[0]) + "' has no distance to itself",
                 "name two different entities");
  }
  if (!problem.is_point(result[0]) && !problem.is_point(result[1])) {
    between.fail("distances between two lines are not supported", "name a point and a line, or two points");
  }
  if (problem.is_fixed(result[0]) && problem.is_fixed(result[1])) {
    between.fail("'" + problem.name(result[0]) + "' and '" + problem.name(result[1]) + "' are both fixed",
                 "leave this constraint out, the positions give the distance");
  }
  return result;
}

Decimal read_given(const JsonCursor& constraint, bool is_squared, bool with_line) {
  const JsonCursor cursor = constraint.required(is_squared ? "squared" : "length");
  const Decimal given = cursor.number();
  constexpr double least = std::numeric_limits<double>::min();
  if (given.value > 0 && given.value < least)
    cursor.fail(given.text + " is too small for a double's full precision",
                "give lengths in a smaller unit, as numbers above 1e-300");
  if (given.value > 0 || (with_line && given.value == 0)) return given;
  cursor.fail("the length is " + given.text,
              with_line ? "a distance to a line is ≥ 0" : "a distance between two points is > 0");
}

DistanceConstraint read_constraint(const JsonCursor& cursor, const ProblemStatement& problem) {
  check_type(cursor);
  cursor.allow_members({"id", "type", "between", "length", "squared"});
  DistanceConstraint constraint;
  const auto id = cursor.optional("id");
  constraint.id = id ? id->name() : "a" + std::to_string(problem.constraints.size() + 1);
  constraint.between = read_between(cursor, problem);
  if (cursor.has("length") == cursor.has("squared")) {
    cursor.fail(cursor.has("length") ? "both 'length' and 'squared' are given" : "the length is missing",
                "give either 'length' or 'squared'");
  }
  constraint.is_squared = cursor.has("squared");
  const bool with_line = !problem.is_point(constraint.between[0]) || !problem.is_point(constraint.between[1]);
  constraint.given = read_given(cursor, constraint.is_squared, with_line);
  return constraint;
}

void read_constraints(const JsonCursor& list, ProblemStatement& problem) {
  std::set<std::string> ids;
  std::map<std::pair<int, int>, std::string> by_pair;
  for (const JsonCursor& element : list.elements()) {
    DistanceConstraint constraint = read_constraint(element, problem);
    if (!ids.insert(constraint.id).second) {
      element.fail("the constraint id '" + constraint.id + "' is taken", "give every constraint its own id");
    }
    const auto [pair, is_new] =
        by_pair.emplace(std::minmax(constraint.between[0], constraint.between[1]), constraint.id);
    if (!is_new) {
      element.fail("over-constrained: '" + pair->second + "' and '" + constraint.id +
                       "' both give the distance of " +
                       entity_names(problem, {constraint.between[0], constraint.between[1]}),
                   "keep one of them");
    }
    problem.constraints.push_back(std::move(constraint));
  }
  if (problem.constraints.empty()) list.fail("there is no constraint", "give the distances that are to hold");
}

void read_reference_unless_fixed(const JsonCursor& cursor, ProblemStatement& problem) {
  if (problem.is_anchored())
    cursor.fail("fixed positions and a reference exclude each other", "give one of the two");
  problem.reference = read_reference(cursor, problem);
}

ProblemStatement read_problem(const JsonCursor& root, const std::string& file) {
  ProblemStatement problem;
  problem.dimension = read_dimension(root);
  read_entities(root, problem);
  problem.fixed_points.resize(problem.points.size());
  problem.fixed_lines.resize(problem.lines.size());
  if (const auto fixed = root.optional("fixed")) read_fixed(*fixed, problem);
  read_constraints(root.required("constraints"), problem);
  if (const auto fixed = root.optional("fixed")) check_fixed(*fixed, problem);
  require_well_posed(problem, file);
  if (const auto reference = root.optional("reference")) read_reference_unless_fixed(*reference, problem);
  if (const auto sketch = root.optional("sketch")) read_sketch(*sketch, problem);
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

Instance parse_instance(std::string_view text, const std::string& file, const std::string& expected_id) {
  Instance instance;
  instance.document = parse_json(text, file);
  const JsonCursor root(instance.document, file);
  check_format(root);
  check_fields(root);
  instance.id = read_id(root, expected_id);
  instance.title = optional_text(root, "title");
  instance.notes = optional_text(root, "notes");
  instance.origin = file;
  instance.problem = read_problem(root, file);
  if (const auto published = root.optional("published")) {
    for (const JsonCursor& element : published->elements())
      instance.published.push_back(read_published(element));
  }
  if (const auto sketch = root.optional("sketch")) check_sketch_frame(*sketch, instance);
  return instance;
}

Instance read_instance(const std::string& file, const std::string& remedy) {
  const std::string text = read_file(file, remedy);
  std::error_code ignored;
  const bool has_name = std::filesystem::is_regular_file(file, ignored);
  return parse_instance(text, file, has_name ? std::filesystem::path(file).stem().string() : std::string());
}

}  // namespace gcs
