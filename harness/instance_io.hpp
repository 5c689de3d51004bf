#pragma once
/// Reads gcsbench-instance/1.

#include <string>
#include <vector>

#include "harness/json_document.hpp"
#include "solvers/model/problem.hpp"

namespace gcs {

/// A figure from the literature: shown and compared, never used by a solver.
struct PublishedFigure {
  std::string quantity;
  std::string convention;
  double value = 0;
  std::string source;
  std::string by;
};

/// An instance: the problem that solvers see, and the rest that they do not.
struct Instance {
  std::string id;
  std::string title;
  std::string notes;
  std::string origin;  ///< the file it came from, or "-"
  Problem problem;
  std::vector<PublishedFigure> published;
  JsonValue document;  ///< the whole file, as written
};

/// Loads and validates `argument`: a file when it has a '/' or ends in .json, "-" for standard input, a
/// member of a family when it has an '@' (families.hpp), anything else the id of a shipped instance, looked
/// up in
/// ./instances and then where the program was built or installed. Checks the format and then the structure
/// (degrees of freedom, rigidity, unsatisfiable inequalities). Throws InputError.
Instance load_instance(const std::string& argument);

/// The same for text already read; `file` is for messages; the id is compared with `expected_id` unless
/// empty.
Instance parse_instance(std::string_view text, const std::string& file, const std::string& expected_id);

/// Whether the shipped instance of that id says the same.
bool is_shipped(const Instance& instance);

/// Ids of all shipped instances, sorted.
std::vector<std::string> shipped_instances();

}  // namespace gcs
