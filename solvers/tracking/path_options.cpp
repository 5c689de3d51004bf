#include "solvers/tracking/path_options.hpp"

namespace gcs {
namespace {

constexpr std::string_view modes_in_words =
    "fast: Taylor series in arc length; paper: Euler-Newton as published";
constexpr std::string_view all_modes_in_words =
    "fast: Taylor series in arc length; paper: Euler-Newton as published; certified: a chain of tubes, each "
    "proven to hold one arc of S";

PathMode read_mode(const OptionMap& options, std::string_view modes) {
  const int choice = choice_option(options, "mode", all_modes);
  if (choice >= 2 && modes != all_modes)
    throw OptionError(
        "option mode=certified: only full-space has it: the proof needs all coordinates, and a plan's figure "
        "is "
        "known at its driving parameters only");
  return static_cast<PathMode>(choice);
}

}  // namespace

std::vector<OptionSpec> path_option_specs(std::string_view modes, std::string_view paper_step_max) {
  const SeriesTrackerOptions defaults;
  return {
      {"mode", "fast", modes, modes == all_modes ? all_modes_in_words : modes_in_words},
      {"step_max", "auto", "auto, or a number from 1e-6 to 1e6",
       paper_step_max == "0.1" ? "largest step; auto: 1 (fast and certified, in units of the scene; further "
                                 "than 10 away a tenth of "
                                 "that), 0.1 (paper, in the file's unit)"
                               : "largest step; auto: 1 (fast, in units of the scene; further than 10 away a "
                                 "tenth of that), 0.05 "
                                 "(paper, in the file's unit)"},
      {"max_steps", std::to_string(defaults.max_steps), "a whole number from 1 to 1000000000",
       "the tracker gives up after so many steps"},
      {"orientation", "forward", "forward|backward", "leave the sketch towards growing or falling t"},
      {"order", std::to_string(defaults.order), "a whole number from 4 to 40",
       "order of the series (fast, certified)"},
      {"tolerance", "1e-7", "a number from 1e-14 to 1e-5",
       "size of the last terms of the series, in units of the scene (fast, certified)"},
  };
}

std::vector<OptionMap> path_accuracy_settings() {
  return {{{"tolerance", "1e-5"}},  {{"tolerance", "1e-9"}},
          {{"tolerance", "1e-11"}}, {{"tolerance", "1e-13"}},
          {{"order", "8"}},         {{"order", "16"}},
          {{"order", "24"}},        {{"step_max", "0.25"}},
          {{"step_max", "0.0625"}}, {{"mode", "paper"}, {"step_max", "0.2"}},
          {{"mode", "paper"}},      {{"mode", "paper"}, {"step_max", "0.025"}}};
}

PathOptions read_path_options(const OptionMap& options, std::string_view modes, double paper_step_max) {
  PathOptions path;
  path.mode = read_mode(options, modes);
  if (options.find("step_max")->second == "auto") {
    path.paper.step_max = paper_step_max;
    path.fast.step_max_far = 0.1;
  } else {
    path.fast.step_max = path.paper.step_max = number_option(options, "step_max", 1e-6, 1e6);
  }
  path.fast.max_steps = path.paper.max_steps = integer_option(options, "max_steps", 1, 1'000'000'000);
  path.fast.orientation = path.paper.orientation =
      choice_option(options, "orientation", "forward|backward") == 0 ? 1 : -1;
  path.fast.order = static_cast<int>(integer_option(options, "order", 4, 40));
  path.fast.tolerance = number_option(options, "tolerance", 1e-14, 1e-5);
  return path;
}

}  // namespace gcs
