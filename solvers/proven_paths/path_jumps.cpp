#include "solvers/proven_paths/path_jumps.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {
namespace {

constexpr double detour = 3;
constexpr std::size_t named = 6;

/// Along a closed path of this length, the shorter way.
double distance_along(double a, double b, double length) {
  const double way = std::abs(a - b);
  return std::min(way, length - way);
}

std::string name(const std::optional<int>& arc) {
  if (!arc) return "a curve that is not S";
  return *arc == 0 ? "the arc of S before crossing 0" : "the arc after crossing " + std::to_string(*arc - 1);
}

}  // namespace

std::vector<PathJump> find_jumps(const std::vector<Eigen::VectorXd>& points,
                                 const std::vector<ProvenArc>& arcs,
                                 const std::vector<PathCrossing>& crossings, double tolerance) {
  PathPlaces places(arcs, tolerance);
  const double length = arcs.back().start + (arcs.back().last - arcs.back().first);
  std::vector<double> crossed;
  for (const PathCrossing& crossing : crossings)
    crossed.push_back(places.find(crossing.point).value_or(length));
  const auto arc_at = [&](const std::optional<double>& place) -> std::optional<int> {
    if (!place) return std::nullopt;
    return static_cast<int>(std::upper_bound(crossed.begin(), crossed.end(), *place) - crossed.begin());
  };
  std::vector<PathJump> jumps;
  std::optional<double> here = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::optional<double> there = places.find(points[i]);
    const double step = (points[i] - points[i - 1]).norm(), t = points[i - 1][points[i - 1].size() - 1];
    const bool strayed = here.has_value() != there.has_value();
    if (strayed || (here && distance_along(*here, *there, length) > detour * step + tolerance))
      jumps.push_back({static_cast<std::int64_t>(i), t, arc_at(here), arc_at(there)});
    here = there;
  }
  return jumps;
}

std::string in_words(const std::vector<PathJump>& jumps) {
  std::string text =
      "the tracker jumped " + std::to_string(jumps.size()) + (jumps.size() == 1 ? " time" : " times");
  for (std::size_t i = 0; i < std::min(named, jumps.size()); ++i) {
    const PathJump& jump = jumps[i];
    text += (i == 0 ? ": " : "; ");
    text += "in step " + std::to_string(jump.step) + " near t = " + std::to_string(jump.t) + " from " +
            name(jump.from) + " to " + name(jump.to);
  }
  return jumps.size() > named ? text + "; and " + std::to_string(jumps.size() - named) + " more" : text;
}

}  // namespace gcs
