#pragma once
/// How full-space and rcp track S.

#include "solvers/interface/options.hpp"

namespace gcs {

struct PathSettings {
  enum class Orientation { forward, backward };
  enum class Until { closed, first };

  std::optional<double> step_max = {};
  std::int64_t max_steps = 1'000'000;
  Orientation orientation = Orientation::forward;
  Until until = Until::closed;
  int order = 12;
  double tolerance = 1e-7;

  /// `step_max_summary`: what the strategy takes for step_max=auto.
  template <class Self, class Visitor>
  static void options(Self& self, Visitor& option, std::string_view step_max_summary) {
    option("step_max", self.step_max, AutoOr{{1e-6, 1e6}}, step_max_summary);
    option("max_steps", self.max_steps, Range<std::int64_t>{1, 1'000'000'000},
           "the tracker gives up after so many steps");
    option("orientation", self.orientation, OneOf<Orientation>{"forward|backward"},
           "leave the sketch towards growing or falling t");
    option("until", self.until, OneOf<Until>{"closed|first"}, "first: only as far as the first solution");
    option("order", self.order, Range{4, 40}, "order of the series (fast, certified)");
    option("tolerance", self.tolerance, Range{1e-14, 1e-5},
           "size of the last terms of the series, in units of the scene (fast, certified)");
  }
  bool operator==(const PathSettings&) const = default;
};

}  // namespace gcs
