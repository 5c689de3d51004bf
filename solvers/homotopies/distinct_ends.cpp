#include "solvers/homotopies/distinct_ends.hpp"

#include <complex>

namespace gcs {
namespace {

double uncertainty(bool is_singular) { return is_singular ? singular_uncertainty : regular_uncertainty; }

}  // namespace

ComplexVectorX conjugate(ComplexVectorX x) {
  for (std::complex<double>& value : x) value = std::conj(value);
  return x;
}

DistinctEnds::DistinctEnds(const std::vector<PathEnd>& ends, SignMasks signs, std::mt19937_64& random)
    : set_(std::move(signs), random) {
  for (const PathEnd& end : ends) {
    const bool is_singular = end.kind == PathEnd::Kind::singular;
    if (!is_singular && end.kind != PathEnd::Kind::regular) continue;
    const RelativeTo size = end.is_precise ? RelativeTo::each : RelativeTo::largest;
    const int number = set_.insert(end.x, uncertainty(is_singular), size);
    if (number == static_cast<int>(paths_.size())) {
      paths_.push_back(0);
      singular_.push_back(false);
      size_.push_back(size);
    }
    ++paths_[number];
    if (is_singular) singular_[number] = true;
  }
}

bool DistinctEnds::has_conjugate(int i) const {
  return set_.find(conjugate(set_[i]), uncertainty(singular_[i]), size_[i]) >= 0;
}

int DistinctEnds::jumps() const {
  int count = 0;
  for (int i = 0; i < size(); ++i) count += !singular_[i] && paths_[i] > 1;
  return count;
}

}  // namespace gcs
