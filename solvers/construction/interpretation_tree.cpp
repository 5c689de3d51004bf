#include "solvers/construction/interpretation_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "solvers/construction/derive.hpp"

namespace gcs {
namespace {

using Radii = std::array<double, 3>;

/// Relative to a radius. Centres carry the rounding of all instructions before, some thousand units of roundoff
/// where these are not nearly flat; and spheres that are so near to touching meet in points within
/// √(2 · 1e-12) = 1.4e-6 of a radius of each other, which are one in any drawing.
constexpr double rounding = 1e-12;

bool chooses(const Plan& plan, const Instruction& instruction) {
  return instruction.count == plan.dimension();
}

/// Puts the plan on the branch of a figure in its frame, and reads off its driving parameters.
std::vector<double> take_branch(Plan& plan, const Eigen::Matrix3Xd& points) {
  std::vector<double> driven;
  for (Instruction& instruction : plan.instructions()) {
    instruction.side = side_of(instruction, points);
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven()) driven.push_back(radius_of(instruction, i, points));
  }
  return driven;
}

Radii radii_of(const InterpretationTree& tree, std::size_t number, const std::vector<double>& lengths) {
  const Instruction& instruction = tree.plan.instructions()[number];
  int driven = tree.plan.driven_before(number);
  Radii radii{};
  for (int i = 0; i < instruction.count; ++i) {
    const PlanSphere& sphere = instruction.spheres[i];
    radii[i] = sphere.is_driven() ? tree.driven[driven++] : lengths[sphere.constraint];
  }
  return radii;
}

/// Whether the centres leave the direction of the intersection open.
bool has_undefined_axis(const Instruction& instruction, const Radii& radii, const Eigen::Matrix3Xd& points) {
  if (instruction.count < 2) return false;
  const double size = *std::max_element(radii.begin(), radii.begin() + instruction.count);
  const Eigen::Vector3d first = center_of(instruction.spheres[0], points);
  const Eigen::Vector3d axis = (center_of(instruction.spheres[1], points) - first) / size;
  if (instruction.count == 2) return axis.norm() <= rounding;
  const Eigen::Vector3d other = (center_of(instruction.spheres[2], points) - first) / size;
  return axis.cross(other).norm() <= rounding;
}

/// The radii, and what they become when one of them is a rounding smaller or larger.
std::vector<Radii> roundings_of(const Radii& radii, int count) {
  std::vector<Radii> all{radii};
  for (int i = 0; i < count; ++i)
    for (const double factor : {1 - rounding, 1 + rounding}) {
      all.push_back(radii);
      all.back()[i] *= factor;
    }
  return all;
}

struct MetSpheres {
  Meeting meeting = Meeting::apart;
  Radii radii{};  ///< with which they meet
};

MetSpheres meet(const Plan& plan, const Instruction& instruction, const Radii& radii,
                const Eigen::Matrix3Xd& points) {
  if (has_undefined_axis(instruction, radii, points)) return {Meeting::undefined, radii};
  Eigen::Matrix3Xd placed = points;
  const std::vector<Radii> all = roundings_of(radii, instruction.count);
  std::vector<Radii> met;
  std::copy_if(all.begin(), all.end(), std::back_inserter(met),
               [&](const Radii& some) { return place(instruction, some, placed); });
  if (met.empty()) return {Meeting::apart, radii};
  if (met.size() < all.size()) return {Meeting::touching, met.front()};
  return {chooses(plan, instruction) ? Meeting::two_points : Meeting::framed, radii};
}

/// The figure with one more point, on a side of the instruction; on none: in the middle of both.
Eigen::Matrix3Xd with_point(Instruction instruction, int side, const Radii& radii, Eigen::Matrix3Xd points) {
  const auto on_side = [&](int one) -> Eigen::Vector3d {
    instruction.side = one;
    place(instruction, radii, points);
    return points.col(instruction.place);
  };
  const Eigen::Vector3d point = side == 0 ? Eigen::Vector3d((on_side(1) + on_side(-1)) / 2) : on_side(side);
  points.col(instruction.place) = point;
  return points;
}

void append_children(InterpretationTree& tree, int parent, const std::vector<double>& lengths) {
  const InterpretationNode before = tree.nodes[static_cast<std::size_t>(parent)];
  const auto number = static_cast<std::size_t>(before.instruction + 1);
  const Instruction& instruction = tree.plan.instructions()[number];
  const MetSpheres met = meet(tree.plan, instruction, radii_of(tree, number, lengths), before.points);
  InterpretationNode node = before;
  node.parent = parent;
  node.instruction = static_cast<int>(number);
  node.side = 0;
  node.meeting = met.meeting;
  if (node.has_ended()) {
    tree.nodes.push_back(node);
  } else if (met.meeting == Meeting::two_points) {
    for (const int side : {1, -1}) {
      node.side = side;
      node.is_on_branch = before.is_on_branch && side == instruction.side;
      node.points = with_point(instruction, side, met.radii, before.points);
      tree.nodes.push_back(node);
    }
  } else {
    // The sketch lies in the frame.
    const int side = met.meeting == Meeting::framed ? instruction.side : 0;
    node.points = with_point(instruction, side, met.radii, before.points);
    tree.nodes.push_back(node);
  }
}

Eigen::Matrix3Xd given_points(const Scene& scene) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, scene.point_count());
  for (int p = 0; p < scene.point_count(); ++p)
    if (const auto given = scene.fixed_point(p)) points.col(p) = *given;
  return points;
}

}  // namespace

std::vector<int> InterpretationTree::figures() const {
  const int last = static_cast<int>(plan.instructions().size()) - 1;
  std::vector<int> numbers;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].instruction == last && !nodes[i].has_ended()) numbers.push_back(static_cast<int>(i));
  return numbers;
}

int choices(const Plan& plan) {
  return static_cast<int>(
      std::count_if(plan.instructions().begin(), plan.instructions().end(),
                    [&](const Instruction& instruction) { return chooses(plan, instruction); }));
}

InterpretationTree interpretation_tree(const Scene& scene, Plan plan, const Figure& sketch,
                                       const std::vector<double>& lengths) {
  InterpretationTree tree;
  tree.driven = take_branch(plan, in_plan_frame(scene, plan, sketch).points);
  tree.plan = std::move(plan);
  InterpretationNode root;
  root.points = given_points(scene);
  tree.nodes.push_back(std::move(root));
  const int last = static_cast<int>(tree.plan.instructions().size()) - 1;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (!tree.nodes[i].has_ended() && tree.nodes[i].instruction < last)
      append_children(tree, static_cast<int>(i), lengths);
  return tree;
}

}  // namespace gcs
