#include "solvers/homotopies/conjugate_ends.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "solvers/homotopies/distinct_ends.hpp"

namespace gcs {
namespace {

/// By the reciprocal condition number of a square matrix: zeros on curves, whose conjugates prove nothing, lose rank to some
/// 1e-13.
bool is_regular(const ComplexVectorX& jacobian, std::size_t unknowns) {
  constexpr double least_rcond = 1e-10;
  const auto n = static_cast<Eigen::Index>(unknowns);
  return Eigen::Map<const Eigen::MatrixXcd>(jacobian.data(), n, n).partialPivLu().rcond() > least_rcond;
}

bool has_failed(const PathEnd& end) { return end.kind == PathEnd::Kind::failed; }

}  // namespace

std::vector<LostPath> end_at_conjugates(
    const std::function<ComplexVectorX(const ComplexVectorX&)>& jacobian_at, const SignMasks& signs,
    std::mt19937_64& random, std::vector<PathEnd>& ends) {
  std::vector<LostPath> lost;
  if (std::ranges::none_of(ends, has_failed)) return lost;
  const DistinctEnds distinct(ends, signs, random);
  std::vector<ComplexVectorX> missing;
  for (int i = 0; i < distinct.size(); ++i)
    if (!distinct.is_singular(i) && !distinct.has_conjugate(i) &&
        is_regular(jacobian_at(distinct[i]), distinct[i].size()))
      missing.push_back(conjugate(distinct[i]));
  if (std::ssize(missing) > std::ranges::count_if(ends, has_failed)) return lost;
  for (std::size_t i = 0; !missing.empty(); ++i) {
    if (!has_failed(ends[i])) continue;
    lost.push_back({i, std::move(ends[i])});
    ends[i] = {PathEnd::Kind::regular, std::move(missing.back()), 1, 0, true, ""};
    missing.pop_back();
  }
  return lost;
}

void restore(std::vector<LostPath> lost, std::vector<PathEnd>& ends) {
  for (LostPath& path : lost) ends[path.number] = std::move(path.end);
}

}  // namespace gcs
