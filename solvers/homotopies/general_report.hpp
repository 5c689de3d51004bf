#pragma once
/// From the ends of paths to solutions of a general scene, with what they prove or leave open.

#include <optional>
#include <random>
#include <stop_token>
#include <vector>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/general_family.hpp"
#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Regular solutions near given places, one for each class.
class RegularClasses {
 public:
  /// How far from its place a solution may be, and which ones are the same, relative to 1 + the largest |x_i|.
  struct Tolerances {
    double nearby = 0;
    double same = regular_uncertainty;
  };

  /// Keeps a reference to the equations.
  RegularClasses(const GeneralEquations& equations, const Tolerances& tolerances, std::mt19937_64& random)
      : equations_(equations), tolerances_(tolerances), known_(equations.signs, random) {}

  /// Whether Newton's method settles near x.
  bool add(ComplexVectorX x);
  const std::vector<PathEnd>& ends() const { return ends_; }

 private:
  const GeneralEquations& equations_;
  Tolerances tolerances_;
  SolutionSet known_;
  std::vector<PathEnd> ends_;
};

/// The real zero that the finite end of a path stands for, if it does: of a regular one, where Newton's method from its
/// real part leads to it.
std::optional<ComplexVectorX> real_end(const MonomialSystem& system, const ComplexVectorX& coefficients,
                                       const ComplexVectorX& x, bool is_singular);

/// As complex_report: candidates from the finite ends, distinct up to signs and real where Newton's method on the real
/// part agrees; a record for every path. Solutions that doubles hardly tell apart are proven with the file's own numbers,
/// and named where they are not.
SolveReport general_report(const SceneSystem& scene, const GeneralEquations& equations,
                           const std::vector<PathEnd>& ends, const WorkCounters& work,
                           std::mt19937_64& random, const std::stop_token& stop);

}  // namespace gcs
