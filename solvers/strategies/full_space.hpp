#pragma once
/// What full_space.cpp can be asked for.

#include "solvers/tracking/path_settings.hpp"

namespace gcs {

struct FullSpace {
  enum class Mode { fast, paper, certified, newton };
  enum class Jumps { ignored, named };

  static constexpr std::string_view strategy = "full-space";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Mode mode = Mode::fast;
  PathSettings tracking = {};
  Jumps jumps = Jumps::ignored;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("mode", self.mode, OneOf<Mode>{"fast|paper|certified|newton"},
           "fast: Taylor series in arc length; paper: Euler-Newton as published; certified: a chain of "
           "tubes, each proven to hold one arc of S; newton: no path, Newton's method from the sketch");
    PathSettings::options(self.tracking, option,
                          "largest step; auto: 1 (fast and certified, in units of the scene; further than "
                          "10 away a tenth of that), 0.1 (paper, in the file's unit)");
    option("jumps", self.jumps, OneOf<Jumps>{"ignored|named"},
           "named (paper): says where the tracker left the path, which is then proven too");
  }
  bool operator==(const FullSpace&) const = default;
};

}  // namespace gcs
