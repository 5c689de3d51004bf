#include "solvers/construction/exchange.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "solvers/construction/boundary.hpp"

namespace gcs {
namespace {

double measure(const Instruction& instruction, int slot, const ExchangeRule& rule,
               const Eigen::Matrix3Xd& points) {
  const double gamma = boundary_measure(instruction, slot, points);
  return rule.watch_sine ? std::min(gamma, crossing_sine(instruction, slot, points)) : gamma;
}

double radius_in(const PlanSphere& sphere, int place, const Eigen::Matrix3Xd& points) {
  return (points.col(place) - center_of(sphere, points)).norm();
}

Instruction with_original(const Instruction& instruction, int slot) {
  Instruction original = instruction;
  original.spheres[slot] = *instruction.original[slot];
  return original;
}

/// (sc1), for the one slot that has it.
bool original_radius_is_larger(const Instruction& instruction, const Eigen::Matrix3Xd& points) {
  return instruction.original[1] && radius_in(*instruction.original[1], instruction.place, points) >
                                        radius_in(instruction.spheres[0], instruction.place, points);
}

void shift(Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  instruction.spheres[slot].reference = shifted_reference(instruction, slot, points);
}

/// Algorithm 3, first half: the constraint of sphere `slot` leaves the plan and a driving parameter takes its
/// place.
void exchange(Instruction& instruction, int slot, const Eigen::Matrix3Xd& points) {
  if (slot == 1 && radius_in(instruction.spheres[0], instruction.place, points) <
                       radius_in(instruction.spheres[1], instruction.place, points))
    std::swap(instruction.spheres[0], instruction.spheres[1]);
  instruction.original[slot] = instruction.spheres[slot];
  const Eigen::Vector3d reference = shifted_reference(instruction, slot, points);
  instruction.spheres[slot].constraint = -1;
  instruction.spheres[slot].reference = reference;
}

/// Algorithm 3, second half.
void restore(Instruction& instruction, int slot) {
  instruction.spheres[slot] = *instruction.original[slot];
  instruction.original[slot].reset();
}

/// The loop body of Algorithm 2.
bool change_slot(Instruction& instruction, int slot, const ExchangeRule& rule,
                 const Eigen::Matrix3Xd& points) {
  const bool near = measure(instruction, slot, rule, points) <= rule.alpha;
  if (!instruction.original[slot]) {
    if (!near) return false;
    if (instruction.spheres[slot].is_driven())
      shift(instruction, slot, points);
    else
      exchange(instruction, slot, points);
    return true;
  }
  if (measure(with_original(instruction, slot), slot, rule, points) > rule.alpha) {
    restore(instruction, slot);
    return true;
  }
  if (slot == 1 && original_radius_is_larger(instruction, points)) {
    restore(instruction, slot);
    exchange(instruction, slot, points);
    return true;
  }
  if (near) shift(instruction, slot, points);
  return near;
}

}  // namespace

double boundary_distance(const Instruction& instruction, const ExchangeRule& rule,
                         const Eigen::Matrix3Xd& points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int slot = 1; slot < instruction.count; ++slot)
    smallest = std::min(smallest, measure(instruction, slot, rule, points));
  return smallest;
}

double boundary_distance(const Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Instruction& instruction : plan.instructions())
    smallest = std::min(smallest, boundary_distance(instruction, rule, points));
  return smallest;
}

bool needs_change(const Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points) {
  for (const Instruction& instruction : plan.instructions()) {
    if (boundary_distance(instruction, rule, points) <= rule.alpha) return true;
    if (original_radius_is_larger(instruction, points)) return true;
  }
  return false;
}

bool change_plan(Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points) {
  bool changed = false;
  for (Instruction& instruction : plan.instructions())
    for (int slot = 1; slot < instruction.count; ++slot)
      changed = change_slot(instruction, slot, rule, points) || changed;
  if (changed) plan.renew_indices();
  return changed;
}

}  // namespace gcs
