#include "harness/drawings/graph_drawing.hpp"

#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/occurrences.hpp"

using namespace gcs;

namespace {

bool on_both_sides(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  const auto side = [&](const Eigen::Vector2d& p) {
    return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() > 0;
  };
  return side(c) != side(d);
}

int crossings(const ProblemStatement& problem, const Eigen::Matrix2Xd& places) {
  int count = 0;
  const auto& all = problem.constraints;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto [a, b] = all[i].between;
      const auto [c, d] = all[j].between;
      if (a == c || a == d || b == c || b == d) continue;
      count += on_both_sides(places.col(a), places.col(b), places.col(c), places.col(d)) &&
                       on_both_sides(places.col(c), places.col(d), places.col(a), places.col(b))
                   ? 1
                   : 0;
    }
  return count;
}

}  // namespace

TEST_CASE("a constraint graph shows every entity and every constraint") {
  for (const std::string& id : shipped_instances()) {
    CAPTURE(id);
    const ProblemStatement problem = load_instance(id).problem;
    const std::string svg = graph_svg(problem, "a < b");
    CHECK(occurrences(svg, "<circle class=\"node\"") == problem.points.size());
    CHECK(occurrences(svg, "<rect class=\"node\"") == problem.lines.size());
    CHECK(occurrences(svg, "<path class=\"node\"") == problem.planes.size());
    CHECK(occurrences(svg, "<line class=\"edge\"") == problem.constraints.size() + problem.relations.size());
    std::size_t joined = 0;
    for (const RigidBody& body : problem.bodies)
      joined += body.elements.size() * (body.elements.size() - 1) / 2;
    CHECK(occurrences(svg, "<line class=\"body\"") == joined);
    CHECK(occurrences(svg, "stroke-dasharray") == (problem.sketch ? 1 : 0));
    CHECK(svg.find("<title>a &lt; b</title>") != std::string::npos);
  }
}

TEST_CASE("a graph has an edge for each entity that an operand names, and none of a sign") {
  const ProblemStatement problem = parse_statement(R"({
    "format": "gcsbench-instance/2", "id": "mixed", "dimension": 3, "points": ["a", "b", "c", "d"], "planes": ["E"],
    "constraints": [{"id": "u", "type": "perpendicular", "between": [["a", "b"], "E"]},
                    {"id": "v", "type": "collinear", "between": ["a", "b", "c"]},
                    {"id": "w", "type": "orientation", "of": ["a", "b", "c", "d"], "sign": 1}]})")
                                       .problem;
  std::vector<std::string> edges;
  for (const GraphEdge& edge : graph_edges(problem))
    edges.push_back(edge.name + ": " + problem.name(edge.between[0]) + problem.name(edge.between[1]));
  CHECK(edges == std::vector<std::string>{"u: aE", "u: bE", "v: ab", "v: bc"});
}

TEST_CASE("every bent constraint is dashed") {
  ProblemStatement problem = load_instance("octahedron").problem;
  problem.interpolation.bends = {{0, {1}}, {4, {1, 2}}, {7, {0.5}}};
  CHECK(occurrences(graph_svg(problem, ""), "stroke-dasharray") == 3);
  problem.interpolation.bends.emplace();
  CHECK(occurrences(graph_svg(problem, ""), "stroke-dasharray") == 0);
}

TEST_CASE("planar graphs with enough triangles are drawn without crossings") {
  for (const std::string id : {"octahedron", "icosahedron"}) {
    const ProblemStatement problem = load_instance(id).problem;
    CHECK(crossings(problem, graph_layout(problem)) == 0);
  }
}

TEST_CASE("entities are apart, inside the unit square") {
  for (const std::string& id : shipped_instances()) {
    CAPTURE(id);
    const Eigen::Matrix2Xd places = graph_layout(load_instance(id).problem);
    CHECK(places.minCoeff() >= -1e-9);
    CHECK(places.maxCoeff() <= 1 + 1e-9);
    for (Eigen::Index i = 0; i < places.cols(); ++i)
      for (Eigen::Index j = 0; j < i; ++j) CHECK((places.col(i) - places.col(j)).norm() > 0.05);
  }
}
