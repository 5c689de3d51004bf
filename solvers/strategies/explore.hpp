#pragma once
/// What explore.cpp can be asked for.

#include "solvers/interface/options.hpp"

namespace gcs {

struct Explore {
  enum class Mode { fast, certified };

  static constexpr std::string_view strategy = "explore";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Mode mode = Mode::fast;
  std::int64_t curves = 1'000'000;
  int starts = 64;
  double unseen = 0;
  std::int64_t max_steps = 1'000'000;
  int order = 12;
  double tolerance = 1e-7;
  int samples = 0;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("mode", self.mode, OneOf<Mode>{"fast|certified"},
           "fast: Taylor series in arc length; certified: a chain of tubes around each curve that is closed, "
           "which "
           "prove the order and number of its crossings");
    option("curves", self.curves, Range<std::int64_t>{1, 1'000'000'000}, "curves at most");
    option("starts", self.starts, Range{0, 1'000'000},
           "random starts when no curve is left, and again each time that one leads to a new solution");
    option("unseen", self.unseen, Range{0.0, 1e9},
           "stop when fewer classes than this are expected to be unseen, by estimate; 0: walk every curve");
    option("max_steps", self.max_steps, Range<std::int64_t>{1, 1'000'000'000},
           "the tracker gives a curve up after so many steps");
    option("order", self.order, Range{4, 40}, "order of the series");
    option("tolerance", self.tolerance, Range{1e-14, 1e-5},
           "size of the last terms of the series, in units of the scene");
    option("samples", self.samples, Range{0, 100},
           "figures to keep of each step along a curve, for drawings; of a proven curve none");
  }
  bool operator==(const Explore&) const = default;
};

}  // namespace gcs
