#pragma once
/// What plan_scan.cpp can be asked for.

#include "solvers/scanning/scan_settings.hpp"

namespace gcs {

struct PlanScan {
  enum class Method { certified, published };

  static constexpr std::string_view strategy = "plan-scan";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Method method = Method::certified;
  int most_angles = 2;
  ScanSettings scan = {};
  double step = 1;                        ///< degrees
  double start = 0;                       ///< degrees
  std::optional<double> delta = {};       ///< in the file's unit
  std::int64_t max_points = 100'000'000;  ///< of the grid

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("method", self.method, OneOf<Method>{"certified|published"},
           "certified: subdivision with proof; published: a grid, with Newton's method from what is near");
    option("most_angles", self.most_angles, Range{1, 3},
           "certified: more driving parameters are refused; each multiplies the cells by hundreds");
    ScanSettings::options(self.scan, option);
    option("step", self.step, Range{1e-4, 360.0}, "published: step of every angle, in degrees");
    option("start", self.start, Range{0.0, 360.0},
           "published: first value of every angle, in degrees from the beginning of its range");
    option("delta", self.delta, AutoOr{{0.0, 1e300}},
           "published: how near every removed distance must come, in the file's unit of length; auto: as far "
           "as one step of an angle moves a point at the longest given distance",
           OptionTraits{.is_length = true});
    option("max_points", self.max_points, Range<std::int64_t>{1, 1'000'000'000'000},
           "published: a grid of more points is refused");
  }
  bool operator==(const PlanScan&) const = default;
};

}  // namespace gcs
