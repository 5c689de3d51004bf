#include "solvers/tracking/path_options.hpp"

namespace gcs {

std::vector<OptionMap> path_accuracy_settings() {
  return {{{"tolerance", "1e-5"}},  {{"tolerance", "1e-9"}},
          {{"tolerance", "1e-11"}}, {{"tolerance", "1e-13"}},
          {{"order", "8"}},         {{"order", "16"}},
          {{"order", "24"}},        {{"step_max", "0.25"}},
          {{"step_max", "0.0625"}}, {{"mode", "paper"}, {"step_max", "0.2"}},
          {{"mode", "paper"}},      {{"mode", "paper"}, {"step_max", "0.025"}}};
}

PathOptions path_options(const PathSettings& settings, double paper_step_max) {
  PathOptions path;
  path.paper.step_max = settings.step_max.value_or(paper_step_max);
  if (settings.step_max)
    path.fast.step_max = *settings.step_max;
  else
    path.fast.step_max_far = 0.1;
  path.fast.max_steps = path.paper.max_steps = settings.max_steps;
  path.fast.orientation = path.paper.orientation =
      settings.orientation == PathSettings::Orientation::forward ? 1 : -1;
  path.fast.stops_at_first = path.paper.stops_at_first = settings.until == PathSettings::Until::first;
  path.fast.order = settings.order;
  path.fast.tolerance = settings.tolerance;
  return path;
}

PathOptions for_scene(PathOptions path, const Scene& scene) {
  path.fast.far = path.paper.far = times_far_away(scene.length_paths());
  return path;
}

}  // namespace gcs
