#pragma once
/// Reads gcsbench-instance/1 and gcsbench-instance/2.

#include <string>
#include <string_view>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/reading/json_document.hpp"

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
  ProblemStatement problem;
  std::vector<PublishedFigure> published;
  JsonValue document;  ///< the whole file, as written

  /// Ready to be solved.
  operator Scene() const { return Scene::unchecked(problem); }

  /// Compiled once.
  Instance();
  Instance(const Instance&);
  Instance(Instance&&) noexcept;
  Instance& operator=(const Instance&);
  Instance& operator=(Instance&&) noexcept;
  ~Instance();
};

/// Reads and checks an instance: the format and then the structure (degrees of freedom, rigidity and, where there are only
/// distances, unsatisfiable inequalities). `file` is for messages; the id is compared with `expected_id` unless empty.
/// Throws InputError.
Instance parse_instance(std::string_view text, const std::string& file = "instance",
                        const std::string& expected_id = {});

/// The same but for the structure of general scenes, which may be loose or say too much.
Instance parse_statement(std::string_view text, const std::string& file = "instance",
                         const std::string& expected_id = {});

/// Reads and checks the instance in a file, whose id is the file's name without .json unless the file is a pipe.
/// `remedy`: what to give in the place of a file that cannot be read. Throws InputError.
Instance read_instance(const std::string& file, const std::string& remedy = "give a file that can be read");

}  // namespace gcs
