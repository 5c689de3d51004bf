#pragma once
/// What newton_multistart.cpp can be asked for.

#include "solvers/interface/options.hpp"

namespace gcs {

struct NewtonMultistart {
  static constexpr std::string_view strategy = "newton-multistart";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  int starts = 1000;
  double unseen = 0.5;  ///< classes

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("starts", self.starts, Range{1, 100'000'000}, "starts at most");
    option("unseen", self.unseen, Range{0.0, 1e9},
           "stop when fewer classes than this are expected to be unseen, by estimate; 0: make all starts");
  }
  bool operator==(const NewtonMultistart&) const = default;
};

}  // namespace gcs
