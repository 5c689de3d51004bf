#pragma once
/// Coordinates in the hyperplanes that cut a curve of S: y = c + P v with P of full rank m, J P ≈ I and
/// ν·P = 0 exactly.
///
/// ν is the tangent, rounded so that its largest component is ±1 and the others are multiples of 2^-10; the
/// rows of P but that of the largest component are the inverse of J restricted to the hyperplane, rounded to
/// multiples of a power of two small enough for the remaining row, and for differences of rows, to be exact
/// in floating point. Where differences of rows need not be exact, rows of components that ν does not have are left as
/// they are, since coordinates of other sizes would coarsen them. So the hyperplane through c that holds y is known without an error: it is ν·y = ν·c.

#include <Eigen/Core>

namespace gcs {

struct CurveSection {
  Eigen::VectorXd normal;    ///< ν, m + 1 entries
  Eigen::MatrixXd rows;      ///< Pᵀ, m × (m + 1): column j is row j of P
  Eigen::MatrixXd jacobian;  ///< J, m × (m + 1), as given

  Eigen::Index equations() const { return rows.rows(); }
};

/// `jacobian`: m × (m + 1), `tangent`: spans its kernel. False where the restricted Jacobian is singular in
/// floating point. Precondition: m ≥ 1.
bool set_section(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& tangent, bool has_exact_differences,
                 CurveSection& section);

}  // namespace gcs
