#include "solvers/homotopies/conjugate_ends.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/homotopies/distinct_ends.hpp"

namespace gcs {
namespace {

bool has_failed(const PathEnd& end) { return end.kind == PathEnd::Kind::failed; }

}  // namespace

bool keeps_rank(const ComplexVectorX& jacobian) {
  constexpr double least_rcond = 1e-10;
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(jacobian.size())));
  return Eigen::Map<const Eigen::MatrixXcd>(jacobian.data(), n, n).partialPivLu().rcond() > least_rcond;
}

std::vector<LostPath> end_at_conjugates(const std::function<bool(const ComplexVectorX&)>& is_isolated,
                                        const SignMasks& signs, std::mt19937_64& random,
                                        std::vector<PathEnd>& ends) {
  std::vector<LostPath> lost;
  if (std::ranges::none_of(ends, has_failed)) return lost;
  const DistinctEnds distinct(ends, signs, random);
  std::vector<ComplexVectorX> missing;
  for (int i = 0; i < distinct.size(); ++i)
    if (!distinct.is_singular(i) && !distinct.has_conjugate(i) && is_isolated(distinct[i]))
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
