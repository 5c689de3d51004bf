#pragma once
/// The hypotheses (h2) to (h7) of [I] §3.1 and §4.3, as far as they can be told beforehand.

#include "solvers/construction/exchange.hpp"

namespace gcs {

/// How often each hypothesis fails; 0: it holds. Lengths vanish where t leaves the part of supp+(a) that holds
/// [0, 1], in which S stays: to rounding, and there alone.
struct PlanHypotheses {
  int h2 = 0;  ///< sides, of t → −∞ and t → ∞, on which that part has no end
  int h3 = 0;  ///< pairs of lengths that are one function of t, to rounding
  int h4 = 0;  ///< 1 where the length that places the plan's second point vanishes
  int h5 = 0;  ///< instructions of which two given lengths vanish at one t
  int h6 = 0;  ///< instructions with a driving parameter of which a given length vanishes
  int h7 = 0;  ///< instructions that are within α of a boundary configuration at the sketch, by γ
};

/// `sketch`: in the plan's frame and the scene's unit.
PlanHypotheses check_hypotheses(const Scene& scene, const Plan& plan, const Figure& sketch, double alpha);

}  // namespace gcs
