#pragma once
/// Start systems that outlive a solve: the solutions at random lengths serve every choice of lengths, and
/// whoever has them follows one homotopy in the place of a search.

#include <optional>
#include <string>

#include "solvers/homotopies/monodromy_search.hpp"
#include "solvers/homotopies/trace_test.hpp"

namespace gcs {

/// All that is known of one generic member of a family, and how it was found.
struct StartSystem {
  GenericSolutions generic;
  std::optional<TraceTest> trace;  ///< where no count said that the list is complete
};

/// The equations that a start system is for, with all squared lengths free.
struct LengthFamily {
  const SquareSystem& system;
  SignMasks signs;  ///< that are divided out
};

/// Where start systems are kept, by the names that the user gives them. Implementations say how they fail.
class StartStore {
 public:
  virtual ~StartStore() = default;
  /// The start system of that name, which is one of these equations: nothing else is ever returned.
  virtual StartSystem read(const std::string& name, const LengthFamily& family) const = 0;
  /// Makes sure, before the work, that `name` can be written.
  virtual void reserve(const std::string& name) = 0;
  /// Precondition: `name` is reserved, and neither the search nor the trace test was stopped.
  virtual void write(const std::string& name, const LengthFamily& family, const StartSystem& start) = 0;
};

/// What keeps the lists of `generic`, of the right sizes, from being distinct solutions of one member of the
/// family; nothing where they are.
struct StartDefect {
  int solution = 0;  ///< the first that is wrong
  std::string what;  ///< about it, in words
};
std::optional<StartDefect> find_defect(const LengthFamily& family, const GenericSolutions& generic);

}  // namespace gcs
