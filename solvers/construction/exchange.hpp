#pragma once
/// Algorithms 2 and 3 of [I]: which instructions are too near to a boundary configuration, and what they
/// become.

#include <optional>
#include <string>

#include "solvers/construction/boundary.hpp"
#include "solvers/construction/plan.hpp"

namespace gcs {

struct ExchangeRule {
  double alpha = 0.1;      ///< an instruction is changed when its measure is at most α, 0 < α < 1/2
  bool watch_sine = true;  ///< the measure is the smaller of γ and crossing_sine; false: γ alone, as in [I]
  ShiftRule shift = {};
  /// Algorithm 3's second branch takes the driving parameter a'_i4 and the reference p'_i3 of the instruction
  /// restored away. That instruction has none: those of the current one stay, without an equation. False:
  /// those of the current one leave.
  bool restores_as_printed = false;
};

/// What Algorithm 2 did.
struct PlanChange {
  int exchanges = 0;
  int restorations = 0;
  int shifts = 0;          ///< by Algorithm 4, those of the exchanges included
  int shifts_in_vain = 0;  ///< that left γ at α or below, against Proposition 2
  /// What the printed text does not define, and the point that the instruction places, which stays as it was.
  struct Undefined {
    int place = 0;
    std::string why;
  };
  std::optional<Undefined> undefined = {};

  bool is_any() const { return exchanges + restorations + shifts > 0; }
};

/// The smallest measure over the spheres of the instruction that can be exchanged, or of all instructions.
double boundary_distance(const Instruction& instruction, const ExchangeRule& rule,
                         const Eigen::Matrix3Xd& points);
double boundary_distance(const Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points);

/// Whether Algorithm 2 has to be applied: a measure is at most α, or (sc1): an exchanged interCC, interSSP or
/// interSS whose original second radius has become larger than its first one (radii are read off the figure).
bool needs_change(const Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points);

/// Algorithm 2. Restores originals that are far enough from a boundary, exchanges constraints for driving
/// parameters, and shifts reference points. The figure stays what it is.
PlanChange change_plan(Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points);

}  // namespace gcs
