#include "solvers/construction/exchange.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace gcs {
namespace {

double measure(const Instruction& instruction, int slot, const ExchangeRule& rule,
               const Eigen::Matrix3Xd& points) {
  const double gamma = boundary_measure(instruction, slot, points);
  return rule.watch_sine ? std::min(gamma, crossing_sine(instruction, slot, points)) : gamma;
}

Instruction with_original(const Instruction& instruction, int slot) {
  Instruction original = instruction;
  original.spheres[slot] = *instruction.original[slot];
  return original;
}

/// (sc1), for the one slot that has it.
bool original_radius_is_larger(const Instruction& instruction, const Eigen::Matrix3Xd& points) {
  return instruction.original[1] &&
         radius_of(with_original(instruction, 1), 1, points) > radius_of(instruction, 0, points);
}

/// Algorithms 2 to 4 at one figure.
class PlanChanger {
 public:
  PlanChanger(const ExchangeRule& rule, const Eigen::Matrix3Xd& points) : rule_(rule), points_(points) {}

  PlanChange run(Plan& plan) {
    for (Instruction& instruction : plan.instructions())
      for (int slot = 1; slot < instruction.count && !change_.undefined; ++slot)
        change_slot(instruction, slot);
    if (change_.is_any()) plan.renew_indices();
    return std::move(change_);
  }

 private:
  /// The loop body of Algorithm 2.
  void change_slot(Instruction& instruction, int slot) {
    const bool is_near = measure(instruction, slot, rule_, points_) <= rule_.alpha;
    if (!instruction.original[slot]) {
      if (!is_near) return;
      if (instruction.spheres[slot].is_driven())
        shift(instruction, slot);
      else
        exchange(instruction, slot);
      return;
    }
    if (measure(with_original(instruction, slot), slot, rule_, points_) > rule_.alpha) {
      restore(instruction, slot);
    } else if (slot == 1 && original_radius_is_larger(instruction, points_)) {
      restore(instruction, slot);
      if (!change_.undefined) exchange(instruction, slot);
    } else if (is_near) {
      shift(instruction, slot);
    }
  }

  /// Algorithm 4 for a sphere that is driven, or is to be.
  std::optional<Eigen::Vector3d> reference(const Instruction& instruction, int slot) {
    const auto shifted = shifted_reference(instruction, slot, points_, rule_.shift);
    if (!shifted)
      is_undefined(instruction, "Algorithm 4 has no direction: the point lies on the line of the centres");
    return shifted;
  }

  void take_reference(Instruction& instruction, int slot, const Eigen::Vector3d& at) {
    instruction.spheres[slot].reference = at;
    ++change_.shifts;
    if (boundary_measure(instruction, slot, points_) <= rule_.alpha) ++change_.shifts_in_vain;
  }

  void shift(Instruction& instruction, int slot) {
    if (const auto at = reference(instruction, slot)) take_reference(instruction, slot, *at);
  }

  /// Algorithm 3, first half: the constraint of sphere `slot` leaves the plan and a driving parameter takes
  /// its place.
  void exchange(Instruction& instruction, int slot) {
    Instruction exchanged = instruction;
    if (slot == 1 && radius_of(exchanged, 0, points_) < radius_of(exchanged, 1, points_))
      std::swap(exchanged.spheres[0], exchanged.spheres[1]);
    const auto at = reference(exchanged, slot);
    if (!at) return;
    exchanged.original[slot] = exchanged.spheres[slot];
    exchanged.spheres[slot].constraint = -1;
    take_reference(exchanged, slot, *at);
    instruction = exchanged;
    ++change_.exchanges;
  }

  /// Algorithm 3, second half.
  void restore(Instruction& instruction, int slot) {
    if (rule_.restores_as_printed) {
      is_undefined(
          instruction,
          "Algorithm 3 restores an instruction and takes away a driving parameter that this one does "
          "not have: the one in use stays, and H_R has an unknown more than equations");
      return;
    }
    instruction.spheres[slot] = *instruction.original[slot];
    instruction.original[slot].reset();
    ++change_.restorations;
  }

  void is_undefined(const Instruction& instruction, const std::string& why) {
    change_.undefined = {instruction.place, why};
  }

  const ExchangeRule& rule_;
  const Eigen::Matrix3Xd& points_;
  PlanChange change_;
};

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

PlanChange change_plan(Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points) {
  return PlanChanger(rule, points).run(plan);
}

}  // namespace gcs
