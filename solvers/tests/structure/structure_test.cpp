#include "solvers/structure/structure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

namespace {

using gcs::ProblemStatement;
using gcs::Structure;
using gcs::StructureDefect;
using Edges = std::vector<std::pair<int, int>>;
using Kind = StructureDefect::Kind;

/// Points p0, p1, … and lines L0, L1, … (numbered after the points) with all lengths 1.
ProblemStatement problem_of(int dimension, int points, int lines, const Edges& edges) {
  ProblemStatement problem;
  problem.dimension = dimension;
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  for (int i = 0; i < lines; ++i) problem.lines.push_back("L" + std::to_string(i));
  problem.fixed_points.resize(problem.points.size());
  problem.fixed_lines.resize(problem.lines.size());
  for (const auto& [a, b] : edges) {
    const std::string id = "a" + std::to_string(problem.constraints.size() + 1);
    problem.constraints.push_back({id, {a, b}, {1, "1"}, false});
  }
  return problem;
}

ProblemStatement graph(int dimension, int points, const Edges& edges) {
  return problem_of(dimension, points, 0, edges);
}

ProblemStatement with_lengths(ProblemStatement problem, const std::vector<double>& lengths) {
  for (std::size_t i = 0; i < lengths.size(); ++i) problem.constraints[i].given = {lengths[i], ""};
  return problem;
}

Edges complete(int points) {
  Edges edges;
  for (int a = 0; a < points; ++a) {
    for (int b = a + 1; b < points; ++b) edges.emplace_back(a, b);
  }
  return edges;
}

Edges complete_bipartite(int left, int right) {
  Edges edges;
  for (int a = 0; a < left; ++a) {
    for (int b = 0; b < right; ++b) edges.emplace_back(a, left + b);
  }
  return edges;
}

/// K5 without the edge 0–1 on the points 0, 1 and three more.
void append_banana(Edges& edges, int third, int fourth, int fifth) {
  for (const int tip : {0, 1}) {
    for (const int other : {third, fourth, fifth}) edges.emplace_back(tip, other);
  }
  edges.insert(edges.end(), {{third, fourth}, {third, fifth}, {fourth, fifth}});
}

std::vector<int> all_up_to(int count) {
  std::vector<int> result(static_cast<std::size_t>(count));
  std::iota(result.begin(), result.end(), 0);
  return result;
}

void check_rigid(const ProblemStatement& problem, int unknowns) {
  const Structure structure = gcs::analyse_structure(problem);
  CHECK(structure.well_posed());
  CHECK(structure.unknowns == unknowns);
  CHECK(structure.constraints == unknowns);
  CHECK(structure.generic_rank == unknowns);
}

/// The only defect of the problem.
StructureDefect only_defect(const ProblemStatement& problem) {
  const Structure structure = gcs::analyse_structure(problem);
  REQUIRE(structure.defects.size() == 1);
  CHECK_FALSE(structure.defects[0].what.empty());
  CHECK_FALSE(structure.defects[0].remedy.empty());
  return structure.defects[0];
}

bool is_satisfiable(const ProblemStatement& problem) {
  const Structure structure = gcs::analyse_structure(problem);
  return std::none_of(structure.defects.begin(), structure.defects.end(),
                      [](const StructureDefect& defect) { return defect.kind == Kind::unsatisfiable; });
}

const Edges triangle{{0, 1}, {1, 2}, {0, 2}};
const Edges octahedron{{0, 1}, {0, 2}, {0, 4}, {0, 5}, {1, 2}, {1, 3},
                       {1, 5}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {4, 5}};
const Edges prism{{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}};

}  // namespace

TEST_CASE("a rigid graph has as many unknowns, constraints and independent rows") {
  SECTION("triangle in the plane") { check_rigid(graph(2, 3, triangle), 3); }
  SECTION("triangle in space") { check_rigid(graph(3, 3, triangle), 3); }
  SECTION("K4 in space") { check_rigid(graph(3, 4, complete(4)), 6); }
  SECTION("K3,3 in the plane") { check_rigid(graph(2, 6, complete_bipartite(3, 3)), 9); }
  SECTION("prism in the plane") { check_rigid(graph(2, 6, prism), 9); }
  SECTION("octahedron in space") { check_rigid(graph(3, 6, octahedron), 12); }
  SECTION("K4,6 in space, by Bolker and Roth") { check_rigid(graph(3, 10, complete_bipartite(4, 6)), 24); }
}

TEST_CASE("problems with hardly any points are handled") {
  SECTION("no entity at all") { check_rigid(graph(3, 0, {}), 0); }
  SECTION("one point") { check_rigid(graph(3, 1, {}), 0); }
  SECTION("two points in the plane") { check_rigid(graph(2, 2, {{0, 1}}), 1); }
  SECTION("two points in space") { check_rigid(graph(3, 2, {{0, 1}}), 1); }
  SECTION("two points without a distance") {
    const StructureDefect defect = only_defect(graph(3, 2, {}));
    CHECK(defect.kind == Kind::under_constrained);
    CHECK(defect.entities == std::vector<int>{1});
  }
}

TEST_CASE("lines count four unknowns each") {
  SECTION("a point and a line") { check_rigid(problem_of(3, 1, 1, {{0, 1}}), 1); }
  SECTION("five points and a line (5p1L)") {
    check_rigid(problem_of(3, 5, 1,
                           {{0, 5},
                            {1, 5},
                            {2, 5},
                            {3, 5},
                            {4, 5},
                            {0, 4},
                            {1, 4},
                            {2, 4},
                            {3, 4},
                            {0, 1},
                            {1, 2},
                            {2, 3},
                            {3, 0}}),
                13);
  }
  SECTION("a tetrahedron and a line, the line named first") {
    Edges edges = complete(4);
    edges.insert(edges.end(), {{4, 0}, {4, 1}, {4, 2}, {4, 3}});
    check_rigid(problem_of(3, 4, 1, edges), 10);
  }
  SECTION("a tetrahedron and two lines") {
    Edges edges = complete(4);
    for (const int line : {4, 5}) edges.insert(edges.end(), {{0, line}, {1, line}, {2, line}, {3, line}});
    check_rigid(problem_of(3, 4, 2, edges), 14);
  }
  SECTION("a line with too few distances is loose") {
    Edges edges = complete(3);
    edges.insert(edges.end(), {{0, 3}, {1, 3}, {2, 3}});
    const StructureDefect defect = only_defect(problem_of(3, 3, 1, edges));
    CHECK(defect.kind == Kind::under_constrained);
    CHECK(defect.entities == std::vector<int>{3});
  }
  SECTION("a fifth distance of a line to a tetrahedron with a point on it is too many") {
    Edges edges = complete(4);
    edges.insert(edges.end(), {{4, 0}, {4, 1}, {4, 2}, {5, 0}, {5, 1}, {5, 2}, {5, 3}, {5, 4}});
    CHECK(only_defect(problem_of(3, 5, 1, edges)).kind == Kind::over_constrained);
  }
}

TEST_CASE("fixed entities have no unknowns") {
  SECTION("a point placed from three fixed ones") {
    ProblemStatement problem = graph(3, 4, {{3, 0}, {3, 1}, {3, 2}});
    problem.fixed_points[0] = Eigen::Vector3d(0, 0, 0);
    problem.fixed_points[1] = Eigen::Vector3d(1, 0, 0);
    problem.fixed_points[2] = Eigen::Vector3d(0, 1, 0);
    check_rigid(problem, 3);
  }
  SECTION("a line placed from four fixed points (4p1L)") {
    ProblemStatement problem = problem_of(3, 4, 1, {{0, 4}, {1, 4}, {2, 4}, {3, 4}});
    for (int i = 0; i < 4; ++i) problem.fixed_points[i] = Eigen::Vector3d(i % 2, i / 2, i == 3);
    check_rigid(problem, 4);
  }
  SECTION("one fixed point leaves the rotations") {
    ProblemStatement problem = graph(2, 3, triangle);
    problem.fixed_points[0] = Eigen::Vector3d(5, 5, 0);
    check_rigid(problem, 3);
  }
  SECTION("what can leave the fixed points is loose") {
    ProblemStatement problem = graph(2, 5, {{2, 0}, {2, 1}, {3, 2}, {4, 3}, {4, 2}});
    problem.fixed_points[0] = Eigen::Vector3d(0, 0, 0);
    problem.fixed_points[1] = Eigen::Vector3d(1, 0, 0);
    const StructureDefect defect = only_defect(problem);
    CHECK(defect.kind == Kind::under_constrained);
    CHECK(defect.entities == std::vector<int>{3, 4});
  }
}

TEST_CASE("under-constrained problems name what is loose") {
  SECTION("a point that dangles from a triangle") {
    Edges edges = triangle;
    edges.emplace_back(2, 3);
    const StructureDefect defect = only_defect(graph(2, 4, edges));
    CHECK(defect.kind == Kind::under_constrained);
    CHECK(defect.entities == std::vector<int>{3});
    CHECK(defect.constraints.empty());
    CHECK_THAT(defect.what, Catch::Contains("p3") && Catch::Contains("1 degree of freedom"));
    CHECK_THAT(defect.remedy, Catch::Contains("p3"));
  }
  SECTION("a point that nothing holds, named first") {
    const StructureDefect defect = only_defect(graph(3, 5, {{1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}}));
    CHECK(defect.entities == std::vector<int>{0});
    CHECK_THAT(defect.what, Catch::Contains("3 degrees of freedom"));
  }
  SECTION("a triangle hinged to a quadrilateral with its diagonal") {
    const StructureDefect defect =
        only_defect(graph(2, 6, {{0, 1}, {1, 2}, {0, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 2}, {2, 4}}));
    CHECK(defect.entities == std::vector<int>{0, 1});
  }
  SECTION("two tetrahedra hinged at an edge") {
    Edges edges = complete(4);
    edges.insert(edges.end(), {{4, 0}, {4, 1}, {5, 0}, {5, 1}, {4, 5}});
    const StructureDefect defect = only_defect(graph(3, 6, edges));
    CHECK(defect.entities == std::vector<int>{4, 5});
  }
  SECTION("K3,3 in space") {
    const Structure structure = gcs::analyse_structure(graph(3, 6, complete_bipartite(3, 3)));
    CHECK(structure.unknowns == 12);
    CHECK(structure.generic_rank == 9);
  }
}

TEST_CASE("over-constrained problems name a dependent set") {
  SECTION("K4 in the plane") {
    const StructureDefect defect = only_defect(graph(2, 4, complete(4)));
    CHECK(defect.kind == Kind::over_constrained);
    CHECK(defect.constraints == all_up_to(6));
    CHECK(defect.entities.empty());
    CHECK_THAT(defect.what, Catch::Contains("a1 (p0–p1)") && Catch::Contains("a6 (p2–p3)"));
  }
  SECTION("K5,5 in space, by Bolker and Roth") {
    const StructureDefect defect = only_defect(graph(3, 10, complete_bipartite(5, 5)));
    CHECK(defect.kind == Kind::over_constrained);
    CHECK(defect.constraints == all_up_to(25));
  }
  SECTION("only the dependent part is named") {
    Edges edges{{4, 0}, {4, 1}};
    const Edges dependent = complete(4);
    edges.insert(edges.end(), dependent.begin(), dependent.end());
    CHECK(only_defect(graph(2, 5, edges)).constraints == std::vector<int>{2, 3, 4, 5, 6, 7});
  }
}

TEST_CASE("the right number of constraints in the wrong places is wrongly constrained") {
  SECTION("a dangling point beside K4 in the plane") {
    Edges edges = complete(4);
    edges.emplace_back(3, 4);
    const StructureDefect defect = only_defect(graph(2, 5, edges));
    CHECK(defect.kind == Kind::wrongly_constrained);
    CHECK(defect.constraints == all_up_to(6));
    CHECK(defect.entities == std::vector<int>{4});
  }
  SECTION("the double banana") {
    Edges edges;
    append_banana(edges, 2, 3, 4);
    append_banana(edges, 5, 6, 7);
    const ProblemStatement problem = graph(3, 8, edges);
    const Structure structure = gcs::analyse_structure(problem);
    CHECK(structure.unknowns == 18);
    CHECK(structure.constraints == 18);
    CHECK(structure.generic_rank == 17);
    const StructureDefect defect = only_defect(problem);
    CHECK(defect.kind == Kind::wrongly_constrained);
    CHECK(defect.constraints == all_up_to(18));
    CHECK(defect.entities == std::vector<int>{5, 6, 7});
  }
}

TEST_CASE("the analysis is the same at every call") {
  const ProblemStatement problem = graph(3, 6, complete_bipartite(3, 3));
  const StructureDefect first = only_defect(problem);
  const StructureDefect second = only_defect(problem);
  CHECK(first.entities == second.entities);
  CHECK(first.what == second.what);
}

TEST_CASE("a length that the others cannot span is unsatisfiable") {
  SECTION("a triangle") {
    const StructureDefect defect = only_defect(with_lengths(graph(2, 3, triangle), {1, 1, 3}));
    CHECK(defect.kind == Kind::unsatisfiable);
    CHECK(defect.entities == std::vector<int>{0, 1, 2});
    CHECK(defect.constraints.front() == 2);
    CHECK(defect.constraints.size() == 3);
    CHECK_THAT(defect.what, Catch::Contains("a3 (p0–p2) is 3") && Catch::Contains("2 long"));
  }
  SECTION("squared lengths") {
    ProblemStatement problem = with_lengths(graph(2, 3, triangle), {1, 1, 9});
    for (auto& constraint : problem.constraints) constraint.is_squared = true;
    CHECK(only_defect(problem).kind == Kind::unsatisfiable);
    problem.constraints[2].given.value = 3.9;
    CHECK(gcs::analyse_structure(problem).well_posed());
  }
  SECTION("a pentagon's side over the three others of a polygon") {
    const Edges edges{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 4}, {1, 4}, {2, 4}};
    const StructureDefect defect = only_defect(with_lengths(graph(2, 5, edges), {1, 1, 1, 3.5, 5, 5, 5}));
    CHECK(defect.entities == std::vector<int>{0, 1, 2, 3});
  }
  SECTION("the distance of two fixed points") {
    ProblemStatement problem = graph(2, 3, {{0, 2}, {1, 2}});
    problem.fixed_points[0] = Eigen::Vector3d(0, 0, 0);
    problem.fixed_points[1] = Eigen::Vector3d(6, 8, 0);
    const StructureDefect defect = only_defect(problem);
    CHECK(defect.kind == Kind::unsatisfiable);
    CHECK(defect.constraints.size() == 2);
    CHECK_THAT(defect.what, Catch::Contains("fixed p0 and p1 are apart by 10"));
    CHECK(is_satisfiable(with_lengths(problem, {5, 5})));
  }
}

TEST_CASE("flat triangles are satisfiable although their lengths are rounded") {
  CHECK(is_satisfiable(with_lengths(graph(2, 3, triangle), {1, 2, 3})));
  REQUIRE(0.1 + 0.7 < 0.8);  // in doubles
  CHECK(is_satisfiable(with_lengths(graph(2, 3, triangle), {0.1, 0.7, 0.8})));
  CHECK_FALSE(is_satisfiable(with_lengths(graph(2, 3, triangle), {0.1, 0.7, 0.8 + 1e-14})));
}

TEST_CASE("lengths of any size are compared") {
  const ProblemStatement problem = graph(2, 3, triangle);
  for (const double unit : {1e-300, 1e300, 1.7e308, 1e-320}) {
    CHECK(is_satisfiable(with_lengths(problem, {unit, unit, unit})));
    CHECK_FALSE(is_satisfiable(with_lengths(problem, {unit / 8, unit / 8, unit})));
  }
  CHECK_FALSE(is_satisfiable(with_lengths(problem, {1e-300, 1e300, 1})));
}

TEST_CASE("a point cannot be farther from a line than a way to another point and from there") {
  Edges edges = complete(4);
  edges.insert(edges.end(), {{0, 4}, {1, 4}, {2, 4}, {3, 4}});
  const ProblemStatement problem = problem_of(3, 4, 1, edges);
  SECTION("too far") {
    const StructureDefect defect =
        gcs::analyse_structure(with_lengths(problem, {1, 1, 1, 1, 1, 1, 1, 9})).defects.at(0);
    CHECK(defect.kind == Kind::unsatisfiable);
    CHECK(defect.entities == std::vector<int>{1, 0, 4});
    CHECK(defect.constraints == std::vector<int>{7, 0, 6});
  }
  SECTION("as far as possible, on the line itself included") {
    CHECK(is_satisfiable(with_lengths(problem, {1, 1, 1, 1, 1, 1, 0, 1, 1, 1})));
    CHECK(is_satisfiable(with_lengths(problem, {1, 1, 1, 1, 1, 1, 1, 2, 2, 2})));
  }
  SECTION("a line is no way between points, because it has no ends") {
    CHECK(is_satisfiable(with_lengths(problem, {9, 9, 9, 9, 9, 9, 0.1, 0.1, 0.1, 0.1})));
  }
}

TEST_CASE("a fixed line bounds the distances of the points near it") {
  ProblemStatement problem = problem_of(3, 4, 1, {{3, 0}, {3, 1}, {3, 4}});
  problem.fixed_points[0] = Eigen::Vector3d(0, 5, 0);
  problem.fixed_points[1] = Eigen::Vector3d(1, 5, 0);
  problem.fixed_points[2] = Eigen::Vector3d(0, 5, 1);
  problem.fixed_lines[0] = gcs::LinePosition{};
  CHECK(is_satisfiable(with_lengths(problem, {1, 1, 4})));
  CHECK_FALSE(is_satisfiable(with_lengths(problem, {1, 1, 7})));
  CHECK_FALSE(is_satisfiable(with_lengths(problem, {1, 1, 3})));
}
