#include "solvers/octahedron/core_solutions.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/model/distance_system.hpp"
#include "solvers/octahedron/exact_determinants.hpp"
#include "solvers/octahedron/exact_squares.hpp"
#include "solvers/octahedron/octahedron_placer.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr int pairs = CoreSolutions::pairs;

/// Coordinates beyond this (times the longest edge) leave less than six digits of the squared lengths in
/// doubles.
constexpr double far_away = 1e5;

bool same(const CoreSolution& p, const CoreSolution& q) {
  const double tolerance = std::max(p.tolerance(), q.tolerance());
  double size = 1;
  double difference = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    size = std::max(size, std::abs(p.diagonals[i]));
    difference = std::max(difference, std::abs(p.diagonals[i] - q.diagonals[i]));
  }
  return difference <= tolerance * size;
}

class CoreSolver {
 public:
  CoreSolver(const Scene& scene, const CoreReduction& reduction, const Octahedron& octahedron)
      : scene_(scene),
        entries_(scene),
        octahedron_(with_round_base(octahedron, entries_)),
        placer_(scene.point_count(), entries_, octahedron_) {
    const std::vector<DoubleDouble> squares = target_squares(scene);
    for (int e : reduction.core_constraints) {
      const auto [p, q] = scene.problem().constraints[e].between;
      equations_.push_back({p, q, squares[e]});
      scale_ = std::max(scale_, entries_(p, q));
    }
  }

  CoreSolutions run(DiagonalMethod method, WorkCounters& work) {
    const DiagonalEquations equations(entries_, octahedron_);
    CoreSolutions solutions;
    const auto [zeros, elimination] = diagonal_zeros(scene_, octahedron_, equations, method);
    solutions.elimination = elimination;
    solutions.total_degree = equations.total_degree();
    solutions.frame = placer_.base();
    solutions.common_factor = zeros.common_factor;
    std::vector<int> hits;  // eigenvalues that lead to each solution
    for (const std::vector<CommonZero>& zeros_here : zeros.of_eigenvalue) {
      const std::vector<int> reached = follow(equations, zeros_here, solutions.list, work);
      hits.resize(solutions.list.size(), 0);
      for (int solution : reached) ++hits[solution];
      if (reached.empty() && is_far_away(equations, zeros_here)) ++solutions.far_away;
    }
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (solutions.list[i].is_singular) solutions.list[i].multiplicity = hits[i];
    return solutions;
  }

 private:
  /// All that is placed with these diagonals, if anything is.
  bool is_far_away(const DiagonalEquations& equations, const std::vector<CommonZero>& zeros) {
    return std::all_of(zeros.begin(), zeros.end(), [&](const CommonZero& zero) {
      const std::vector<ComplexPoints> placed = placer_.place(equations.diagonals(zero));
      return std::all_of(placed.begin(), placed.end(), [&](const ComplexPoints& points) {
        return !(points.cwiseAbs().maxCoeff() <= far_away * std::sqrt(scale_));
      });
    });
  }

  /// The solutions that an eigenvalue leads to, by index; new ones are appended.
  std::vector<int> follow(const DiagonalEquations& equations, const std::vector<CommonZero>& zeros,
                          std::vector<CoreSolution>& list, WorkCounters& work) {
    std::vector<int> reached;
    for (const CommonZero& zero : zeros)
      for (ComplexPoints& points : placer_.place(equations.diagonals(zero))) {
        const auto solution = polished(std::move(points), work);
        if (!solution || !comes_from(*solution, equations.diagonals(zero))) continue;
        const auto known = std::find_if(list.begin(), list.end(),
                                        [&](const CoreSolution& other) { return same(*solution, other); });
        const int index = static_cast<int>(known - list.begin());
        if (known == list.end())
          list.push_back(*solution);
        else
          known->is_singular |= solution->is_singular;
        if (std::find(reached.begin(), reached.end(), index) == reached.end()) reached.push_back(index);
      }
    return reached;
  }

  /// Newton's method has not wandered off. Of a triple zero an eigenvalue is right to 1e-5.
  bool comes_from(const CoreSolution& solution, const Diagonals& diagonals) const {
    const auto is_near = [this](Complex found, Complex wanted) {
      return std::abs(found - wanted) <= 1e-2 * (scale_ + std::abs(wanted));
    };
    return is_near(solution.diagonals[0], diagonals.x) && is_near(solution.diagonals[1], diagonals.y);
  }

  /// Not so where Newton's method stalled on the way to infinity, or on a curve of near solutions that leads
  /// there: the rounding of coordinates so large leaves less than six digits of a squared length.
  bool satisfies_distances(const ComplexPoints& points) const { return satisfies_distances(widened(points)); }
  bool satisfies_distances(const WidePoints& points) const {
    return std::all_of(equations_.begin(), equations_.end(), [&](const DistanceEquation& e) {
      return std::abs(squared_distance_excess(points[e.a], points[e.b], e.square)) <= 1e-6 * e.square.value();
    });
  }

  std::optional<CoreSolution> polished(ComplexPoints points, WorkCounters& work) const {
    if (!points.allFinite()) return std::nullopt;
    const ComplexRefinement refinement = refine(equations_, placer_.base(), points);
    work.newton_iterations += refinement.iterations;
    if (!refinement.converged) return std::nullopt;
    if (!satisfies_distances(points)) return widely_polished(points, work);
    CoreSolution solution{points, diagonals(points), {}};
    solution.is_singular = refinement.reciprocal_condition < nearly_singular;
    return solution;
  }

  std::optional<CoreSolution> widely_polished(const ComplexPoints& points, WorkCounters& work) const {
    WidePoints wide = widened(points);
    const ComplexRefinement refinement = refine(equations_, placer_.base(), wide);
    work.newton_iterations += refinement.iterations;
    if (!refinement.converged || !satisfies_distances(wide)) return std::nullopt;
    return CoreSolution{narrowed(wide), diagonals(wide), wide};
  }

  template <class Points>
  std::array<Complex, 3> diagonals(const Points& points) const {
    const auto square = [&](const std::array<int, 2>& pair) {
      return squared_distance(points, pair[0], pair[1]);
    };
    return {square(octahedron_.pair[0]), square(octahedron_.pair[1]), square(octahedron_.pair[2])};
  }

  const Scene& scene_;
  PairEntries entries_;
  Octahedron octahedron_;
  OctahedronPlacer placer_;
  std::vector<DistanceEquation> equations_;
  double scale_ = 0;  ///< the largest squared length
};

/// With each choice of two diagonals until nothing is missing.
CoreSolutions solved(const Scene& scene, const CoreReduction& reduction, DiagonalMethod method,
                     WorkCounters& work) {
  Octahedron octahedron = *find_octahedron(scene.problem(), reduction);
  CoreSolutions best = CoreSolver(scene, reduction, octahedron).run(method, work);
  if (best.accounted_for() != pairs) best.at_infinity = stretched_walks(scene, octahedron);
  for (int choice = 1; choice < 3 && best.accounted_for() != pairs; ++choice) {
    std::rotate(octahedron.pair.begin(), octahedron.pair.begin() + 1, octahedron.pair.end());
    CoreSolutions found = CoreSolver(scene, reduction, octahedron).run(method, work);
    found.at_infinity = best.at_infinity;
    if (found.accounted_for() > best.accounted_for()) best = std::move(found);
  }
  best.flexible = !best.are_all_isolated() && is_proven_to_flex(scene, octahedron);
  return best;
}

}  // namespace

int CoreSolutions::accounted_for() const {
  int count = at_infinity;
  for (const CoreSolution& solution : list) count += solution.multiplicity;
  return count;
}

bool CoreSolutions::are_all_isolated() const {
  return accounted_for() == pairs && std::none_of(list.begin(), list.end(), [](const CoreSolution& solution) {
           return solution.is_singular;
         });
}

CoreSolutions solve_core(const Scene& scene, const CoreReduction& reduction, DiagonalMethod method,
                         WorkCounters& work) {
  CoreSolutions found = solved(scene, reduction, method, work);
  const bool are_all = found.accounted_for() == pairs && !found.common_factor;
  if (method == DiagonalMethod::univariate || found.flexible || are_all) return found;
  CoreSolutions exact = solved(scene, reduction, DiagonalMethod::univariate, work);
  return exact.accounted_for() > found.accounted_for() && !exact.common_factor ? exact : found;
}

}  // namespace gcs
