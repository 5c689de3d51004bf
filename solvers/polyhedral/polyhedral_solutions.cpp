#include "solvers/polyhedral/polyhedral_solutions.hpp"

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/mirror_images.hpp"

namespace gcs {
namespace {

const std::string where_paths_lead = "random lengths";

ComplexVectorX flat(const std::vector<ComplexVectorX>& coefficients) {
  ComplexVectorX all;
  for (const ComplexVectorX& equation : coefficients) all.insert(all.end(), equation.begin(), equation.end());
  return all;
}

class Solution {
 public:
  Solution(const PolyhedralRequest& request, std::mt19937_64& random, WorkCounters& work)
      : request_(request),
        random_(random),
        work_(work),
        equations_(request.formulation == Formulation::spheres
                       ? sphere_equations(request.coordinates, request.placement)
                       : coordinate_equations(request.system, request.placement)),
        frame_axes_(mirror_axes(request.scene, request.coordinates)),
        divided_axes_(request.follows_mirror_images ? divided_by_none(frame_axes_) : frame_axes_) {}

  PolyhedralSolutions run() {
    const SupportsPaths paths = follow_supports(
        equations_.supports, flat(equations_.coefficients), axes(),
        {request_.setup, request_.seed, request_.stop, request_.progress, where_paths_lead}, random_, work_);
    result_.missing = paths.missing;
    result_.counts = paths.counts;
    result_.stopped = paths.is_stopped;
    sort_in(paths.ends);
    return std::move(result_);
  }

 private:
  void sort_in(const std::vector<PathEnd>& ends) {
    SolutionSet distinct(divided_axes_, random_);
    for (const PathEnd& end : ends)
      if (end.kind == PathEnd::Kind::regular) distinct.insert(in_frame(end.x), regular_uncertainty);
    result_.solutions = request_.follows_mirror_images
                            ? one_of_each_class(distinct.solutions(), frame_axes_, random_)
                            : distinct.solutions();
    if (result_.missing.empty()) result_.missing = why_not_all(ends, distinct.size(), where_paths_lead);
  }

  /// The frame's coordinates from the equations' unknowns; those that are known there are the placement's.
  ComplexVectorX in_frame(const ComplexVectorX& unknowns) const {
    ComplexVectorX x = request_.placement;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (equations_.unknown_of[i] >= 0) x[i] = unknowns[equations_.unknown_of[i]];
    return x;
  }

  /// The reflection to divide by that changes the sign of each of the equations' unknowns, or −1.
  std::vector<int> axes() const {
    std::vector<int> result(equations_.supports.size(), -1);
    for (std::size_t i = 0; i < frame_axes_.size(); ++i)
      if (equations_.unknown_of[i] >= 0) result[equations_.unknown_of[i]] = divided_axes_[i];
    return result;
  }

  const PolyhedralRequest& request_;
  std::mt19937_64& random_;
  WorkCounters& work_;
  const SparseEquations equations_;
  const std::vector<int> frame_axes_;
  const std::vector<int> divided_axes_;
  PolyhedralSolutions result_;
};

}  // namespace

PolyhedralSolutions polyhedral_solutions(const PolyhedralRequest& request, std::mt19937_64& random,
                                         WorkCounters& work) {
  return Solution(request, random, work).run();
}

}  // namespace gcs
