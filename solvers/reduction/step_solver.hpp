#pragma once
/// All places of an element that hangs on placed ones, real or complex.
///
/// With the placed elements' unknowns put in, the step's equations are quadratic ones whose coefficients are numbers.
/// Those that depend on places or values are taken for parameters: paths from mixed cells lead to the solutions for random
/// ones, and one homotopy from each of these to the solutions for the places at hand (coefficient-parameter homotopy; A. Morgan, A. Sommese, Coefficient-parameter polynomial continuation, Appl.
/// Math. Comput. 29 (1989)). Step control is a heuristic: `missing` says what it left open.

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "solvers/elements/element_order.hpp"
#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/general_family.hpp"
#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/homotopies/shortcomings.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// One way to place an element: the values of its step's unknowns.
struct StepWay {
  ComplexVectorX values;
  bool is_real = false;
  int multiplicity = 1;
};

class StepSolver {
 public:
  /// `whole`: the equations that the step is of. Keeps a copy of the means.
  StepSolver(const GeneralEquations& whole, const PlacingStep& step, const SolveMeans& means);

  /// Distinct up to signs. `x`: the unknowns of the whole, those of the steps before placed; `is_real`: whether these
  /// are. Adds to `work`.
  std::vector<StepWay> ways(const ComplexVectorX& x, bool is_real, WorkCounters& work);

  /// As many at random parameters.
  std::size_t generic_ways() const { return starts_.size(); }
  /// Whether somewhere as many were found: then that is their number at generic values.
  bool has_all_somewhere() const { return has_all_somewhere_; }
  /// What may have been left out so far, in words.
  std::string missing() const;

 private:
  /// A coefficient of the whole times unknowns that are placed before; −1: a factor 1.
  struct Addend {
    std::size_t coefficient = 0;
    int first = -1, second = -1;
  };
  struct Term {
    std::vector<Addend> addends;
    bool is_parameter = false;
  };

  void take_equations(const GeneralEquations& whole, const PlacingStep& step);
  ComplexVectorX random_parameters();
  void find_starts();
  void find_starts_at_parameters();
  void count_lost(const std::vector<PathEnd>& ends);
  std::vector<PathEnd> followed_to(const ComplexVectorX& coefficients, WorkCounters& work);
  ComplexVectorX coefficients_at(const ComplexVectorX& x) const;

  ComplexVectorX of_whole_;  ///< coefficients
  SignMasks signs_;
  SolveMeans means_;
  std::mt19937_64 random_;
  MonomialSystem system_;
  std::vector<Term> terms_;    ///< of each monomial
  ComplexVectorX parameters_;  ///< at random
  std::vector<ComplexVectorX> starts_;
  Elimination elimination_;
  std::unique_ptr<LegTracking> tracking_;
  WorkCounters first_work_;
  Shortcomings missing_;
  std::string missing_starts_;
  bool has_all_somewhere_ = false;
};

}  // namespace gcs
