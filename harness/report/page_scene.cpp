#include "harness/report/page_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/drawings/graph_drawing.hpp"
#include "harness/drawings/html_text.hpp"
#include "harness/drawings/path_drawing.hpp"
#include "harness/drawings/reduced_path_drawing.hpp"
#include "harness/drawings/tree_drawing.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {
namespace {

std::string figure_html(const std::string& svg, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", svg, html_escaped(caption));
}

std::string fact(std::string_view name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html_escaped(value));
}

std::string_view completeness(const ShownScene& record) {
  if (record.is_real_proven) return "that there are no more is proven";
  return record.has_all_real ? "that there are no more is found, not proven" : "there may be more";
}

std::string solutions_fact(const ShownScene& record) {
  if (!can_be_drawn(record.instance.problem)) return "not stored: " + record.no_path;
  if (record.solutions.empty()) return record.is_real_proven ? "none, which is proven" : "none is known";
  return fmt::format("{}, {}({}); {}", record.solutions.size(), record.are_proven ? "each certified " : "",
                     record.source, completeness(record));
}

std::string path_fact(const StoredScene& scene) {
  if (!scene.path)
    return "not stored: " + (scene.record.no_path.empty() ? "its file is missing" : scene.record.no_path);
  return fmt::format(
      "proven, closed, length {:.6g}, {} crossings of t = 1; drawn to {:g} of the scene's size",
      scene.path->length, scene.path->crossings.size(), scene.path->within);
}

std::string entities_fact(const ProblemStatement& problem) {
  std::string text = fmt::format("{} points", problem.points.size());
  if (!problem.lines.empty()) text += fmt::format(", lines: {}", problem.lines.size());
  if (!problem.planes.empty()) text += fmt::format(", planes: {}", problem.planes.size());
  for (const RigidBody& body : problem.bodies) {
    std::vector<std::string> names;
    for (const int entity : entities_of(body)) names.push_back(problem.name(entity));
    text += fmt::format("; body {}: {}", body.name, fmt::join(names, ", "));
  }
  return text;
}

/// "12 distances, angle: 3".
std::string constraints_fact(const ProblemStatement& problem) {
  std::size_t distances = problem.constraints.size();
  std::map<std::string, int> others;
  for (const Relation& relation : problem.relations) {
    if (relation.type == "distance")
      ++distances;
    else
      ++others[relation.type];
  }
  std::string text = fmt::format("{} {}", distances, distances == 1 ? "distance" : "distances");
  for (const auto& [type, count] : others) text += fmt::format(", {}: {}", type, count);
  return text;
}

std::string facts(const StoredScene& scene) {
  const Instance& instance = scene.record.instance;
  const ProblemStatement& problem = instance.problem;
  std::string text = "<dl class=\"facts\">\n";
  text += fact("dimension", std::to_string(problem.dimension));
  text += fact("entities", entities_fact(problem));
  text += fact("constraints", constraints_fact(problem));
  if (problem.is_general()) text += fact("counted", std::string(word(convention_of(problem))));
  text += fact("real solutions", solutions_fact(scene.record));
  text += fact("path S", path_fact(scene));
  for (const ShownCurve& curve : scene.record.curves)
    if (!curve.from) text += fact("moves", curve.label);
  if (!instance.notes.empty()) text += fact("notes", instance.notes);
  return text + "</dl>\n";
}

std::string graph_html(const StoredScene& scene) {
  const Instance& instance = scene.record.instance;
  if (!can_be_drawn(instance.problem))
    return fmt::format(
        "<p class=\"missing\">The constraint graph is not drawn: it has more than {} entities.</p>\n",
        most_drawn_entities);
  std::string caption = "Constraint graph. Black: what fixes the frame, or is given.";
  if (!instance.problem.lines.empty()) caption += " Squares: lines.";
  if (!instance.problem.planes.empty()) caption += " Triangles: planes.";
  if (!instance.problem.bodies.empty()) caption += " Grey lines: rigid bodies.";
  if (instance.problem.sketch) {
    const std::size_t bent = bent_lengths(instance.problem).size();
    if (bent == 1) caption += " Dashed: the constraint whose length is bent along S.";
    if (bent > 1) caption += " Dashed: the constraints whose lengths are bent along S.";
  }
  return figure_html(graph_svg(instance.problem, "Constraint graph of " + instance.id), caption);
}

constexpr std::string_view figure_part = R"(<div>
<svg class="view" data-part="view" viewBox="0 0 320 320" tabindex="0" role="img" aria-label="{label}"></svg>
<div class="controls" data-part="controls">
<label>Show <select data-part="goal"></select></label>
<div class="row" data-part="along"><label class="way"><span data-part="way">Along S</span> <input type="range" data-part="slider" min="0" max="10000" step="any" value="10000" aria-label="place on the way"></label>
<button type="button" data-part="play">Move</button></div>
<p class="where" data-part="where"></p>
<ul class="legend" data-part="legend"></ul>
</div>
</div>
)";

constexpr std::string_view graph_part = R"(<h4>From solution to solution</h4>
<div class="controls"><div class="row"><label>Curves <select data-part="edges"></select></label></div></div>
<svg class="graph" data-part="graph" viewBox="0 0 520 520" role="img" aria-label="{label}"></svg>
<p class="where">A click on a solution shows it, one on a curve moves the figure along it, without the value in its colour. The list above has them all too.</p>
<ul class="legend" data-part="constraints"></ul>
)";

constexpr std::string_view plot_part = R"(<div>
<svg class="plot" data-part="plot" viewBox="0 0 520 320" role="img" aria-label="{label}"></svg>
<ul class="legend">
<li><svg viewBox="0 0 16 12" aria-hidden="true"><rect class="sketch" x="4" y="2" width="8" height="8"/></svg>sketch</li>
<li><svg viewBox="0 0 16 12" aria-hidden="true"><circle class="solution" cx="8" cy="6" r="4"/></svg>solution (t = 1)</li>
<li><svg viewBox="0 0 16 12" aria-hidden="true"><path class="change" d="M8 1l5 5l-5 5l-5 -5z"/></svg>plan changed</li>
<li><svg viewBox="0 0 16 12" aria-hidden="true"><circle class="here" cx="8" cy="6" r="4.5"/></svg>figure shown; click S to move there</li>
</ul>
<div class="controls">
<div class="row"><label>t over <select data-part="coordinate"></select></label>
<label>Plan changes of <select data-part="trail"></select></label></div>
</div>
</div>
)";

std::string with_label(std::string_view part, const std::string& label) {
  std::string text(part);
  const std::string_view place = "{label}";
  text.replace(text.find(place), place.size(), html_escaped(label));
  return text;
}

std::string coordinates_html(const ProblemStatement& problem) {
  std::string now, listed;
  for (const char axis : std::string_view("xyz").substr(0, static_cast<std::size_t>(problem.dimension))) {
    now += fmt::format("<th scope=\"col\">{}</th>", axis);
    listed += fmt::format("<th scope=\"col\">{}</th>", axis);
  }
  return fmt::format(
      "<details><summary>Coordinates</summary><div class=\"scroll\"><table>\n<thead><tr><th class=\"stub\" "
      "scope=\"col\" rowspan=\"2\"></th><th class=\"group\" scope=\"colgroup\" "
      "colspan=\"{0}\"><span>shown</span></th>"
      "<th class=\"group\" scope=\"colgroup\" colspan=\"{0}\"><span>solution as listed</span></th></tr>"
      "<tr>{1}{2}</tr></thead>\n<tbody data-part=\"coordinates\"></tbody>\n</table></div></details>\n",
      problem.dimension, now, listed);
}

std::string gallery_html(const ShownScene& record) {
  return fmt::format(
      "<div{}><h4>Real solutions</h4>\n<div class=\"gallery\" data-part=\"gallery\"></div>\n"
      "<p class=\"where\" data-part=\"more\"></p></div>\n",
      record.solutions.empty() ? " hidden" : "");
}

std::string solution_graph_html(const ShownScene& record) {
  const auto is_edge = [](const ShownCurve& curve) { return curve.from.has_value(); };
  if (std::ranges::none_of(record.curves, is_edge)) return "";
  return with_label(graph_part, "Solutions of " + record.instance.id +
                                    ", and the curves between them with one value released");
}

/// The figure with the plot of S beside it or, where there is none, the solutions.
std::string panel_html(const StoredScene& scene, std::size_t number) {
  const Instance& instance = scene.record.instance;
  if (!can_be_drawn(instance.problem)) return "";
  if (scene.record.solutions.empty() && scene.record.curves.empty() && !scene.path)
    return fmt::format(
        "<p class=\"missing\">There is no figure to show: {}, and no path is stored.</p>\n",
        scene.record.is_real_proven ? "there is no real solution" : "no real solution is known");
  const std::string turning = instance.problem.dimension == 2
                                  ? "drag or use the arrow keys to turn it in its plane"
                                  : "drag or use the arrow keys to turn it";
  const std::string gallery = gallery_html(scene.record);
  const std::string plot = with_label(plot_part, "The path S of " + instance.id + ": t over a coordinate");
  return fmt::format(
      "<div data-scene=\"{}\">\n<div class=\"panel\">\n{}{}</div>\n{}{}</div>\n", number,
      with_label(figure_part, "Figure of " + instance.id + "; " + turning), scene.path ? plot : gallery,
      (scene.path ? gallery : "") + solution_graph_html(scene.record), coordinates_html(instance.problem));
}

std::string reduced_html(const StoredScene& scene) {
  const auto drawings = draw_reduced_path(scene);
  if (drawings.empty()) return "";
  std::string text = "<h4>Reduced paths</h4>\n<div class=\"figures\">\n";
  for (const Drawing& drawing : drawings) text += figure_html(drawing.svg, drawing.caption);
  return text + "</div>\n";
}

std::string tree_html(const StoredScene& scene) {
  if (why_no_tree(scene.record.instance)) return "";
  const Drawing tree = draw_tree(scene.record.instance);
  return "<h4>Interpretation tree</h4>\n" + figure_html(tree.svg, tree.caption);
}

std::string without_scripts(const StoredScene& scene) {
  if (!scene.path) return "";
  return "<noscript>" + figure_html(draw_path(scene).svg, "The path S.") + "</noscript>\n";
}

}  // namespace

std::vector<Drawing> draw_scene(const StoredScene& scene) {
  const Instance& instance = scene.record.instance;
  std::vector<Drawing> drawings;
  if (can_be_drawn(instance.problem))
    drawings.push_back(
        {"graph-" + instance.id, graph_svg(instance.problem, "Constraint graph of " + instance.id), ""});
  if (!why_no_tree(instance)) drawings.push_back(draw_tree(instance));
  if (!scene.path) return drawings;
  drawings.push_back(draw_path(scene));
  for (Drawing& drawing : draw_reduced_path(scene)) drawings.push_back(std::move(drawing));
  return drawings;
}

std::string scene_html(const StoredScene& scene, std::size_t number) {
  const Instance& instance = scene.record.instance;
  std::string text =
      fmt::format("<section class=\"scene\" id=\"scene-{}\" aria-labelledby=\"scene-{}-title\">\n",
                  html_anchor(instance.id), html_anchor(instance.id));
  text += fmt::format("<h3 id=\"scene-{}-title\">{}{}</h3>\n<div class=\"overview\">\n",
                      html_anchor(instance.id), html_escaped(instance.id),
                      instance.title.empty() ? "" : ": " + html_escaped(instance.title));
  text += graph_html(scene) + facts(scene) + "</div>\n";
  text += panel_html(scene, number) + without_scripts(scene) + reduced_html(scene) + tree_html(scene);
  return text + "</section>\n";
}

std::string missing_scene_html(const std::string& id) {
  return fmt::format(
      "<section class=\"scene\" id=\"scene-{0}\"><h3>{1}</h3>\n<p class=\"missing\">Nothing is stored of "
      "this instance "
      "beside its measurements: the run was interrupted, or made by an earlier version.</p></section>\n",
      html_anchor(id), html_escaped(id));
}

}  // namespace gcs
