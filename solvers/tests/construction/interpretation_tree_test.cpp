#include "solvers/construction/interpretation_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/construction/derive.hpp"
#include "solvers/reading/instance_parser.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/grown_graphs.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

InterpretationTree tree_at(const Scene& scene, const std::vector<double>& lengths) {
  return interpretation_tree(scene, first_plan(scene, {}), *scene.sketch(), lengths);
}

InterpretationTree tree_of(const Scene& scene) { return tree_at(scene, scene.target_lengths()); }

std::vector<double> lengths_of(const Scene& scene, const Eigen::Matrix3Xd& points) {
  std::vector<double> lengths;
  for (const DistanceConstraint& c : scene.problem().constraints)
    lengths.push_back((points.col(c.between[0]) - points.col(c.between[1])).norm());
  return lengths;
}

double error_of(const std::vector<double>& lengths, const std::vector<double>& wanted) {
  double worst = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) worst = std::max(worst, std::abs(lengths[i] - wanted[i]));
  return worst;
}

/// Every figure has the scene's lengths, and no two are the same.
void check_figures(const Scene& scene, const InterpretationTree& tree) {
  const std::vector<int> figures = tree.figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Eigen::Matrix3Xd& points = tree.nodes[figures[i]].points;
    CHECK(error_of(lengths_of(scene, points), scene.target_lengths()) < 1e-9 * scene.size());
    for (std::size_t j = 0; j < i; ++j)
      CHECK((points - tree.nodes[figures[j]].points).cwiseAbs().maxCoeff() > 1e-9 * scene.size());
  }
}

/// Points hung at random, one by one, on a simplex less one point: a plan without driving parameters.
Scene hung_scene(int dimension, int points, RandomNumbers& random) {
  samples::Graph graph{dimension, dimension, {}};
  for (int a = 0; a < dimension; ++a)
    for (int b = 0; b < a; ++b) graph.edges.push_back({b, a});
  samples::hang_at_random(graph, points - dimension, 0, random);
  return Scene(samples::placed_at_random(graph, random));
}

/// Of all complex solutions, of which theory knows the number: two for each hung point, mirror images apart.
std::size_t real_solutions(const Scene& scene) {
  const Answer answer = solve(scene, "monodromy", {{"reduce", "off"}});
  CHECK(answer.counts.complex_up_to_reflection ==
        Natural(1ULL << static_cast<unsigned>(scene.point_count() - scene.dimension() - 1)));
  return static_cast<std::size_t>(std::count_if(answer.solutions.begin(), answer.solutions.end(),
                                                [](const auto& solution) { return solution.is_real(); }));
}

std::size_t count(const InterpretationTree& tree, Meeting meeting) {
  return static_cast<std::size_t>(
      std::count_if(tree.nodes.begin(), tree.nodes.end(),
                    [&](const InterpretationNode& node) { return node.meeting == meeting; }));
}

/// Each edge with its length; any sketch that is not flat.
Scene scene_of(int dimension, int points, const samples::Edges& edges, const std::vector<double>& lengths) {
  ProblemStatement problem = samples::problem_of(dimension, points, edges, lengths);
  RandomNumbers random(5);
  problem.sketch = Figure{random.points(dimension, points, 1), {}};
  return Scene::unchecked(problem);
}

/// From the sketch alone, so that the branch of the plan does not depend on lengths: p1, p2, p3, … in their order.
Scene in_order(Scene scene) {
  ProblemStatement problem = scene.problem();
  problem.reference = Reference{0, 1, problem.dimension == 3 ? 2 : -1};
  for (int p = 1; p < scene.point_count(); ++p) {
    PlanStep step{p, {}};
    for (std::size_t c = 0; c < problem.constraints.size(); ++c)
      if (problem.constraints[c].between[1] == p)
        step.from.push_back({problem.constraints[c].between[0], static_cast<int>(c), ""});
    problem.construction.push_back(step);
  }
  return Scene::unchecked(problem);
}

}  // namespace

TEST_CASE("the tree of qK3,3 has each real solution and its mirror image") {
  const Scene scene(read_instance(GCSBENCH_SOURCE_DIR "/instances/qk33.json").problem);
  const InterpretationTree tree = tree_of(scene);
  CHECK(choices(tree.plan) == 4);
  CHECK(tree.plan.driving_parameters() == 0);
  CHECK(tree.figures().size() == 2 * real_solutions(scene));
  check_figures(scene, tree);
}

TEST_CASE("a tree without driving parameters has all real solutions") {
  RandomNumbers random(1);
  std::size_t figures = 0, ends = 0;
  for (int sample = 0; sample < 40; ++sample) {
    const int dimension = 2 + sample % 2;
    const int points = dimension + 1 + random.index(4);
    const Scene scene = hung_scene(dimension, points, random);
    CAPTURE(sample, dimension, points);
    const InterpretationTree tree = tree_of(scene);
    REQUIRE(tree.plan.driving_parameters() == 0);
    CHECK(choices(tree.plan) == points - dimension);
    CHECK(tree.figures().size() == 2 * real_solutions(scene));
    CHECK(count(tree, Meeting::touching) + count(tree, Meeting::undefined) == 0);
    check_figures(scene, tree);
    figures += tree.figures().size();
    ends += count(tree, Meeting::apart);
  }
  CHECK(figures > 100);
  CHECK(ends > 10);
}

TEST_CASE("on given positions mirror images are solutions of their own") {
  RandomNumbers random(2);
  for (int sample = 0; sample < 10; ++sample) {
    ProblemStatement problem = hung_scene(2, 5, random).problem();
    const Eigen::Vector3d first = Eigen::Vector3d::Zero();
    const Eigen::Vector3d second(problem.constraints.front().given.value, 0, 0);
    problem.constraints.erase(problem.constraints.begin());
    problem.fixed_points = {first, second, {}, {}, {}};
    problem.sketch->points.leftCols<2>() << first, second;
    const Scene scene(problem);
    const InterpretationTree tree = tree_of(scene);
    CHECK(choices(tree.plan) == 3);
    CHECK(tree.figures().size() == solve(scene, "plan-scan").solutions.size());
    check_figures(scene, tree);
  }
}

TEST_CASE("at the lengths of the sketch its branch builds the sketch") {
  RandomNumbers random(3);
  std::vector<ProblemStatement> problems{samples::k33(), samples::octahedron()};
  problems.push_back(read_instance(GCSBENCH_SOURCE_DIR "/instances/qk33.json").problem);
  for (int sample = 0; sample < 20; ++sample)
    problems.push_back(samples::random_problem(2 + sample % 2, 5 + sample % 3, random));
  int built = 0;
  for (const ProblemStatement& problem : problems) {
    const Scene scene(problem);
    const InterpretationTree tree = tree_at(scene, lengths_of(scene, scene.sketch()->points));
    const Eigen::Matrix3Xd sketch = in_plan_frame(scene, tree.plan, *scene.sketch()).points;
    // Near a boundary configuration rounding decides.
    if (boundary_distance(tree.plan, {}, sketch) < 0.01) continue;
    ++built;
    std::vector<int> figures = tree.figures();
    std::erase_if(figures, [&](int number) { return !tree.nodes[number].is_on_branch; });
    REQUIRE(figures.size() == 1);
    CHECK((tree.nodes[figures.front()].points - sketch).cwiseAbs().maxCoeff() < 1e-11 * scene.size());
  }
  CHECK(built >= 15);
}

TEST_CASE("children come by side, and nodes level by level") {
  const InterpretationTree tree = tree_of(Scene(samples::k33()));
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    const InterpretationNode& node = tree.nodes[i];
    CHECK(node.parent < static_cast<int>(i));
    CHECK(node.instruction == tree.nodes[node.parent].instruction + 1);
    CHECK(node.instruction >= tree.nodes[i - 1].instruction);
    CHECK_FALSE(tree.nodes[node.parent].has_ended());
    if (node.meeting == Meeting::two_points)
      CHECK(node.side == (tree.nodes[i - 1].parent == node.parent ? -1 : 1));
  }
}

TEST_CASE("circles that touch meet in one point, to rounding") {
  // p4 on the line of p1 and p3, which the decimals of the lengths say and their doubles do not; p5 on both sides.
  const samples::Edges edges{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {2, 3}, {0, 4}, {1, 4}};
  for (const auto& [to_p1, to_p3] :
       {std::pair{1.1, 2.2}, std::pair{0.7, 2.6}, std::pair{5.5, 2.2}, std::pair{0.1, 3.4}}) {
    CAPTURE(to_p1);
    const Scene scene = in_order(scene_of(2, 5, edges, {2.3, 3.3, 1.7, to_p1, to_p3, 1.9, 2.1}));
    const InterpretationTree tree = tree_of(scene);
    CHECK(count(tree, Meeting::touching) == 2);
    CHECK(count(tree, Meeting::apart) == 0);
    CHECK(tree.figures().size() == 4);
    for (const int figure : tree.figures()) {
      const Eigen::Matrix3Xd& points = tree.nodes[figure].points;
      const Eigen::Vector3d off = (points.col(3) - points.col(0)).cross(points.col(2) - points.col(0));
      CHECK(off.norm() < 1e-12 * scene.size() * scene.size());
    }
  }
}

TEST_CASE("spheres that touch meet in one point, to rounding") {
  // The fourth corner of a rectangle.
  const samples::Edges edges{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}};
  const InterpretationTree tree = tree_of(in_order(scene_of(3, 4, edges, {0.4, 0.3, 0.5, 0.5, 0.3, 0.4})));
  CHECK(count(tree, Meeting::touching) == 1);
  CHECK(tree.figures().size() == 1);
}

TEST_CASE("where circles do not meet a branch ends") {
  const samples::Edges edges{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {2, 3}};
  for (const auto& [one, other] : {std::pair{1.0, 1.0}, std::pair{5.0, 1.0}, std::pair{1.0, 5.0}}) {
    const InterpretationTree tree = tree_of(in_order(scene_of(2, 4, edges, {2.3, 3.3, 1.7, one, other})));
    CHECK(tree.figures().empty());
    CHECK(count(tree, Meeting::apart) == 2);
  }
  // Already the frame.
  const InterpretationTree tree = tree_of(in_order(scene_of(2, 4, edges, {2.3, 7.3, 1.7, 7, 7})));
  CHECK(tree.nodes.size() == 4);
  CHECK(tree.nodes.back().has_ended());
}

TEST_CASE("circles around one centre end a branch") {
  // p4 is p1, where p5 may be anywhere around it, or the corner of a rhombus.
  const samples::Edges edges{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}, {0, 4}, {3, 4}};
  const InterpretationTree tree = tree_of(in_order(scene_of(2, 5, edges, {1.3, 1.3, 1.7, 1.3, 1.3, 2, 2})));
  CHECK(count(tree, Meeting::undefined) == 2);
  CHECK(tree.figures().size() == 4);
}
