#pragma once
/// The equations of S as sums of products of affine forms, with coefficients that are known up to their errors.
///
///   f_e(X, t) = ½ Σ V·D − g_e(t),
///
/// over pairs (V, D) of forms in X in which V and D may be exchanged. So df_e = Σ V·dD − g_e' dt. A squared distance is
/// the sum of the pairs (Δ, Δ) of differences of coordinates, a product L·R those of (L, R) and (R, L).

#include <Eigen/Core>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tracking/general_curve.hpp"

namespace gcs {

/// Σ coefficient·y + constant for all coefficients and constants within their errors.
struct EnclosedForm {
  struct Term {
    Eigen::Index coordinate = 0;
    double coefficient = 1;
    double error = 0;
  };
  std::vector<Term> terms;
  double constant = 0;
  double constant_error = 0;

  /// A coordinate or a difference of two, or their negatives: no rounding but one of the result.
  bool is_difference() const;
};

struct FormPair {
  Eigen::Index equation = 0;
  Eigen::Index value = 0, moved = 0;  ///< numbers of V and D
};

/// As many equations as unknowns; the last coordinate is t, which no form has.
struct PathEquations {
  Eigen::Index count = 0;
  std::vector<EnclosedForm> forms;
  std::vector<FormPair> pairs;

  Eigen::Index coordinates() const { return count + 1; }
};

/// Half the squared distances. Form axis · edges + edge is the difference of an edge's ends along an axis.
PathEquations distance_equations(const DistanceSystem& system);

/// Those of a GeneralFamily with these values, of which g is a(t), or half its square where it is not plain.
PathEquations general_equations(const SceneSystem& system, const std::vector<TravellingValue>& values);

/// Half of every sum of these equations, of which g is half of what is given.
PathEquations released_equations(const QuadraticSystem& system);

}  // namespace gcs
