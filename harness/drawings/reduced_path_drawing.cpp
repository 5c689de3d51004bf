#include "harness/drawings/reduced_path_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/drawings/configurations_drawing.hpp"
#include "harness/drawings/path_drawing.hpp"
#include "harness/drawings/svg_plot.hpp"

namespace gcs {
namespace {

/// Two rows of figures.
constexpr std::size_t most_configurations = 6;

std::string letter(std::size_t i) { return std::string(1, static_cast<char>('a' + i % 26)); }

/// Labels and figures for the first places; more would not be legible.
std::string heading(std::size_t i, double t) { return fmt::format("({}) t = {:.3f}", letter(i), t); }

Plot empty_plot(const StoredScene& scene, const ReducedPath& reduced, std::string description) {
  const ProblemStatement& problem = scene.record.instance.problem;
  const auto name = [&](int point) { return problem.points[static_cast<std::size_t>(point)]; };
  const auto [low, high] = std::minmax_element(reduced.k.begin(), reduced.k.end());
  double least = 0, most = 1;
  for (const PathCorner& corner : scene.path->corners) {
    least = std::min(least, corner.t);
    most = std::max(most, corner.t);
  }
  Plot plot;
  plot.description = std::move(description);
  plot.x = axis_over(fmt::format("k = |{} {}′| (unit of the lengths)", name(reduced.driven_place),
                                 name(reduced.driven_from)),
                     *low, *high);
  plot.y = axis_over("t", least, most);
  plot.series = {{"", PlotMark::line, {{plot.x.low, 1}, {plot.x.high, 1}}}};
  return plot;
}

/// Pieces of S on which `style_of(corner)` is the same, each up to where the next one begins;
/// a label the first time.
template <typename StyleOf>
std::vector<PlotSeries> pieces(const StoredPath& path, const ReducedPath& reduced, StyleOf style_of) {
  std::vector<PlotSeries> series;
  std::set<std::string> named;
  for (std::size_t i = 0; i < path.corners.size(); ++i) {
    const PlotSeries style = style_of(i);
    const PlotPoint place{reduced.k[i], path.corners[i].t};
    if (series.empty() || series.back().style != style.style || series.back().mark != style.mark) {
      if (!series.empty()) series.back().points.push_back(place);
      series.push_back(style);
      if (!named.insert(style.label).second) series.back().label.clear();
    }
    series.back().points.push_back(place);
  }
  return series;
}

PlotSeries crossings(const StoredPath& path, const ReducedPath& reduced) {
  PlotSeries series{"t = 1: solutions", PlotMark::circle, {}};
  for (const PathCrossingCorner& crossing : path.crossings)
    series.points.push_back({reduced.k[crossing.corner], path.corners[crossing.corner].t});
  return series;
}

// ---- Figure 5

std::string branch_plot(const StoredScene& scene, const ReducedPath& reduced) {
  std::vector<std::string> branches;
  for (const std::string& branch : reduced.branches)
    if (std::find(branches.begin(), branches.end(), branch) == branches.end()) branches.push_back(branch);
  Plot plot =
      empty_plot(scene, reduced,
                 fmt::format("Reduced paths of {}: t over the driving parameter, one colour for each branch "
                             "of the first construction plan",
                             scene.record.instance.id));
  for (PlotSeries& piece : pieces(*scene.path, reduced, [&](std::size_t i) {
         const auto found = std::find(branches.begin(), branches.end(), reduced.branches[i]);
         return PlotSeries{"branch " + reduced.branches[i],
                           PlotMark::curve,
                           {},
                           static_cast<int>(found - branches.begin())};
       }))
    plot.series.push_back(std::move(piece));
  constexpr int black = 6;
  PlotSeries boundaries{"circles touch", PlotMark::symbol, {}, black};
  for (std::size_t i = 0; i < reduced.boundaries.size(); ++i) {
    const BoundaryPlace& place = reduced.boundaries[i];
    boundaries.points.push_back({place.k, place.t});
    if (i < most_configurations) plot.labels.push_back({{place.k, place.t}, "(" + letter(i) + ")"});
  }
  plot.series.push_back(std::move(boundaries));
  plot.series.push_back(crossings(*scene.path, reduced));
  return to_svg(plot);
}

Configuration touching_circles(const Scene& scene, const ReducedPath& reduced, std::size_t i) {
  const BoundaryPlace& place = reduced.boundaries[i];
  const Instruction& instruction = reduced.plan.instructions()[place.instruction];
  Configuration shown{
      heading(i, place.t), place.figure, {reduced.plan.removed().begin(), reduced.plan.removed().end()}, {}};
  const Eigen::Matrix3Xd points = scene.in_scene_unit(place.figure).points;
  const double unit = std::ldexp(1.0, scene.unit_exponent());
  for (int s = 0; s < instruction.count; ++s) {
    const Eigen::Vector3d centre = center_of(instruction.spheres[static_cast<std::size_t>(s)], points);
    shown.circles.push_back(
        {unit * centre.head<2>(), unit * (points.col(instruction.place) - centre).norm()});
  }
  return shown;
}

std::string boundary_figures(const StoredScene& stored, const ReducedPath& reduced) {
  const Scene scene = stored.record.instance;
  std::vector<Configuration> shown;
  for (std::size_t i = 0; i < std::min(reduced.boundaries.size(), most_configurations); ++i)
    shown.push_back(touching_circles(scene, reduced, i));
  return configurations_svg(
      stored.record.instance.problem, shown,
      "Figures at which two circles of the plan touch; dashed arrows: constraints removed");
}

// ---- Figure 6

std::set<int> numbers_of(const ProblemStatement& problem, const std::vector<std::string>& ids) {
  std::set<int> numbers;
  for (std::size_t c = 0; c < problem.constraints.size(); ++c)
    if (std::find(ids.begin(), ids.end(), problem.constraints[c].id) != ids.end())
      numbers.insert(static_cast<int>(c));
  return numbers;
}

std::string change_plot(const StoredScene& scene, const ReducedPath& reduced, const PlanTrail& trail) {
  const StoredPath& path = *scene.path;
  Plot plot = empty_plot(
      scene, reduced,
      fmt::format("The path of {} as {} follows it: solid with the first plan, dashed with others, "
                  "as its first plan would see it",
                  scene.record.instance.id, trail.label));
  const auto is_first_plan = [&](std::size_t corner) {
    const PlanPlace* current = &trail.places.front();
    for (const PlanPlace& place : trail.places)
      if (place.length <= path.corners[corner].length) current = &place;
    return current->removed == trail.places.front().removed;
  };
  for (PlotSeries& piece : pieces(path, reduced, [&](std::size_t i) {
         return is_first_plan(i) ? PlotSeries{"followed with the first plan", PlotMark::curve, {}}
                                 : PlotSeries{"with another one", PlotMark::line, {}};
       }))
    plot.series.push_back(std::move(piece));
  constexpr int green_triangle = 2;
  PlotSeries changes{"plan changed", PlotMark::symbol, {}, green_triangle};
  for (std::size_t i = 1; i < trail.places.size(); ++i) {
    const PathPosition position = position_at(path, trail.places[i].length);
    const PlotPoint place{position.between(reduced.k), trail.places[i].t};
    changes.points.push_back(place);
    if (i <= most_configurations) plot.labels.push_back({place, "(" + letter(i - 1) + ")"});
  }
  plot.series.push_back(std::move(changes));
  plot.series.push_back(crossings(path, reduced));
  return to_svg(plot);
}

std::string change_figures(const StoredScene& scene, const PlanTrail& trail) {
  const ProblemStatement& problem = scene.record.instance.problem;
  std::vector<Configuration> shown;
  for (std::size_t i = 1; i < std::min(trail.places.size(), most_configurations + 1); ++i) {
    const PlanPlace& place = trail.places[i];
    shown.push_back({heading(i - 1, place.t),
                     figure_at(*scene.path, position_at(*scene.path, place.length)),
                     numbers_of(problem, place.removed),
                     {}});
  }
  return configurations_svg(problem, shown,
                            "Figures at which the plan is changed; dashed arrows: constraints removed");
}

}  // namespace

std::vector<Drawing> draw_reduced_path(const StoredScene& scene) {
  const auto reduced = reduced_path(scene);
  if (!reduced || reduced->boundaries.empty()) return {};
  const std::string id = scene.record.instance.id;
  std::vector<Drawing> drawings{{"reduced-" + id, branch_plot(scene, *reduced),
                                 "t over the driving parameter of the first construction plan (after Figure "
                                 "5 of Imbach, Mathis, Schreck 2016). "
                                 "A branch ends where two circles of the plan touch: black triangles."},
                                {"reduced-" + id + "-figures", boundary_figures(scene, *reduced),
                                 "The figures at these places. Dashed: the circles that touch, and, as an "
                                 "arrow, the constraint that the plan "
                                 "leaves out."}};
  const PlanTrail* trail = shown_trail(scene.record);
  if (trail == nullptr || trail->places.size() < 2) return drawings;
  drawings.push_back(
      {"changes-" + id, change_plot(scene, *reduced, *trail),
       "The same path as " + trail->label +
           " follows it, which changes the plan on the way (after Figure 6). Dashed: with another "
           "plan, seen as the first one would."});
  drawings.push_back(
      {"changes-" + id + "-figures", change_figures(scene, *trail),
       "The figures at which the plan is changed; arrows: the constraints left out from there on."});
  return drawings;
}

}  // namespace gcs
