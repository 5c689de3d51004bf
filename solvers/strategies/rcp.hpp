#pragma once
/// What rcp.cpp can be asked for.

#include "solvers/tracking/path_settings.hpp"

namespace gcs {

struct Rcp {
  enum class Mode { fast, paper, newton };
  enum class Text { mended, printed };
  enum class Choice { as, mended, printed };
  enum class Derivatives { partial, whole };

  static constexpr std::string_view strategy = "rcp";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Mode mode = Mode::fast;
  PathSettings tracking = {};
  double alpha = 0.1;
  Text as = Text::mended;
  Choice measure = Choice::as;
  Choice shift = Choice::as;
  Choice direction = Choice::as;
  Choice restoring = Choice::as;
  Choice turning = Choice::as;
  bool swap = true;
  Derivatives derivatives = Derivatives::partial;

  /// Whether the printed text is followed where `choice` speaks of it.
  bool is_printed(Choice choice) const {
    return choice == Choice::as ? as == Text::printed : choice == Choice::printed;
  }

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    constexpr OneOf<Choice> choice{"as|mended|printed"};
    option("mode", self.mode, OneOf<Mode>{"fast|paper|newton"},
           "fast: Taylor series in arc length; paper: Euler-Newton as published; newton: no path, Newton's "
           "method in the driving parameters from the sketch",
           OptionTraits{.hint = "certified: only full-space has it: the proof needs all coordinates, and a "
                                "plan's figure is known at its driving parameters only"});
    PathSettings::options(self.tracking, option,
                          "largest step; auto: 1 (fast, in units of the scene; further than 10 away a "
                          "tenth of that), 0.05 (paper, in the file's unit)");
    option("alpha", self.alpha, Range{1e-6, 0.49}, "the plan is changed when a measure falls to this");
    option("as", self.as, OneOf<Text>{"mended|printed"},
           "printed (paper): Algorithms 1 to 4 to the letter, where the five options below say \"as\"");
    option("measure", self.measure, choice, "printed: γ alone; mended: also the angle of intersection");
    option("shift", self.shift, choice,
           "Algorithm 4, a sphere and a circle; printed: to the larger radius; mended: to the circle's");
    option("direction", self.direction, choice,
           "Algorithm 4; printed: towards the projection; mended: elsewhere where that is undefined or flat");
    option(
        "restoring", self.restoring, choice,
        "Algorithm 3; printed: which parameter leaves is wrong, and the path ends; mended: the current one");
    option("turning", self.turning, choice,
           "after a change; printed: by the derivative of the change; mended: by the last step");
    option("swap", self.swap, OnOff{}, "off: keep the first plan and change the branch at a boundary");
    option("derivatives", self.derivatives, OneOf<Derivatives>{"partial|whole"},
           "mode=paper: by evaluating the plan from where a parameter matters, or all of it");
  }
  bool operator==(const Rcp&) const = default;
};

}  // namespace gcs
