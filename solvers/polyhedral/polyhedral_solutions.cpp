#include "solvers/polyhedral/polyhedral_solutions.hpp"

#include <algorithm>
#include <map>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/polyhedral/polyhedral_homotopies.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

std::string what_is_missing(const MixedCells& cells) {
  switch (cells.status) {
    case MixedCellStatus::complete:
    case MixedCellStatus::stopped:
      return "";
    case MixedCellStatus::ties:
      return "no random lifting of the equations' monomials had mixed cells that doubles tell apart";
    case MixedCellStatus::too_large:
      return "the volume of a mixed cell does not fit 60 bits";
  }
  return "";
}

std::string what_is_missing(const GenericZeros& zeros) {
  if (zeros.unsolved_cells > 0)
    return "the binomial systems of " + counted(zeros.unsolved_cells, "mixed cell") +
           " were too large to be solved";
  if (zeros.lost > 0) return counted(zeros.lost, "path") + " from mixed cells got lost";
  if (zeros.repeated > 0)
    return counted(zeros.repeated, "path") + " from mixed cells ended where another had: a step has jumped";
  return "";
}

/// At random lengths every solution is regular.
std::string what_is_missing(const std::vector<PathEnd>& ends, int distinct) {
  std::map<std::string, int> causes;
  int regular = 0;
  for (const PathEnd& end : ends) {
    regular += end.kind == PathEnd::Kind::regular;
    if (end.kind == PathEnd::Kind::failed) ++causes[end.cause];
    if (end.kind == PathEnd::Kind::singular) ++causes["it seems to end at a singular solution"];
  }
  if (regular > distinct)
    return counted(regular - distinct, "path") + " to random lengths ended where another had";
  if (causes.empty()) return "";
  const auto& [cause, count] = *causes.begin();
  return counted(count, "path") + " to random lengths failed: " + cause;
}

class Solution {
 public:
  Solution(const PolyhedralRequest& request, std::mt19937_64& random, WorkCounters& work)
      : request_(request),
        random_(random),
        work_(work),
        stopped_([&request] { return request.stop.stop_requested(); }),
        equations_(request.formulation == Formulation::spheres
                       ? sphere_equations(request.coordinates, request.placement)
                       : coordinate_equations(request.system, request.placement)),
        frame_axes_(mirror_axes(request.scene, request.coordinates)),
        divided_axes_(request.follows_mirror_images ? divided_by_none(frame_axes_) : frame_axes_) {}

  PolyhedralSolutions run() {
    request_.progress("mixed cells", -1);
    const MixedCells cells =
        mixed_cells(equations_.supports, {request_.seed, request_.setup.threads, request_.stop});
    result_.missing = what_is_missing(cells);
    result_.mixed_volume = cells.total_volume();
    result_.cells = static_cast<std::int64_t>(cells.cells.size());
    if (cells.status == MixedCellStatus::complete) follow_from(cells);
    result_.stopped = stopped_();
    return std::move(result_);
  }

 private:
  void follow_from(const MixedCells& cells) {
    const GenericZeros zeros = follow_polyhedral_homotopies(
        cells, axes(), request_.setup, random_, stopped_,
        [&](double fraction) { request_.progress("polyhedral homotopies", fraction); }, work_);
    result_.start_paths = zeros.paths;
    result_.missing = what_is_missing(zeros);
    if (!zeros.stopped && !zeros.zeros.empty()) follow_coefficients(zeros);
  }

  void follow_coefficients(const GenericZeros& zeros) {
    const MonomialSystem system = monomial_system(equations_.supports);
    ComplexVectorX to;
    for (const ComplexVectorX& coefficients : equations_.coefficients)
      to.insert(to.end(), coefficients.begin(), coefficients.end());
    const Elimination elimination =
        order_elimination(system.unknowns, samples(system, zeros.coefficients, to));
    LegTracking tracking(system, elimination, request_.setup);
    sort_in(follow_to_end(
        tracking, zeros.zeros, zeros.coefficients, to, [](const ComplexVectorX&) { return true; }, stopped_,
        [&](double fraction) { request_.progress("paths to random lengths", fraction); }, work_));
  }

  std::vector<ComplexVectorX> samples(const MonomialSystem& system, const ComplexVectorX& from,
                                      const ComplexVectorX& to) {
    constexpr int count = 3;  // at each end
    std::vector<ComplexVectorX> jacobians;
    for (const ComplexVectorX* coefficients : {&from, &to})
      for (int i = 0; i < count; ++i)
        jacobians.push_back(
            jacobian_at(system, *coefficients, random_complex_vector(system.unknowns, random_)));
    return jacobians;
  }

  void sort_in(const std::vector<PathEnd>& ends) {
    SolutionSet distinct(divided_axes_, random_);
    for (const PathEnd& end : ends) {
      result_.at_infinity += end.kind == PathEnd::Kind::at_infinity;
      if (end.kind == PathEnd::Kind::regular) distinct.insert(in_frame(end.x), regular_uncertainty);
    }
    result_.solutions = request_.follows_mirror_images
                            ? one_of_each_class(distinct.solutions(), frame_axes_, random_)
                            : distinct.solutions();
    if (result_.missing.empty()) result_.missing = what_is_missing(ends, distinct.size());
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
  const std::function<bool()> stopped_;
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
