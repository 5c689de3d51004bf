#include "solvers/proven_paths/proven_path.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// The part of the wanted radius that chords of an arc may take before corners are dropped: the more corners
/// there are to choose from, the more of the radius serves to drop them.
constexpr double chord_part = 1.0 / 32;

struct CornerPlace {
  double s = 0;
  int crossing = 0;
};

/// Both ends of the arc, its crossings, and between them equal steps so short that c leaves its chords by at
/// most `sag`: |c(s) − chord| ≤ max |c''| · step²/8.
std::vector<CornerPlace> corner_places(const ProvenArc& arc, double sag) {
  std::vector<CornerPlace> places{{arc.first, 0}};
  const auto go_to = [&](const CornerPlace& end) {
    const double from = places.back().s, way = end.s - from;
    const double steps = std::ceil(way * std::sqrt(arc.turn / (8 * sag)));
    for (int i = 1; i < steps; ++i) places.push_back({from + i / steps * way, 0});
    places.push_back(end);
  };
  for (const TubeCrossing& crossing : arc.crossings) go_to({crossing.s, crossing.direction});
  go_to({arc.last, 0});
  return places;
}

/// The corners of an arc. The last one is left to the next arc, whose first corner is near it.
std::vector<PathNode> corners(const ProvenArc& arc, const ProvenArc& next, double sag) {
  const std::vector<CornerPlace> places = corner_places(arc, sag);
  std::vector<PathNode> nodes;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double s = places[i].s, step = places[i + 1].s - s;
    PathNode node{{},
                  arc.start + (s - arc.first),
                  (arc.turn * step * step / 8 + arc.radius) * round_up,
                  places[i].crossing};
    arc.curve.evaluate(s, node.point);
    nodes.push_back(std::move(node));
  }
  Eigen::VectorXd end, begin;
  arc.curve.evaluate(arc.last, end);
  next.curve.evaluate(next.first, begin);
  nodes.back().radius = (nodes.back().radius + (end - begin).norm()) * round_up;
  return nodes;
}

/// An upper bound on the distance of a point from the segment between two others. The nearest point of the
/// segment need not be met: any one bounds the distance.
double distance_bound(const Eigen::VectorXd& point, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::VectorXd chord = b - a, offset = point - a;
  const double square = chord.squaredNorm();
  const double along = square > 0 ? std::clamp(offset.dot(chord) / square, 0.0, 1.0) : 0;
  const double rounding = 4 * epsilon * (offset.norm() + chord.norm());
  return ((offset - along * chord).norm() + rounding) * round_up;
}

/// A bound on the distance of the part of S between two corners from the segment between them: the distance
/// from a segment is convex, so that on the chords in between it is largest at a corner.
double segment_radius(const std::vector<PathNode>& nodes, std::size_t first, std::size_t last) {
  double radius = nodes[first].radius, before = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double here = distance_bound(nodes[i].point, nodes[first].point, nodes[last].point);
    radius = std::max({radius, nodes[i - 1].radius + std::max(before, here), nodes[i].radius + here});
    before = here;
  }
  return last == first + 1 ? radius : radius * round_up;
}

/// A far corner that one segment from `first` reaches within the radius: twice as far as long as that holds,
/// then by halves.
std::size_t furthest(const std::vector<PathNode>& nodes, std::size_t first, double within) {
  std::size_t reached = first + 1, step = 1;
  const auto reaches = [&](std::size_t last) {
    return last < nodes.size() && segment_radius(nodes, first, last) <= within;
  };
  for (; reaches(reached + step); step *= 2) reached += step;
  for (; step > 0; step /= 2)
    if (reaches(reached + step)) reached += step;
  return reached;
}

/// Moves `nodes` to `kept`, all but the last one, without those that the radius allows to drop.
void thin_out(std::vector<PathNode>& nodes, double within, std::vector<PathNode>& kept) {
  for (std::size_t first = 0; first + 1 < nodes.size();) {
    const std::size_t last = furthest(nodes, first, within);
    kept.push_back(nodes[first]);
    kept.back().radius = segment_radius(nodes, first, last);
    first = last;
  }
  nodes.erase(nodes.begin(), nodes.end() - 1);
}

}  // namespace

std::vector<PathNode> polyline(const std::vector<ProvenArc>& arcs, double within) {
  std::vector<PathNode> kept, waiting;
  for (std::size_t i = 0; i < arcs.size(); ++i)
    for (PathNode& node : corners(arcs[i], arcs[(i + 1) % arcs.size()], chord_part * within)) {
      const bool stays = node.crossing != 0;
      waiting.push_back(std::move(node));
      if (stays) thin_out(waiting, within, kept);
    }
  if (waiting.empty()) return kept;
  const ProvenArc& last = arcs.back();
  waiting.push_back({kept.empty() ? waiting.front().point : kept.front().point,
                     last.start + (last.last - last.first), 0, 0});
  thin_out(waiting, within, kept);
  kept.push_back(waiting.front());
  return kept;
}

/// Newton's method for the foot of the perpendicular.
std::optional<double> PathPlaces::on_arc(std::size_t index, const Eigen::VectorXd& point) const {
  const ProvenArc& arc = arcs_[index];
  const double reach = std::max(std::abs(arc.first), std::abs(arc.last));
  if ((point - arc.curve.coefficient(0)).norm() > 2 * reach + arc.radius + tolerance_) return std::nullopt;
  double s =
      std::clamp((point - arc.curve.coefficient(0)).dot(arc.curve.coefficient(1)), arc.first, arc.last);
  Eigen::VectorXd here, direction;
  for (int i = 0; i < 6; ++i) {
    arc.curve.evaluate(s, here);
    arc.curve.tangent(s, direction);
    s = std::clamp(s + (point - here).dot(direction), arc.first - tolerance_, arc.last + tolerance_);
  }
  arc.curve.evaluate(s, here);
  if ((point - here).norm() > arc.radius + tolerance_) return std::nullopt;
  return arc.start + (s - arc.first);
}

std::optional<double> PathPlaces::find(const Eigen::VectorXd& point) {
  const std::size_t count = arcs_.size();
  for (std::size_t i = 0; i < count; ++i) {
    // 0, 1, −1, 2, −2, …
    const std::size_t away = (i + 1) / 2, index = (last_ + (i % 2 == 1 ? away : count - away)) % count;
    if (const auto place = on_arc(index, point)) {
      last_ = index;
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace gcs
