#pragma once
/// Algorithms 2 and 3 of [I]: which instructions are too near to a boundary configuration, and what they
/// become.

#include "solvers/construction/plan.hpp"

namespace gcs {

struct ExchangeRule {
  double alpha = 0.1;      ///< an instruction is changed when its measure is at most α, 0 < α < 1/2
  bool watch_sine = true;  ///< the measure is the smaller of γ and crossing_sine; false: γ alone, as in [I]
};

/// The smallest measure over the spheres of the instruction that can be exchanged, or of all instructions.
double boundary_distance(const Instruction& instruction, const ExchangeRule& rule,
                         const Eigen::Matrix3Xd& points);
double boundary_distance(const Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points);

/// Whether Algorithm 2 has to be applied: a measure is at most α, or (sc1): an exchanged interCC, interSSP or
/// interSS whose original second radius has become larger than its first one (radii are read off the figure).
bool needs_change(const Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points);

/// Algorithm 2. Restores originals that are far enough from a boundary, exchanges constraints for driving
/// parameters, and shifts reference points. The figure stays what it is. True if anything changed.
bool change_plan(Plan& plan, const ExchangeRule& rule, const Eigen::Matrix3Xd& points);

}  // namespace gcs
