#include "solvers/tangents/eigenvalue_clusters.hpp"

#include <Eigen/Jacobi>
#include <cmath>

#include "solvers/numeric/dense_factors.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// Exchanges the diagonal entries k and k + 1 by a rotation (Golub, Van Loan, Matrix Computations, section 7.6.2).
void exchange(int k, SchurForm& schur) {
  auto& [t, u] = schur;
  Eigen::JacobiRotation<Complex> rotation;
  rotation.makeGivens(t(k, k + 1), t(k + 1, k + 1) - t(k, k));
  t.applyOnTheLeft(k, k + 1, rotation.adjoint());
  t.applyOnTheRight(k, k + 1, rotation);
  u.applyOnTheRight(k, k + 1, rotation);
  t(k + 1, k) = 0;
}

/// Moves the entry of those from `first` on that is nearest to `center` to `first`.
void bring_nearest(Complex center, int first, SchurForm& schur) {
  int nearest = first;
  for (int i = first + 1; i < tangent_count; ++i)
    if (std::abs(schur.t(i, i) - center) < std::abs(schur.t(nearest, nearest) - center)) nearest = i;
  for (int k = nearest; k > first; --k) exchange(k - 1, schur);
}

}  // namespace

std::vector<EigenvalueCluster> clusters_of(std::span<const Complex> values, double tolerance) {
  std::vector<EigenvalueCluster> clusters;
  std::vector<bool> taken(values.size(), false);
  for (int first = 0; first < static_cast<int>(values.size()); ++first) {
    if (taken[first]) continue;
    taken[first] = true;
    EigenvalueCluster cluster{first};
    for (std::size_t reached = 0; reached < cluster.size(); ++reached) {
      const Complex at = values[cluster[reached]];
      for (int i = 0; i < static_cast<int>(values.size()); ++i) {
        if (taken[i] || !(std::abs(values[i] - at) <= tolerance * (1 + std::abs(at)))) continue;
        taken[i] = true;
        cluster.push_back(i);
      }
    }
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

Complex mean_of(std::span<const Complex> values, const EigenvalueCluster& cluster) {
  Complex sum = 0;
  for (const int i : cluster) sum += values[i];
  return sum / static_cast<double>(cluster.size());
}

bool may_be_one(std::span<const Complex> values, const EigenvalueCluster& cluster) {
  const Complex mean = mean_of(values, cluster);
  const double reach =
      100 * std::pow(epsilon, 1 / static_cast<double>(cluster.size())) * (1 + std::abs(mean));
  for (const int i : cluster)
    if (std::abs(values[i] - mean) > reach) return false;
  return true;
}

Subspace invariant_subspace(const AlgebraMatrix& matrix, Complex center, int dimension) {
  SchurForm schur = schur_form(matrix.cast<Complex>());
  for (int i = 0; i < dimension; ++i) bring_nearest(center, i, schur);
  return schur.u.leftCols(dimension);
}

Restriction restricted(const AlgebraMatrix& matrix, const Subspace& subspace) {
  return subspace.adjoint() * (matrix.cast<Complex>() * subspace);
}

}  // namespace gcs
