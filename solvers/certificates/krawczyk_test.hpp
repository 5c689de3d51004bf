#pragma once
/// Krawczyk's test of boxes for every quadratic system, in doubles with residuals in double-double
/// (certificates/krawczyk_image.hpp has the operator, and the literature).

#include <optional>

#include "solvers/certificates/interval_equations.hpp"
#include "solvers/certificates/krawczyk.hpp"

namespace gcs {

/// A solution that exists, and no other one lies where |x_i − mid_i| ≤ unique_i.
struct ProvenSolution {
  Box enclosure;
  Eigen::VectorXd unique;
  int multiplicity = 1;
};

class KrawczykTest {
 public:
  /// Keeps a reference. Precondition: as many equations as unknowns, unknowns of order `size`.
  KrawczykTest(const IntervalEquations& system, double size) : system_(system), size_(size) {}

  /// Krawczyk's operator on the box; nothing where the Jacobian at its middle is singular.
  std::optional<KrawczykImage<double>> image(const Box& box) const;

  /// The same on a box along other axes, which are square and regular.
  std::optional<KrawczykImage<double>> image(const Eigen::MatrixXd& axes, const SkewBox& box) const;

  /// A solution that is proven to be the only one in a box around it and around `box`; nothing where that is
  /// not proven. `iterations` grows by those of Newton's method.
  std::optional<ProvenSolution> only_solution_around(const Box& box, std::int64_t& iterations) const;

  /// Newton's method, as far as rounding lets it go. False where it does not converge.
  bool refine(Eigen::VectorXd& x, std::int64_t& iterations) const;

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const { return linearised(system_, x).jacobian; }

 private:
  /// A smaller box of the same middle that holds the solutions in `box`.
  Box tightened(Box box) const;

  const IntervalEquations& system_;
  double size_;
};

}  // namespace gcs
