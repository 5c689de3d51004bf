#pragma once
/// What system_paths.cpp can be asked for.

#include "solvers/interface/options.hpp"
#include "solvers/systems/system_paths.hpp"

namespace gcs {

struct SystemPaths {
  enum class System { quartics, quadrics, echelon, parametrised };

  static constexpr std::string_view strategy = "system-paths";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  System system = System::quartics;
  PathStart start = PathStart::mixed_cells;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("system", self.system, OneOf<System>{"quartics|quadrics|echelon|parametrised"},
           "quartics: of 6p, three in half angles; quadrics: nine of 6p, twelve of 5p1L, those of general "
           "scenes; "
           "echelon: these after Gaussian elimination; parametrised: of 5p1L, two points eliminated");
    option("start", self.start, OneOf<PathStart>{"mixed-cells|total-degree"},
           "as many paths as the mixed volume, or as Bezout's number");
  }
  bool operator==(const SystemPaths&) const = default;
};

}  // namespace gcs
