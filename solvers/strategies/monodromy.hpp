#pragma once
/// What monodromy.cpp can be asked for.

#include "solvers/homotopies/homotopy_settings.hpp"

namespace gcs {

struct Monodromy {
  static constexpr std::string_view strategy = "monodromy";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  int arcs = 12;
  bool trace = true;
  std::optional<std::string> start = {};       ///< the start system to read
  std::optional<std::string> save_start = {};  ///< or where to keep the one found
  HomotopySettings tracking = {};

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("arcs", self.arcs, Range{2, 1000}, "ways between the two sets of random lengths, at most");
    option("trace", self.trace, OnOff{}, "test completeness by a trace where no count is met");
    option("start", self.start, FileName{},
           "start with the solutions at random lengths that save_start wrote");
    option("save_start", self.save_start, FileName{},
           "write the solutions at random lengths, for this graph with any lengths",
           OptionTraits{.changes_result = false});
    HomotopySettings::options(self.tracking, option);
  }
  bool operator==(const Monodromy&) const = default;
};

}  // namespace gcs
