#pragma once
/// What polyhedral.cpp can be asked for.

#include "solvers/homotopies/homotopy_settings.hpp"
#include "solvers/polyhedral/formulation.hpp"

namespace gcs {

struct Polyhedral {
  static constexpr std::string_view strategy = "polyhedral";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Formulation formulation = Formulation::spheres;
  HomotopySettings tracking = {};

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("formulation", self.formulation, OneOf<Formulation>{"spheres|coordinates"},
           "with the points' squared norms as unknowns, or the coordinates alone");
    HomotopySettings::options(self.tracking, option);
  }
  bool operator==(const Polyhedral&) const = default;
};

}  // namespace gcs
