/// The disulfide bond of rigid bodies: a ring of two tetrahedra and four triangles, each hinged to the next. Each tetrahedron
/// has two orientations; the four rings that they make have together the solutions that the distances have, each and its
/// mirror image.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"

using namespace gcs;

namespace {

/// Of points by their numbers.
class Squares {
 public:
  explicit Squares(const ProblemStatement& problem) {
    for (const DistanceConstraint& c : problem.constraints)
      squares_[std::minmax(c.between[0], c.between[1])] = c.given.value;
  }
  double operator()(int a, int b) const { return squares_.at(std::minmax(a, b)); }

 private:
  std::map<std::pair<int, int>, double> squares_;
};

/// Up to four points at their distances: the first at 0, the second on the x-axis, the third at y > 0, and the fourth on
/// the side z·side > 0.
RigidBody body_of(const std::string& name, const std::vector<int>& points, int side, const Squares& squares) {
  RigidBody body{name, {}};
  std::vector<Eigen::Vector3d> at;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Vector3d next = Eigen::Vector3d::Zero();
    double rest = i == 0 ? 0 : squares(points[0], points[i]);
    for (std::size_t k = 1; k < i; ++k) {
      const auto axis = static_cast<Eigen::Index>(k - 1);
      const double product =
          (squares(points[0], points[i]) + at[k].squaredNorm() - squares(points[k], points[i])) / 2;
      next[axis] = (product - next.dot(at[k])) / at[k][axis];
      rest -= next[axis] * next[axis];
    }
    if (i > 0) next[static_cast<Eigen::Index>(i - 1)] = std::sqrt(rest) * (i == 3 ? side : 1);
    at.push_back(next);
    body.elements.push_back({points[i], {{next.x(), ""}, {next.y(), ""}, {next.z(), ""}}});
  }
  return body;
}

ProblemStatement ring(const ProblemStatement& distances, int first_side, int second_side) {
  const Squares squares(distances);
  ProblemStatement problem;
  problem.points = distances.points;
  problem.bodies = {body_of("a", {0, 1, 6, 7}, first_side, squares),
                    body_of("b", {0, 1, 2}, 1, squares),
                    body_of("c", {1, 2, 3}, 1, squares),
                    body_of("d", {2, 3, 4, 5}, second_side, squares),
                    body_of("e", {4, 5, 6}, 1, squares),
                    body_of("f", {5, 6, 7}, 1, squares)};
  problem.reference_body = 0;
  return problem;
}

}  // namespace

TEST_CASE("the disulfide of bodies has in its four orientations together what its distances have") {
  const ProblemStatement distances =
      load_instance(std::string(GCSBENCH_SOURCE_DIR) + "/instances/disulfide.json").problem;
  const Scene points(distances);
  std::vector<Figure> figures;
  std::vector<SolutionAccuracy> accuracies;
  const auto take = [&](const Answer& answer) {
    for (const AssessedSolution& solution : answer.solutions) {
      figures.push_back(points.representative(points.in_scene_unit(solution.placement())));
      accuracies.push_back({solution.condition});
    }
  };
  std::uint64_t real = 0;
  for (const int first : {1, -1})
    for (const int second : {1, -1}) {
      const Scene scene = Scene::unchecked(ring(distances, first, second));
      const Answer answer = solve(scene, Monodromy{.certify = true});
      INFO(answer.reason);
      CHECK(answer.status == RunStatus::complete);
      for (const FailedCheck& failed : answer.failed_checks) FAIL_CHECK(failed.what);
      CHECK(answer.solutions.size() == 16);
      REQUIRE(answer.proofs);
      CHECK(answer.proofs->are_complete());
      real += answer.proofs->real;
      take(answer);
    }
  CHECK(figures.size() == 64);
  CHECK(real == 36);  // both of each pair of mirror images
  for (const Figure& figure : figures) CHECK(relative_residual(points, figure) <= 1e-9);
  CHECK(solution_classes(points, figures, accuracies).count() == 32);
  take(solve(points, Monodromy{}));
  CHECK(figures.size() == 96);
  CHECK(solution_classes(points, figures, accuracies).count() == 32);
}
