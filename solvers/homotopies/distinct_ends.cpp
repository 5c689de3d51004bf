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
    : ends_(ends), index_(std::move(signs), random) {
  for (std::size_t path = 0; path < ends.size(); ++path) {
    const PathEnd& end = ends[path];
    const bool is_singular = end.kind == PathEnd::Kind::singular;
    if (!is_singular && end.kind != PathEnd::Kind::regular) continue;
    const RelativeTo size = end.is_precise ? RelativeTo::each : RelativeTo::largest;
    const int known = find(end.x, uncertainty(is_singular), size);
    const int number = known < 0 ? this->size() : known;
    if (known < 0) {
      index_.add(end.x, uncertainty(is_singular), size);
      first_.push_back(path);
      paths_.push_back(0);
      singular_.push_back(false);
      size_.push_back(size);
    }
    ++paths_[number];
    if (is_singular) singular_[number] = true;
  }
}

int DistinctEnds::find(const ComplexVectorX& x, double uncertainty, RelativeTo size) const {
  return index_.find(x, uncertainty, size, [this](int i) -> const ComplexVectorX& { return (*this)[i]; });
}

bool DistinctEnds::has_conjugate(int i) const {
  return find(conjugate((*this)[i]), uncertainty(singular_[i]), size_[i]) >= 0;
}

int DistinctEnds::jumps() const {
  int count = 0;
  for (int i = 0; i < size(); ++i) count += !singular_[i] && paths_[i] > 1;
  return count;
}

}  // namespace gcs
