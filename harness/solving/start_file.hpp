#pragma once
/// Start systems in files of the format gcsbench-start/1:
///   {"format": "gcsbench-start/1",
///    "equations": ["(x0-x3)^2 + (x1-0.5)^2", …],   the left-hand side of each constraint, in order
///    "search": {"end": "complete", "solutions": 3090, "arcs": 4, "paths": 10896, "lost_paths": 0},
///    "trace": {"end": "complete", "points": 512, "solutions": 32, "defect": 1e-15}, or null,
///    "squares": [[re, im], …],                     the generic right-hand sides
///    "solutions": [[[re, im], …], …]}              of each class up to reflection one solution
/// The unknowns x0, x1, … are the free coordinates of the points, in their order, in the scene's frame.

#include <map>
#include <memory>
#include <string>

#include "harness/base/atomic_file.hpp"
#include "solvers/homotopies/start_store.hpp"

namespace gcs {

/// Names are those of files. One is read only when it is asked for, and written all at once.
class StartFiles final : public StartStore {
 public:
  /// Throws InputError for a file that is not of the format, is for other equations, or does not hold
  /// distinct solutions: with the place, what is wrong and what would be right.
  StartSystem read(const std::string& name, const StartFamily& family) const override;
  /// Throws OutputError when the place cannot be written.
  void reserve(const std::string& name) override;
  /// Throws OutputError when the disk is full.
  void write(const std::string& name, const StartFamily& family, const StartSystem& start) override;

 private:
  std::map<std::string, std::unique_ptr<AtomicFile>> reserved_;
};

}  // namespace gcs
