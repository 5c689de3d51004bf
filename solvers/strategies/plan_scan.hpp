#pragma once
/// What plan_scan.cpp can be asked for.

#include "solvers/scanning/scan_settings.hpp"

namespace gcs {

struct PlanScan {
  static constexpr std::string_view strategy = "plan-scan";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  ScanSettings scan = {};

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    ScanSettings::options(self.scan, option);
  }
  bool operator==(const PlanScan&) const = default;
};

}  // namespace gcs
