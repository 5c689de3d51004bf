#pragma once
/// Gaussian elimination of a sparse Jacobian in an order that is fixed beforehand, so that many Jacobians of
/// the same pattern are factorised at once, one per SIMD lane, without pivoting.
///
/// The order is Markowitz's (least fill first) among the pivots that are not small beside their row at any of
/// several random placements. At a placement where a pivot happens to be small the factorisation is inexact;
/// Newton's method tells, and shortens the step or gives the path to a tracker that pivots.

#include <random>
#include <vector>

#include "solvers/lanes/monomial_system.hpp"
#include "solvers/lanes/square_system.hpp"

namespace gcs {

/// Stored entries are numbered; L without its unit diagonal and U share the storage of the Jacobian.
struct Elimination {
  struct Lower {
    int row = 0;      ///< the step at which this row is pivot row
    int entry = 0;    ///< of the Jacobian, then of L
    int targets = 0;  ///< first of the entries (row, column) in `targets`, one for each Upper of the step
  };
  struct Upper {
    int column = 0;  ///< the step at which this column is eliminated
    int entry = 0;
  };
  struct Step {
    int pivot = 0;        ///< entry
    int first_lower = 0;  ///< in `lower`; up to the next step's
    int first_upper = 0;
  };

  int unknowns = 0;
  int entries = 0;
  std::vector<int> equation;  ///< eliminated at each step
  std::vector<int> unknown;
  std::vector<Step> steps;  ///< one more than unknowns, the last for its bounds
  std::vector<Lower> lower;
  std::vector<Upper> upper;
  std::vector<int> targets;
  std::vector<int> entry_numbers;  ///< [equation·unknowns + unknown], −1 where there is no entry

  int entry(int e, int i) const { return entry_numbers[e * unknowns + i]; }

  /// Compiled once.
  Elimination();
  Elimination(const Elimination&);
  Elimination(Elimination&&) noexcept;
  Elimination& operator=(const Elimination&);
  Elimination& operator=(Elimination&&) noexcept;
  ~Elimination();
};

/// `jacobians` are samples, unknowns × unknowns row by row, all regular; an entry is where a monomial has the unknown,
/// though it be 0 at all samples.
Elimination order_elimination(const MonomialSystem& system, const std::vector<ComplexVectorX>& jacobians);

/// The samples are Jacobians at random points. Precondition: there they are regular.
Elimination order_elimination(const SquareSystem& system, std::mt19937_64& random);

/// Of n × n matrices, column by column, whose entries are 0 where those of `pattern` are; `sample` is the only one.
Elimination order_elimination(int n, const double* pattern, const double* sample);

/// The only sample is the Jacobian at x, for these parameters; any order where it is singular.
Elimination order_elimination_at(const SquareSystem& system, const ComplexVectorX& parameters,
                                 const ComplexVectorX& x);
Elimination order_elimination_at(const MonomialSystem& system, const ComplexVectorX& parameters,
                                 const ComplexVectorX& x);

}  // namespace gcs
