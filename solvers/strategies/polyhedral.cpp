/// All complex solutions by polyhedral homotopies, the way of HOM4PS.
///
/// The equations, for the lengths of a random complex placement, are sparse polynomials
/// (polyhedral/supports.hpp). Mixed cells of a random lifting give start systems of two monomials per
/// equation, polyhedral homotopies lead from their solutions to all zeros of a system of the same supports
/// with random coefficients (polyhedral/polyhedral_homotopies.hpp), and a homotopy in the coefficients leads
/// from there to the equations themselves. As many paths as the mixed volume says are followed, less those
/// that are mirror images of others; those that have no solution to end at run to infinity, and the endgame
/// says so of each (homotopies/endgame.hpp). What is left are all solutions for random lengths (D. N.
/// Bernshtein 1975), and one more homotopy in the squared lengths leads to the given ones.
///
/// formulation=spheres has the squared norms of the points as further unknowns in a fixed frame, and few more
/// paths than solutions; formulation=coordinates are the distance equations as they stand, with 2^m paths
/// for m constraints, as in R. Imbach, P. Mathis, P. Schreck 2016. That no path was lost and none ended
/// where another did is checked, where the theoretical count or bound (counting/theoretical_counts.hpp) is
/// not met anyway; that no step jumped is likely, not proven.
///
/// General scenes go the same way with the equations of elements/scene_system.hpp for the values of a figure at random,
/// after Gaussian elimination (polyhedral/eliminated_equations.hpp). Unit vectors and the like leave no coefficient free,
/// and most paths run to infinity. Where an unknown is 0 whatever the values are, as of a line along an axis of the frame,
/// the equations get constant terms, and more paths (with_constant_terms).
///
/// It fails where the mixed cells cannot be enumerated, on graphs beyond some twenty points, or are of too many paths, and
/// on scenes as monodromy does. HOM4PS-2.0: T. L. Lee, T. Y. Li, C. H. Tsai, Computing 83 (2008).

#include "solvers/strategies/polyhedral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "solvers/homotopies/complex_strategy.hpp"
#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/polyhedral/eliminated_equations.hpp"
#include "solvers/polyhedral/polyhedral_homotopies.hpp"
#include "solvers/polyhedral/polyhedral_solutions.hpp"

namespace gcs {
namespace {

std::vector<Particular> particulars_of(const PathCounts& counts) {
  return {{"mixed_volume", static_cast<std::int64_t>(counts.mixed_volume.approximate())},
          {"mixed_cells", counts.cells},
          {"start_paths", counts.start_paths},
          {"start_paths_at_infinity", counts.at_infinity}};
}

/// Of a general scene.
const std::string destination = "random values";

/// What all lengths of one scene's graph share: the solutions for the lengths of one random placement.
class Found final : public GenericStart {
 public:
  Found(const SolveRequest& request, const TrackingSetup& setup)
      : GenericStart(request.scene, request.seed, setup),
        placement(random_complex_vector(system.unknowns, random)),
        placement_squares(squares_at(system, placement)) {}

  const ComplexVectorX& squares() const override { return placement_squares; }
  const std::vector<ComplexVectorX>& solutions() const override { return generic.solutions; }

  bool is_stopped() const override { return generic.stopped; }
  std::string missing() const override {
    if (generic.stopped) return "stopped on the way to random lengths";
    if (misses_placement)
      return "the random placement that gives the lengths is not among the " +
             std::to_string(generic.solutions.size()) + " classes found for them";
    return are_as_many_as_can_be ? "" : generic.missing;
  }
  std::vector<Particular> particulars() const override { return particulars_of(generic.counts); }

  ComplexVectorX placement;
  ComplexVectorX placement_squares;
  PolyhedralSolutions generic;
  bool are_as_many_as_can_be = false;  ///< whatever paths were lost
  bool misses_placement = false;       ///< it is a solution, and not among those found
};

class PolyhedralStrategy final : public ComplexStrategy {
 public:
  explicit PolyhedralStrategy(const Polyhedral& asked)
      : ComplexStrategy(asked.tracking), formulation_(asked.formulation) {}

 private:
  std::unique_ptr<GenericStart> solve_at_random_lengths(const SolveRequest& request,
                                                        const ClassLimit& limit) const override {
    const TrackingSetup setup = setup_for(request);
    auto found = std::make_unique<Found>(request, setup);
    const auto progress = [&request](std::string_view stage, double fraction) {
      report_progress(request, stage, fraction);
    };
    found->generic = polyhedral_solutions(
        {request.scene, found->coordinates, found->system, found->placement, formulation_,
         follows_mirror_images(), setup, request.seed, request.stop, progress},
        found->random, found->work);
    if (!found->generic.missing.empty())
      found->are_as_many_as_can_be = is_met(limit, found->solutions().size());
    found->misses_placement = !has_placement(request, *found);
    return found;
  }

  std::optional<std::string> why_no_general_scenes() const override {
    if (formulation_ != Formulation::spheres)
      return "a formulation is one of distances between points: leave it out";
    return std::nullopt;
  }

  void solve_random_member(const SolveRequest& request, const ClassLimit& limit,
                           GeneralStart& start) const override {
    const FamilyMember member = random_member(start.equations, start.random);
    const auto [supports, coefficients] = equations_at(start.equations.system, member);
    const SignMasks divided = follows_mirror_images() ? SignMasks(std::vector<int>(supports.size(), -1))
                                                      : symmetric_signs(supports, start.equations.signs);
    const auto progress = [&request](std::string_view stage, double fraction) {
      report_progress(request, stage, fraction);
    };
    const SupportsPaths paths = follow_supports(
        supports, coefficients, divided,
        {setup_for(request), request.seed, request.stop, progress, destination}, start.random, start.work);
    start.parameters = member.parameters;
    start.is_stopped = paths.is_stopped;
    start.particulars = particulars_of(paths.counts);
    start.missing = paths.is_stopped ? "stopped on the way to " + destination : paths.missing;
    const bool has_member = sort_in(paths.ends, divided, member.x, start);
    if (!start.missing.empty() && is_met(limit, start.solutions.size())) start.missing.clear();
    if (start.missing.empty() && !has_member)
      start.missing =
          fmt::format("the random figure that gives the values is not among the {} classes found for them",
                      start.solutions.size());
  }

  /// Where an unknown of the member, which is generic among the figures that meet what has no value, is 0, it is 0 in all of
  /// these, and no zero has coordinates in C* alone.
  static EliminatedEquations equations_at(const MonomialSystem& system, const FamilyMember& member) {
    constexpr double rounding = 1e-10;  // relative to the largest unknown, of Newton's method
    EliminatedEquations equations = eliminated_equations(system, member.parameters);
    const auto is_zero = [least = rounding * largest(member.x)](const std::complex<double>& value) {
      return std::abs(value) <= least;
    };
    return std::ranges::any_of(member.x, is_zero) ? with_constant_terms(std::move(equations)) : equations;
  }

  /// The regular ends, once up to the signs of the scene; jumps show up to those that were divided by. Whether the
  /// member, which is a solution itself, is among them.
  static bool sort_in(const std::vector<PathEnd>& ends, const SignMasks& divided,
                      const ComplexVectorX& member, GeneralStart& start) {
    SolutionSet distinct(divided, start.random), classes(start.equations.signs, start.random);
    for (const PathEnd& end : ends) {
      if (end.kind != PathEnd::Kind::regular) continue;
      distinct.insert(end.x, regular_uncertainty);
      classes.insert(end.x, regular_uncertainty);
    }
    start.solutions = classes.solutions();
    if (start.missing.empty()) start.missing = why_not_all(ends, distinct.size(), destination);
    return classes.find(member, regular_uncertainty) >= 0;
  }

  static bool has_placement(const SolveRequest& request, const Found& found) {
    std::mt19937_64 random(request.seed);
    SolutionSet classes(mirror_axes(request.scene, found.coordinates), random);
    for (const ComplexVectorX& x : found.solutions()) classes.insert(x, regular_uncertainty);
    return classes.find(found.placement, regular_uncertainty) >= 0;
  }

  Formulation formulation_;
};

}  // namespace

StrategyEntry polyhedral_entry() {
  StrategyEntry entry = entry_of<PolyhedralStrategy, Polyhedral>();
  entry.summary = "finds all complex solutions by homotopies from mixed cells, the way of HOM4PS";
  entry.citation = "Huber, Sturmfels 1995; Lee, Li, Tsai 2008";
  entry.keeps_journal = true;
  entry.knows_general_scenes = true;
  entry.accuracy_settings = tracking_accuracy_settings();
  return entry;
}

}  // namespace gcs
