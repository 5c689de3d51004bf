#include "harness/drawings/tree_drawing.hpp"

#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/occurrences.hpp"
#include "solvers/construction/derive.hpp"
#include "solvers/construction/interpretation_tree.hpp"

using namespace gcs;

namespace {

InterpretationTree tree_of(const Instance& instance) {
  const Scene scene = instance;
  return interpretation_tree(scene, first_plan(scene, {}), *scene.sketch(), scene.target_lengths());
}

std::size_t count_ends(const InterpretationTree& tree) {
  std::size_t count = 0;
  for (const InterpretationNode& node : tree.nodes) count += node.has_ended() ? 1 : 0;
  return count;
}

/// qK3,3 with another length for a constraint.
Instance with_length(std::size_t constraint, double length) {
  Instance instance = load_instance("qk33");
  instance.problem.constraints[constraint].given = {length, ""};
  return instance;
}

}  // namespace

TEST_CASE("an interpretation tree shows every node, end and figure") {
  for (const std::string id : {"qk33", "k33", "octahedron", "disulfide"}) {
    CAPTURE(id);
    const Instance instance = load_instance(id);
    const InterpretationTree tree = tree_of(instance);
    const Drawing drawing = draw_tree(instance);
    const std::size_t ends = count_ends(tree), figures = tree.figures().size();
    CHECK(drawing.name == "tree-" + id);
    // The root lies before the origin is placed.
    CHECK(occurrences(drawing.svg, "class=\"node\"") == tree.nodes.size() - 1 - ends);
    CHECK(occurrences(drawing.svg, "class=\"branch\"") == tree.nodes.size() - 2 - ends);
    CHECK(occurrences(drawing.svg, "class=\"end\"") == ends);
    CHECK(occurrences(drawing.svg, "class=\"number\"") == figures);
    CHECK(occurrences(drawing.svg, "class=\"point\"") == figures * instance.problem.points.size());
    CHECK(occurrences(drawing.svg, "class=\"instruction\"") == tree.plan.instructions().size());
    CHECK((drawing.svg.find("as in the sketch</text>") != std::string::npos));
    CHECK((drawing.svg.find("k1 = ") != std::string::npos) == (tree.plan.driving_parameters() > 0));
    CHECK((drawing.caption.find("mirror images apart") != std::string::npos) ==
          (tree.plan.driving_parameters() == 0));
  }
}

TEST_CASE("the sides of an interpretation tree are told apart") {
  // Of 4 + 4 choices, half on either side; the sketch is on a dashed branch once.
  const std::string svg = draw_tree(load_instance("qk33")).svg;
  const std::string dashed = "stroke-dasharray=\"3 2\"", on_branch = "class=\"branch\" stroke=\"#0072B2\"";
  const InterpretationTree tree = tree_of(load_instance("qk33"));
  std::size_t negative = 0, taken = 0;
  for (std::size_t i = 2; i < tree.nodes.size(); ++i) {
    negative += tree.nodes[i].side < 0 ? 1 : 0;
    taken += tree.nodes[i].is_on_branch && !tree.nodes[i].has_ended() ? 1 : 0;
  }
  CHECK(occurrences(svg, dashed) == negative + 1);  // and in the legend
  CHECK(occurrences(svg, on_branch) == taken);
  CHECK(occurrences(svg, "(sketch)") == 1);
}

TEST_CASE("an interpretation tree names what is special in it alone") {
  const auto is_named = [](const Instance& instance, const char* what) {
    return draw_tree(instance).svg.find(what) != std::string::npos;
  };
  constexpr std::size_t p2_p3 = 1, p1_p3 = 8;
  const Instance usual = load_instance("qk33");
  CHECK(is_named(usual, "circles do not meet"));
  CHECK_FALSE(is_named(usual, "circles touch"));
  // |p1 p2| = 2.58 = 1.85 + 0.73
  CHECK(is_named(with_length(p1_p3, 0.73), "circles touch"));
  CHECK(is_named(with_length(p1_p3, 0.72), "circles do not meet"));
  CHECK(tree_of(with_length(p1_p3, 0.72)).figures().empty());
  CHECK_FALSE(is_named(with_length(p2_p3, 4), "removed constraint"));
  CHECK(is_named(load_instance("k33"), "removed constraint"));
}

TEST_CASE("given positions are where a tree begins") {
  Instance instance = load_instance("qk33");
  ProblemStatement& problem = instance.problem;
  problem.reference.reset();
  problem.construction.erase(problem.construction.begin());
  problem.constraints.erase(problem.constraints.begin());
  for (PlanStep& step : problem.construction)
    for (PlanStep::Radius& radius : step.from) --radius.constraint;
  problem.fixed_points = {problem.sketch->points.col(0), problem.sketch->points.col(1), {}, {}, {}, {}};
  const InterpretationTree tree = tree_of(instance);
  const Drawing drawing = draw_tree(instance);
  CHECK(occurrences(drawing.svg, "given positions") == 1);
  CHECK(occurrences(drawing.svg, "class=\"node\"") == tree.nodes.size() - count_ends(tree));
  CHECK(drawing.caption.find("mirror") == std::string::npos);
}

TEST_CASE("what is not drawn as a tree is refused with the reason") {
  const auto reason = [](const char* id) { return why_no_tree(load_instance(id)).value_or(""); };
  CHECK_THAT(reason("dodecagon"), Catch::Contains("10 times") && Catch::Contains("5 choices"));
  CHECK_THAT(reason("icosahedron"), Catch::Contains("9 times"));
  CHECK_THAT(reason("prism"), Catch::Contains("sketch"));
  CHECK_THAT(reason("hoffmann-yuan"), Catch::Contains("lines"));
  CHECK(reason("qk33").empty());
}
