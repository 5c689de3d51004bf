#include "solvers/tracking/proven_path.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {

std::vector<PathNode> polyline(const std::vector<ProvenArc>& arcs) {
  std::vector<PathNode> nodes;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const ProvenArc &arc = arcs[i], &next = arcs[(i + 1) % arcs.size()];
    const double extent = arc.last - arc.first;
    PathNode node{{}, arc.start, arc.turn * extent * extent / 8 + 2 * arc.radius + next.radius};
    arc.curve.evaluate(arc.first, node.point);
    nodes.push_back(node);
  }
  if (!nodes.empty()) {
    nodes.push_back(nodes.front());
    nodes.back().length = arcs.back().start + (arcs.back().last - arcs.back().first);
  }
  return nodes;
}

/// Newton's method for the foot of the perpendicular.
std::optional<double> PathPlaces::on_arc(std::size_t index, const Eigen::VectorXd& point) const {
  const ProvenArc& arc = arcs_[index];
  const double extent = arc.last - arc.first;
  if ((point - arc.curve.coefficient(0)).norm() > 2 * extent) return std::nullopt;
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
