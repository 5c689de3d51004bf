#pragma once
/// What box_subdivision.cpp can be asked for.

#include "solvers/interface/options.hpp"
#include "solvers/subdivision/subdivision.hpp"

namespace gcs {

struct BoxSubdivision {
  static constexpr std::string_view strategy = "box-subdivision";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Reduction reduction = Reduction::linear;
  std::int64_t max_boxes = 10'000'000;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("reduction", self.reduction, OneOf<Reduction>{"none|box|linear"},
           "what narrows a box before it is halved: Krawczyk's operator alone, each equation too, or linear "
           "programs over all equations too");
    option("max_boxes", self.max_boxes, Range<std::int64_t>{1, 1'000'000'000'000},
           "boxes after which the subdivision gives up");
  }
  bool operator==(const BoxSubdivision&) const = default;
};

}  // namespace gcs
