#include "solvers/certificates/nearly_singular.hpp"

#include "solvers/certificates/near_solutions.hpp"
#include "solvers/certificates/proven_error.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/model/complex_lines.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

class Figures {
 public:
  Figures(const Scene& scene, const SceneEquations& equations)
      : scene_(scene), equations_(equations), system_(scene) {}

  Candidate simple(const Certificate& certificate) const {
    const bool is_real = certificate.realness == Certificate::Realness::real;
    Candidate candidate{at(certificate.enclosure.mid, is_real)};
    candidate.error = equations_.distance(candidate.figure, certificate);
    return candidate;
  }

  /// The figure of these unknowns.
  Figure at(const std::vector<Complex>& x, bool is_real) const {
    ComplexPoints points(3, scene_.point_count());
    for (int point = 0; point < scene_.point_count(); ++point)
      for (int axis = 0; axis < 3; ++axis) {
        const int unknown = system_.unknown(point, axis);
        points(axis, point) = unknown >= 0 ? x[static_cast<std::size_t>(unknown)]
                                           : Complex(system_.given_coordinate(point, axis));
      }
    std::vector<ComplexLine> lines(scene_.problem().lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const auto part = [&](int which) {
          return x[static_cast<std::size_t>(equations_.line_unknown(static_cast<int>(i), which, axis))];
        };
        lines[i].point[axis] = part(0);
        lines[i].direction[axis] = part(1);
      }
    return figure_of(points, lines, is_real);
  }

 private:
  const Scene& scene_;
  const SceneEquations& equations_;
  DistanceSystem system_;
};

}  // namespace

bool are_different_classes(const Scene& scene, const std::vector<Candidate>& candidates) {
  if (candidates.size() < 2) return true;
  const FigureJudge judge(scene);
  std::vector<Figure> representatives;
  std::vector<SolutionAccuracy> accuracies;
  for (const Candidate& candidate : candidates) {
    if (candidate.multiplicity != 1) continue;
    representatives.push_back(scene.representative(candidate.figure));
    accuracies.push_back({judge.condition(representatives.back()), candidate.error});
  }
  return solution_classes(scene, representatives, accuracies).first.size() == representatives.size();
}

ResolvedCandidates simple_solutions_near(const SceneSystem& system, const ComplexValues& x, int count,
                                         const std::stop_token& stop) {
  const NearSolutions near = solutions_near(system.equations(), {{x, count}}, count, stop);
  const Scene& scene = system.elements().scene();
  const SceneEquations exact(scene);
  const Certifier certifier(exact.system());
  ResolvedCandidates found;
  for (const Certificate& solution : near.simple) {
    const bool is_real = solution.realness == Certificate::Realness::real;
    found.unknowns.push_back(solution.enclosure.mid);
    found.list.push_back({system.figure(found.unknowns.back(), is_real)});
    // Its unknowns may be a mirror image of these: figures have lines and planes either way round.
    found.list.back().error = certified_error(exact, certifier, found.list.back().figure);
  }
  found.are_told_apart = are_different_classes(scene, found.list);
  return found;
}

int ResolvedCandidates::count() const {
  int sum = 0;
  for (const Candidate& candidate : list) sum += candidate.multiplicity;
  return sum;
}

ResolvedCandidates resolve_nearly_singular(const Scene& scene, const std::vector<Candidate>& nearly_singular,
                                           const std::vector<Candidate>& listed, int expected,
                                           const std::stop_token& stop) {
  ResolvedCandidates result;
  if (nearly_singular.empty()) return result;
  const SceneEquations equations(scene);
  std::vector<NearlySingular> points;
  for (const Candidate& candidate : nearly_singular)
    points.push_back({equations.coordinates(candidate.figure), candidate.multiplicity});
  const NearSolutions solutions = solutions_near(equations.system(), points, expected, stop);
  const Figures figures(scene, equations);
  for (const Certificate& simple : solutions.simple) result.list.push_back(figures.simple(simple));
  std::vector<Candidate> all = listed;
  all.insert(all.end(), result.list.begin(), result.list.end());
  result.are_told_apart = are_different_classes(scene, all);
  for (const MultipleSolution& multiple : solutions.multiple)
    result.list.push_back({figures.at(multiple.x, multiple.is_real), multiple.multiplicity});
  return result;
}

}  // namespace gcs
