#pragma once
/// The options that full-space and rcp share, and their reading.

#include <string>
#include <vector>

#include "solvers/interface/options.hpp"
#include "solvers/tracking/euler_newton_tracker.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace gcs {

enum class PathMode { fast, paper, certified };

struct PathOptions {
  PathMode mode = PathMode::fast;
  SeriesTrackerOptions fast;
  EulerNewtonOptions paper;
};

/// The modes that a strategy has, in the order of PathMode.
inline constexpr std::string_view uncertified_modes = "fast|paper";
inline constexpr std::string_view all_modes = "fast|paper|certified";

/// `modes`: one of the two above; `paper_step_max`: what [I] states for δmax, in words of the option's text.
std::vector<OptionSpec> path_option_specs(std::string_view modes, std::string_view paper_step_max);

/// Steps and orders of the fast mode, and steps of the paper's.
std::vector<OptionMap> path_accuracy_settings();

/// Throws OptionError.
PathOptions read_path_options(const OptionMap& options, std::string_view modes, double paper_step_max);

}  // namespace gcs
