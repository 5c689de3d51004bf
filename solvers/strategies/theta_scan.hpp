#pragma once
/// What theta_scan.cpp can be asked for.

#include "solvers/scanning/scan_settings.hpp"

namespace gcs {

struct ThetaScan {
  enum class Method { events, published };

  static constexpr std::string_view strategy = "theta-scan";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Method method = Method::events;
  double dtheta = 1;   ///< degrees
  double start = 0;    ///< degrees
  double delta = 0.2;  ///< in the file's unit
  ScanSettings scan = {};

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("method", self.method, OneOf<Method>{"events|published"},
           "events: subdivision with proof; published: the paper's scan");
    option("dtheta", self.dtheta, Range{1e-4, 360.0}, "published: step of the angle, in degrees");
    option("start", self.start, Range{-360.0, 360.0}, "published: first angle, in degrees");
    option("delta", self.delta, Range{0.0, 1e300},
           "published: how near d34(theta) must come to d34, in the file's unit of length",
           OptionTraits{.is_length = true});
    ScanSettings::options(self.scan, option);
  }
  bool operator==(const ThetaScan&) const = default;
};

}  // namespace gcs
