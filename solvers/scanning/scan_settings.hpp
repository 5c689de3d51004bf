#pragma once
/// What a scan of a plan is asked for, the same for every strategy that scans.

#include "solvers/interface/options.hpp"

namespace gcs {

struct ScanSettings {
  std::int64_t max_cells = 100'000'000;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor& option) {
    option("max_cells", self.max_cells, Range<std::int64_t>{1, 1'000'000'000'000},
           "cells after which the scan gives up");
  }
  bool operator==(const ScanSettings&) const = default;
};

}  // namespace gcs
