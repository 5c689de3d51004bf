#pragma once
/// What all equations together say of a box: linear relaxations and linear programming.
///
/// On a box, the product of two forms differs from a linear function by an interval: with the middles l, r and
/// radii ρ, σ of the forms' values, left·right ∈ r·left + l·right − l r + [−ρσ, ρσ], and a square lies in
/// 2 l·form − l² + [0, ρ²]: between its tangent and the chord that is parallel to it. So each equation is a
/// slab in which all solutions lie, and the least and the largest value of an unknown in all slabs and in the
/// box are linear programs. This is the way of CuikSuite (Porta, Ros, Thomas, A linear relaxation technique
/// for the position analysis of multiloop linkages, 2009; Porta, Ros, Thomas, Corcho, Cantó, Pérez, Complete
/// maps of molecular-loop conformational spaces, 2007).
///
/// The programs are solved in doubles, and what they find is proven by their multipliers alone: for any y,
/// z_j = Σ y_e s_e + (e_j − Aᵀy)·z, and intervals for the slabs s and for z give one for z_j, all rounding
/// enclosed (Neumaier, Shcherbina, Safe bounds in linear and mixed-integer linear programming, 2004).

#include <vector>

#include "solvers/certificates/interval_equations.hpp"

namespace gcs {

struct LinearWork {
  std::int64_t programs = 0;
  std::int64_t pivots = 0;
};

/// Narrows the box to what the relaxation leaves; false where that is proven to be nothing. `forms` holds the
/// values of the forms at all solutions in the box.
bool narrow_linearly(const IntervalEquations& system, const std::vector<Interval>& forms, IntervalBox& box,
                     LinearWork& work);

}  // namespace gcs
