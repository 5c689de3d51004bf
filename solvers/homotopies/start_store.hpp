#pragma once
/// Start systems that outlive a solve: the solutions at random lengths serve every choice of lengths, and
/// whoever has them follows one homotopy in the place of a search.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solvers/homotopies/general_family.hpp"
#include "solvers/homotopies/monodromy_search.hpp"
#include "solvers/homotopies/trace_test.hpp"

namespace gcs {

/// All that is known of one generic member of a family, and how it was found.
struct StartSystem {
  GenericSolutions generic;
  std::optional<TraceTest> trace;  ///< where no count said that the list is complete
};

/// The equations that a start system is for.
struct StartFamily {
  std::vector<std::string>
      equations;  ///< all but their free right-hand sides, as text: equal ones are one family
  int unknowns = 0;
  int parameters = 0;  ///< free right-hand sides
  SignMasks signs;     ///< that are divided out
  /// The largest residual of an equation at x for these parameters, relative to its terms; infinite where one is no
  /// finite number.
  std::function<double(const ComplexVectorX& x, const ComplexVectorX& parameters)> residual;
};

/// Distance equations, with all squared lengths free: "(x0-x3)^2 + (x1-0.5)^2". The system outlives the family.
StartFamily start_family(const SquareSystem& system, SignMasks signs);
/// Those of a general scene, with all values free: "2*x0*x3 + x1". The equations outlive the family.
StartFamily start_family(const GeneralEquations& equations);

/// Where start systems are kept, by the names that the user gives them. Implementations say how they fail.
class StartStore {
 public:
  virtual ~StartStore() = default;
  /// The start system of that name, which is one of these equations: nothing else is ever returned.
  virtual StartSystem read(const std::string& name, const StartFamily& family) const = 0;
  /// Makes sure, before the work, that `name` can be written.
  virtual void reserve(const std::string& name) = 0;
  /// Precondition: `name` is reserved, and neither the search nor the trace test was stopped.
  virtual void write(const std::string& name, const StartFamily& family, const StartSystem& start) = 0;
};

/// What keeps the lists of `generic`, of the right sizes, from being distinct solutions of one member of the
/// family; nothing where they are.
struct StartDefect {
  int solution = 0;  ///< the first that is wrong
  std::string what;  ///< about it, in words
};
std::optional<StartDefect> find_defect(const StartFamily& family, const GenericSolutions& generic);

}  // namespace gcs
