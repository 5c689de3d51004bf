#pragma once
/// How the paths of a solve ended, those alike counted together.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Paths whose ends are alike; the fields mean what they mean in PathRecord.
struct PathEnds {
  PathRecord::End end = PathRecord::End::failed;
  int winding_number = 0;
  int pole_order = 0;
  bool proven = false;
  std::string cause;
  std::uint64_t paths = 0;
};

/// Every path is counted once; in a fixed order.
std::vector<PathEnds> ends_of(const std::vector<PathRecord>& paths);

/// The word of gcsbench-result/1: "closed", …, "at infinity".
std::string_view word(PathRecord::End end);

/// A positive fraction in lowest terms.
struct Exponent {
  int numerator = 1;
  int denominator = 1;

  bool operator<(const Exponent& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
};

/// k/w of ends at infinity like (1 − t)^(−k/w); nothing for others, and where it is not determined.
std::optional<Exponent> exponent(const PathEnds& ends);

}  // namespace gcs
