#pragma once
/// The trace test (trace_test.hpp) for general scenes: A are the values of the constraints, V is 0 for all other
/// coefficients. E and φ are combinations of products x_a·x_b that no change of signs alters, and of unknowns whose signs
/// stay: where x escapes at a finite s both grow alike, and at s = ∞ φ = O(s·E) since E grows no slower than 1.

#include "solvers/homotopies/general_family.hpp"
#include "solvers/homotopies/trace_test.hpp"

namespace gcs {

/// Adds to `work`.
TraceTest test_trace(const GeneralEquations& equations, const TrackingSetup& setup,
                     const MonodromyOptions& options, std::mt19937_64& random,
                     const std::function<bool()>& stopped, const std::function<void(int)>& progress,
                     WorkCounters& work);

}  // namespace gcs
