#include "harness/drawings/tree_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/base/text_width.hpp"
#include "harness/drawings/configurations_drawing.hpp"
#include "harness/drawings/html_text.hpp"
#include "solvers/construction/derive.hpp"
#include "solvers/construction/interpretation_tree.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {
namespace {

// In points; 170 mm are 482 points.
constexpr double width = 482, margin = 6, row_height = 27, font = 7, letter = 3.6;

/// The numbers of 32 figures have room side by side.
constexpr int most_choices = 5;

/// Four rows: a tree and more figures would not fit on a page.
constexpr std::size_t most_figures = 16;

/// Of the tree: room for the legend.
constexpr double least_left = 110;

/// Letters of a line of the plan; three figures fit beside it.
constexpr std::size_t longest_line = 42;

constexpr const char* grey = "#555555";
constexpr const char* blue = "#0072B2";
constexpr const char* orange = "#D55E00";

/// "+−+" of all instructions that choose, up to a node; 0 where circles touch.
std::string branch_name(const InterpretationTree& tree, int number) {
  std::vector<const char*> signs;
  for (; number > 0; number = tree.nodes[static_cast<std::size_t>(number)].parent) {
    const InterpretationNode& node = tree.nodes[static_cast<std::size_t>(number)];
    if (node.meeting == Meeting::framed) continue;
    signs.push_back(node.side > 0 ? "+" : node.side < 0 ? "−" : "0");
  }
  return fmt::format("{}", fmt::join(signs.rbegin(), signs.rend(), ""));
}

// ---- Where things are

/// Leaves side by side, every other node above the middle of its children.
class TreeLayout {
 public:
  TreeLayout(const InterpretationTree& tree, double left)
      : tree_(tree),
        has_root_(tree.plan.instructions().front().count > 0),
        left_(left),
        slots_(tree.nodes.size(), -1.0) {
    place(0);
  }

  Eigen::Vector2d operator()(std::size_t number) const {
    const double step = (width - margin - left_) / std::max(next_, 1);
    return {left_ + step * (slots_[number] + 0.5), y_of(tree_.nodes[number].instruction)};
  }
  /// Of an instruction's row; −1: the root's.
  double y_of(int instruction) const { return margin + row_height * (instruction + (has_root_ ? 1.5 : 0.5)); }
  /// Whether something is drawn before the first instruction: given positions. A plan that places its origin begins
  /// there.
  bool has_root() const { return has_root_; }
  double bottom() const { return y_of(static_cast<int>(tree_.plan.instructions().size()) - 1) + 17; }

 private:
  void place(std::size_t number) {
    double sum = 0;
    int children = 0;
    for (std::size_t i = number + 1; i < tree_.nodes.size(); ++i) {
      if (tree_.nodes[i].parent != static_cast<int>(number)) continue;
      place(i);
      sum += slots_[i];
      ++children;
    }
    slots_[number] = children > 0 ? sum / children : next_++;
  }

  const InterpretationTree& tree_;
  bool has_root_;
  double left_;
  std::vector<double> slots_;
  int next_ = 0;
};

// ---- The tree

std::string line_svg(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const std::string& style) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", a.x(), a.y(),
                     b.x(), b.y(), style);
}

std::string text_svg(const Eigen::Vector2d& at, const std::string& style, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", at.x(), at.y(), style,
                     html_escaped(text));
}

std::string cross_svg(const Eigen::Vector2d& p, const char* kind) {
  return fmt::format(
      "<path class=\"{}\" d=\"M{:.1f} {:.1f}l5 5m0 -5l-5 5\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"1.2\"/>\n",
      kind, p.x() - 2.5, p.y() - 2.5, orange);
}

/// b_i = +1 is solid and −1 dashed; both at once, where they are one, are a double line.
std::string branch_svg(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const InterpretationNode& node,
                       const char* kind = "branch") {
  if (node.has_ended()) return line_svg(a, b, fmt::format("class=\"ending\" stroke=\"{}\"", orange));
  const double thick = node.is_on_branch ? 1.8 : 0.9;
  const std::string style = fmt::format("class=\"{}\" stroke=\"{}\"", kind, node.is_on_branch ? blue : grey);
  if (node.meeting == Meeting::touching)
    return line_svg(a, b, style + fmt::format(" stroke-width=\"{:.1f}\"", 2 * thick + 1)) +
           line_svg(a, b, "stroke=\"#FFFFFF\" stroke-width=\"1\"");
  return line_svg(
      a, b,
      style + fmt::format(" stroke-width=\"{}\"{}", thick, node.side < 0 ? " stroke-dasharray=\"3 2\"" : ""));
}

std::string node_svg(const Eigen::Vector2d& p, const InterpretationNode& node) {
  if (node.has_ended()) return cross_svg(p, node.meeting == Meeting::apart ? "end" : "end undefined");
  return fmt::format("<circle class=\"node\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", p.x(),
                     p.y(), node.is_on_branch ? 2.8 : 2.2, node.is_on_branch ? blue : "#222222");
}

std::string tree_svg(const InterpretationTree& tree, const TreeLayout& layout) {
  const std::size_t first = layout.has_root() ? 0 : 1;
  std::string branches = "<g fill=\"none\">\n", nodes;
  for (std::size_t i = first; i < tree.nodes.size(); ++i) {
    const InterpretationNode& node = tree.nodes[i];
    if (i > first) branches += branch_svg(layout(static_cast<std::size_t>(node.parent)), layout(i), node);
    nodes += node_svg(layout(i), node);
  }
  std::string numbers;
  const std::vector<int> figures = tree.figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto number = static_cast<std::size_t>(figures[i]);
    numbers += text_svg(layout(number) + Eigen::Vector2d(0, 10), R"( class="number" text-anchor="middle")",
                        std::to_string(i + 1));
  }
  return branches + "</g>\n" + nodes + "<g font-size=\"6\">\n" + numbers + "</g>\n";
}

// ---- The plan, row by row beside the tree

std::string shortened(const std::string& line) {
  if (display_width(line) <= longest_line) return line;
  std::size_t end = 0;
  for (std::size_t letters = 0; letters < longest_line; ++end)
    if ((static_cast<unsigned char>(line[end]) & 0xC0U) != 0x80) ++letters;
  return line.substr(0, end - 1) + "…";
}

std::vector<std::string> plan_lines(const Scene& scene, const Plan& plan) {
  std::vector<std::string> lines = describe_plan(scene, plan);
  for (std::string& line : lines) line = shortened(line);
  return lines;
}

std::string plan_svg(const std::vector<std::string>& lines, const TreeLayout& layout) {
  std::string text;
  const double below = font / 3;
  if (layout.has_root()) text += text_svg({margin, layout.y_of(-1) + below}, "", "given positions");
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += text_svg({margin, layout.y_of(static_cast<int>(i)) + below}, R"( class="instruction")", lines[i]);
  return text;
}

// ---- The figures

/// As seen from the front, the right and above.
Eigen::Matrix3Xd seen(const Eigen::Matrix3Xd& points, int dimension) {
  if (dimension == 2) return points;
  const double turn = 0.5, rise = 0.4;  // radians
  Eigen::Matrix3d view;
  view << std::cos(turn), std::sin(turn), 0,                                              //
      -std::sin(rise) * std::sin(turn), std::sin(rise) * std::cos(turn), std::cos(rise),  //
      0, 0, 0;
  return view * points;
}

std::vector<Configuration> configurations(const InterpretationTree& tree) {
  std::vector<int> figures = tree.figures();
  figures.resize(std::min(figures.size(), most_figures));
  std::vector<Configuration> shown;
  for (const int number : figures) {
    const InterpretationNode& node = tree.nodes[static_cast<std::size_t>(number)];
    shown.push_back({fmt::format("{}: {}{}", shown.size() + 1, branch_name(tree, number),
                                 node.is_on_branch ? " (sketch)" : ""),
                     {seen(node.points, tree.plan.dimension()), {}},
                     {tree.plan.removed().begin(), tree.plan.removed().end()},
                     {}});
  }
  return shown;
}

// ---- The legend

bool has(const InterpretationTree& tree, Meeting meeting) {
  return std::any_of(tree.nodes.begin(), tree.nodes.end(),
                     [&](const InterpretationNode& node) { return node.meeting == meeting; });
}

/// What is seen, drawn from `from` to `to`, and what it means.
struct LegendEntry {
  std::string (*sample)(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  std::string meaning;
};

template <int side, bool is_on_branch, Meeting meeting>
std::string sample_branch(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  InterpretationNode node;
  node.side = side;
  node.is_on_branch = is_on_branch;
  node.meeting = meeting;
  return branch_svg(from, to, node, "sample");
}

std::string sample_cross(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return cross_svg((from + to) / 2, "sample");
}

std::string sample_removed(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return line_svg(from, to, fmt::format("stroke=\"{}\" stroke-dasharray=\"3 2\"", orange));
}

std::string no_sample(const Eigen::Vector2d& /*from*/, const Eigen::Vector2d& /*to*/) { return ""; }

std::vector<LegendEntry> legend(const Scene& scene, const InterpretationTree& tree) {
  std::vector<LegendEntry> entries{{sample_branch<1, false, Meeting::two_points>, "b = +1"},
                                   {sample_branch<-1, false, Meeting::two_points>, "b = −1"},
                                   {sample_branch<1, true, Meeting::two_points>, "as in the sketch"}};
  const std::string spheres = tree.plan.dimension() == 2 ? "circles" : "spheres";
  if (has(tree, Meeting::apart)) entries.push_back({sample_cross, spheres + " do not meet"});
  if (has(tree, Meeting::undefined)) entries.push_back({sample_cross, "or have one centre"});
  if (has(tree, Meeting::touching))
    entries.push_back({sample_branch<0, false, Meeting::touching>, spheres + " touch"});
  if (!tree.plan.removed().empty()) entries.push_back({sample_removed, "removed constraint"});
  for (std::size_t k = 0; k < tree.driven.size(); ++k)
    entries.push_back({no_sample, fmt::format("k{} = {:.4g}, as in the sketch", k + 1,
                                              std::ldexp(tree.driven[k], scene.unit_exponent()))});
  return entries;
}

constexpr double legend_line = 11;

std::string legend_svg(const std::vector<LegendEntry>& entries, double top) {
  std::string text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Eigen::Vector2d from(margin, top + legend_line * (static_cast<double>(i) + 0.5)),
        to = from + Eigen::Vector2d(18, 0);
    const std::string sample = entries[i].sample(from, to);
    text += sample +
            text_svg({sample.empty() ? from.x() : to.x() + 5, from.y() + font / 3}, "", entries[i].meaning);
  }
  return text;
}

std::string caption(const Instance& instance, const InterpretationTree& tree) {
  const std::size_t figures = tree.figures().size();
  std::string text = fmt::format(
      "Interpretation tree of {}: every choice between two intersections, at the given lengths{} (after "
      "Figure 3 "
      "of Imbach, Mathis, Schreck 2016). {} {}",
      instance.id, tree.driven.empty() ? "" : " and with the driving parameters of the sketch", figures,
      figures == 1 ? "figure" : "figures");
  if (!instance.problem.is_anchored() && tree.driven.empty()) text += ", mirror images apart";
  if (figures > most_figures) text += fmt::format(", of which {} are drawn", most_figures);
  return text + ".";
}

double text_width(const std::vector<std::string>& lines) {
  std::size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, display_width(line));
  return letter * static_cast<double>(longest);
}

std::string document(double height, const std::string& title, const std::string& content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"170mm\" height=\"{:.1f}mm\" "
      "viewBox=\"0 0 {} {:.1f}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{}\" "
      "role=\"img\">\n"
      "<title>{}</title>\n<rect width=\"{}\" height=\"{:.1f}\" fill=\"#FFFFFF\"/>\n{}</svg>\n",
      170 * height / width, width, height, font, html_escaped(title), width, height, content);
}

/// The plan beside the tree, and below them the legend beside the figures.
std::string tree_document(const Instance& instance, const Scene& scene, const InterpretationTree& tree,
                          const std::string& title) {
  const std::vector<std::string> lines = plan_lines(scene, tree.plan);
  const double left = std::max(3 * margin + text_width(lines), least_left);
  const TreeLayout layout(tree, left);
  const std::vector<Configuration> shown = configurations(tree);
  const std::vector<LegendEntry> entries = legend(scene, tree);
  const double top = layout.bottom() + margin;
  const int columns = static_cast<int>((width - left) / configuration_panel);
  const double aside = (width - left - columns * configuration_panel) / 2;
  const double figures_height = configuration_panel * std::ceil(static_cast<double>(shown.size()) / columns);
  const double legend_height = legend_line * static_cast<double>(entries.size());
  return document(top + std::max(figures_height, legend_height) + margin, title,
                  plan_svg(lines, layout) + tree_svg(tree, layout) + legend_svg(entries, top) +
                      configuration_panels(instance.problem, shown, columns, {left + aside, top}));
}

}  // namespace

std::optional<std::string> why_no_tree(const Instance& instance) {
  const Scene scene = instance;
  if (const auto reason = why_no_path(scene)) return reason;
  if (const auto reason = why_no_plan(scene)) return reason;
  const int count = choices(first_plan(scene, {}));
  if (count <= most_choices) return std::nullopt;
  return fmt::format(
      "the plan chooses between two intersections {0} times, in up to 2^{0} branches; side by side a page "
      "holds those of {1} choices",
      count, most_choices);
}

Drawing draw_tree(const Instance& instance) {
  const Scene scene = instance;
  const InterpretationTree tree =
      interpretation_tree(scene, first_plan(scene, {}), *scene.sketch(), scene.target_lengths());
  const std::string words = caption(instance, tree);
  return {"tree-" + instance.id, tree_document(instance, scene, tree, words), words};
}

}  // namespace gcs
