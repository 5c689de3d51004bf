#pragma once
/// What rcp.cpp can be asked for.

#include "solvers/tracking/path_settings.hpp"

namespace gcs {

struct Rcp {
  enum class Mode { fast, paper };
  enum class Measure { guarded, published };
  enum class Derivatives { partial, whole };

  static constexpr std::string_view strategy = "rcp";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Mode mode = Mode::fast;
  PathSettings tracking = {};
  double alpha = 0.1;
  Measure measure = Measure::guarded;
  bool swap = true;
  Derivatives derivatives = Derivatives::partial;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("mode", self.mode, OneOf<Mode>{"fast|paper"},
           "fast: Taylor series in arc length; paper: Euler-Newton as published",
           OptionTraits{.hint = "certified: only full-space has it: the proof needs all coordinates, and a "
                                "plan's figure is known at its driving parameters only"});
    PathSettings::options(self.tracking, option,
                          "largest step; auto: 1 (fast, in units of the scene; further than 10 away a "
                          "tenth of that), 0.05 (paper, in the file's unit)");
    option("alpha", self.alpha, Range{1e-6, 0.49}, "the plan is changed when a measure falls to this");
    option("measure", self.measure, OneOf<Measure>{"guarded|published"},
           "published: γ alone; guarded: also the angle of intersection");
    option("swap", self.swap, OnOff{}, "off: keep the first plan and change the branch at a boundary");
    option("derivatives", self.derivatives, OneOf<Derivatives>{"partial|whole"},
           "mode=paper: by evaluating the plan from where a parameter matters, or all of it");
  }
  bool operator==(const Rcp&) const = default;
};

}  // namespace gcs
