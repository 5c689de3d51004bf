#include "harness/drawings/graph_drawing.hpp"

#include <fmt/format.h>

#include <functional>
#include <set>

#include "harness/base/text_width.hpp"
#include "harness/drawings/html_text.hpp"
#include "solvers/elements/constraint_types.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/reading/relation_words.hpp"

namespace gcs {
namespace {

// In points; 85 mm are 241 points.
constexpr double width = 241, margin = 18, font = 8;

/// With more, their names would hide the graph.
constexpr std::size_t most_named_constraints = 21;

Eigen::Vector2d on_page(const Eigen::Vector2d& place) {
  return Eigen::Vector2d(margin, margin) + (width - 2 * margin) * Eigen::Vector2d(place.x(), 1 - place.y());
}

/// Those that stay where they are: the frame, or what has a given position.
std::set<int> held(const ProblemStatement& problem) {
  std::set<int> entities;
  for (int e = 0; e < problem.entity_count(); ++e)
    if (problem.is_fixed(e)) entities.insert(e);
  const Scene scene = Scene::unchecked(problem);
  if (scene.is_anchored()) return entities;
  if (problem.reference_body >= 0) {
    const auto members = entities_of(problem.bodies[static_cast<std::size_t>(problem.reference_body)]);
    return {members.begin(), members.end()};
  }
  const Reference& frame = scene.reference();
  for (const int e : {frame.origin, frame.axis, frame.plane, frame.line, frame.height})
    if (e >= 0) entities.insert(e);
  return entities;
}

std::set<int> bent_constraints(const ProblemStatement& problem) {
  std::set<int> bent;
  if (problem.sketch)
    for (const BentLength& length : bent_lengths(problem)) bent.insert(length.constraint);
  return bent;
}

void add_pair(const Relation& relation, std::vector<GraphEdge>& edges) {
  for (const int a : entities_of({relation.of[0]}))
    for (const int b : entities_of({relation.of[1]}))
      if (a != b) edges.push_back({{a, b}, relation.id});
}

void add_row(const Relation& relation, std::vector<GraphEdge>& edges) {
  for (std::size_t i = 1; i < relation.of.size(); ++i)
    edges.push_back({{relation.of[i - 1].entity, relation.of[i].entity}, relation.id});
}

/// Between all elements of bodies.
std::string bodies_svg(const ProblemStatement& problem, const std::function<Eigen::Vector2d(int)>& place) {
  std::string text;
  for (const RigidBody& body : problem.bodies)
    for (const int a : entities_of(body))
      for (const int b : entities_of(body)) {
        if (a >= b) continue;
        const Eigen::Vector2d p = place(a), q = place(b);
        text +=
            fmt::format("<line class=\"body\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                        p.x(), p.y(), q.x(), q.y());
      }
  return text.empty() ? "" : "<g stroke=\"#BBBBBB\" stroke-width=\"0.6\">\n" + text + "</g>\n";
}

std::string edge_svg(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool is_bent) {
  return fmt::format("<line class=\"edge\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"{}/>\n",
                     a.x(), a.y(), b.x(), b.y(),
                     is_bent ? " stroke-dasharray=\"4 2.5\" stroke-width=\"1.6\"" : "");
}

/// To the right of its entity, or to the left where there is no room.
std::string node_name(const Eigen::Vector2d& p, const std::string& name) {
  constexpr double letter = 5.2, aside = 5.5;
  const bool is_left = p.x() + aside + letter * static_cast<double>(display_width(name)) > width;
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" stroke=\"#FFFFFF\" stroke-width=\"2.5\" "
      "paint-order=\"stroke\" font-weight=\"bold\">{}</text>\n",
      is_left ? p.x() - aside : p.x() + aside, p.y() - 4, is_left ? "end" : "start", html_escaped(name));
}

std::string node_svg(const Eigen::Vector2d& p, OperandKind kind, bool is_held) {
  const std::string fill = is_held ? "#000000" : "#0072B2";
  if (kind == OperandKind::plane)
    return fmt::format("<path class=\"node\" d=\"M{:.1f} {:.1f}l5 9h-10z\" fill=\"{}\"/>\n", p.x(), p.y() - 5,
                       fill);
  if (kind == OperandKind::line)
    return fmt::format(
        "<rect class=\"node\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\" fill=\"{}\"/>\n", p.x() - 4,
        p.y() - 4, fill);
  return fmt::format("<circle class=\"node\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", p.x(),
                     p.y(), fill);
}

std::string edge_name(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const std::string& name) {
  // Off the middle, where edges of symmetric graphs meet.
  const Eigen::Vector2d p = a + 0.36 * (b - a);
  return fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"6.5\" fill=\"#444444\" "
      "stroke=\"#FFFFFF\" "
      "stroke-width=\"2\" paint-order=\"stroke\">{}</text>\n",
      p.x(), p.y() + 2.2, html_escaped(name));
}

}  // namespace

std::vector<int> entities_of(const RigidBody& body) {
  std::vector<int> entities;
  for (const BodyElement& element : body.elements) entities.push_back(element.entity);
  return entities;
}

std::vector<GraphEdge> graph_edges(const ProblemStatement& problem) {
  std::vector<GraphEdge> edges;
  for (const DistanceConstraint& c : problem.constraints) edges.push_back({c.between, c.id});
  for (const Relation& relation : problem.relations) {
    if (!find_constraint_type(relation.type)->is_of_points())
      add_pair(relation, edges);
    else if (relation.sign == 0)
      add_row(relation, edges);
  }
  return edges;
}

std::string graph_svg(const ProblemStatement& problem, const std::string& title) {
  const Eigen::Matrix2Xd layout = graph_layout(problem);
  const auto place = [&](int entity) { return on_page(layout.col(entity)); };
  const std::set<int> bent = bent_constraints(problem);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"85mm\" height=\"85mm\" viewBox=\"0 0 {0} {0}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{1}\" role=\"img\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{0}\" fill=\"#FFFFFF\"/>\n{3}<g stroke=\"#555555\" stroke-width=\"1\">\n",
      width, font, html_escaped(title), bodies_svg(problem, place));
  const std::vector<GraphEdge> edges = graph_edges(problem);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b] = edges[i].between;
    text += edge_svg(place(a), place(b), bent.count(static_cast<int>(i)) > 0);
  }
  text += "</g>\n";
  if (edges.size() <= most_named_constraints)
    for (const GraphEdge& edge : edges)
      text += edge_name(place(edge.between[0]), place(edge.between[1]), edge.name);
  const std::set<int> dark = held(problem);
  for (int e = 0; e < problem.entity_count(); ++e)
    text +=
        node_svg(place(e), kind_of(problem, {e}), dark.count(e) > 0) + node_name(place(e), problem.name(e));
  return text + "</svg>\n";
}

}  // namespace gcs
