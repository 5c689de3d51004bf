#pragma once
/// Multiple solutions among the joint eigenvalues of commuting matrices. Of an m-fold eigenvalue rounding
/// makes m of distance eps^(1/m); their mean is still right to rounding, and the traces of the other matrices
/// on the invariant subspace of the cluster give the other coordinates (Corless, Gianni, Trager 1997).

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "solvers/tangents/tangent_algebra.hpp"

namespace gcs {

/// Indices of values that belong together.
using EigenvalueCluster = std::vector<int>;

/// Values within `tolerance` · (1 + modulus) of each other, directly or by way of others.
std::vector<EigenvalueCluster> clusters_of(std::span<const std::complex<double>> values, double tolerance);

/// Whether rounding alone spreads one eigenvalue of this multiplicity so far: the members are within
/// 100 eps^(1/m) · (1 + modulus) of their mean, as a matrix of condition up to about 100^m has them.
bool may_be_one(std::span<const std::complex<double>> values, const EigenvalueCluster& cluster);

std::complex<double> mean_of(std::span<const std::complex<double>> values, const EigenvalueCluster& cluster);

/// Columns: an orthonormal basis.
using Subspace =
    Eigen::Matrix<std::complex<double>, tangent_count, Eigen::Dynamic, 0, tangent_count, tangent_count>;
using Restriction =
    Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, tangent_count, tangent_count>;

/// The invariant subspace of the `dimension` eigenvalues nearest to `center`, from a reordered Schur form:
/// right to rounding over the distance to the next eigenvalue.
Subspace invariant_subspace(const AlgebraMatrix& matrix, std::complex<double> center, int dimension);

/// The matrix of the restriction of `matrix` to an invariant subspace.
Restriction restricted(const AlgebraMatrix& matrix, const Subspace& subspace);

}  // namespace gcs
