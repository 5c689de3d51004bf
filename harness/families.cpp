#include "harness/families.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/long_decimal.hpp"

namespace gcs {
namespace {

/// Of squared lengths: what is rounded off matters to no double, and to no ε of the families.
constexpr int digits = 50;

using Point = std::array<LongDecimal, 3>;
using Edge = std::array<int, 2>;

/// A scene on its way to a file. Points are p1, p2, …; squared lengths go with the edges.
struct Draft {
  int dimension = 3;
  std::vector<Edge> edges;
  std::vector<LongDecimal> squares;
  std::vector<std::array<double, 3>> sketch;
  std::string interpolation;  ///< as JSON; empty: the default
  std::vector<std::string>
      centres;  ///< given positions as JSON, in place of a sketch; edges join them to a line
};

LongDecimal squared_distance(const Point& a, const Point& b) {
  LongDecimal square(0.0);
  for (std::size_t axis = 0; axis < 3; ++axis) square = square + (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return square;
}

std::vector<LongDecimal> squares_of(const std::vector<Point>& points, const std::vector<Edge>& edges) {
  std::vector<LongDecimal> squares;
  for (const auto& [a, b] : edges)
    squares.push_back(
        squared_distance(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]));
  return squares;
}

std::string point_name(int number) { return fmt::format("\"p{}\"", number + 1); }

std::string sketch_text(const Draft& draft) {
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < draft.sketch.size(); ++i) {
    const auto& p = draft.sketch[i];
    entries.push_back(point_name(static_cast<int>(i)) +
                      (draft.dimension == 2 ? fmt::format(": [{}, {}]", p[0], p[1])
                                            : fmt::format(": [{}, {}, {}]", p[0], p[1], p[2])));
  }
  return fmt::format("{}", fmt::join(entries, ", "));
}

/// `given`: what a constraint states, "squared" or "length".
std::string text_of(const std::string& id, const Draft& draft, std::string_view given = "squared") {
  const bool has_line = !draft.centres.empty();
  const auto points = static_cast<int>(has_line ? draft.centres.size() : draft.sketch.size());
  std::vector<std::string> names, constraints, fixed;
  for (int i = 0; i < points; ++i) names.push_back(point_name(i));
  for (std::size_t e = 0; e < draft.edges.size(); ++e)
    constraints.push_back(fmt::format(R"({{"id": "a{}", "type": "distance", "between": [{}, {}], "{}": {}}})",
                                      e + 1, point_name(draft.edges[e][0]),
                                      has_line ? "\"L\"" : point_name(draft.edges[e][1]), given,
                                      draft.squares[e].text(digits)));
  for (int i = 0; has_line && i < points; ++i)
    fixed.push_back(point_name(i) + ": " + draft.centres[static_cast<std::size_t>(i)]);
  std::string more;
  if (has_line) more = fmt::format(", \"lines\": [\"L\"], \"fixed\": {{{}}}", fmt::join(fixed, ", "));
  if (!draft.sketch.empty()) more += fmt::format(", \"sketch\": {{{}}}", sketch_text(draft));
  if (!draft.interpolation.empty()) more += ", \"interpolation\": " + draft.interpolation;
  return fmt::format(
      R"({{"format": "gcsbench-instance/1", "id": "{}", "dimension": {}, "points": [{}], "constraints": [{}]{}}})",
      id, draft.dimension, fmt::join(names, ", "), fmt::join(constraints, ", "), more);
}

/// All pairs of six points but 1–4, 2–5 and 3–6.
const std::vector<Edge>& octahedron_edges() {
  static const std::vector<Edge> edges{{0, 1}, {0, 2}, {0, 4}, {0, 5}, {1, 2}, {1, 3},
                                       {1, 5}, {2, 3}, {2, 4}, {3, 4}, {3, 5}, {4, 5}};
  return edges;
}

// ---- flat figures and folds

std::string flat_triangle(const std::string& id, const std::string& epsilon) {
  const std::vector<Point> points{{"0", "0", "0"}, {"2", "0", "0"}, {"1", epsilon, "0"}, {"3", "1", "0"}};
  Draft draft{2, {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}, {}, {{0, 0}, {2, 0}, {0.8, 1}, {2.7, 1.2}}, "",
              {}};
  draft.squares = squares_of(points, draft.edges);
  return text_of(id, draft);
}

const std::vector<Edge>& tetrahedra_edges() {
  static const std::vector<Edge> edges{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3},
                                       {2, 3}, {1, 4}, {2, 4}, {3, 4}};
  return edges;
}

Draft tetrahedra(const LongDecimal& height) {
  const std::vector<Point> points{
      {"0", "0", "0"}, {"2", "0", "0"}, {"0.7", "1.8", "0"}, {"0.9", "0.6", height}, {"2.1", "1.9", "0.8"}};
  Draft draft{
      3, tetrahedra_edges(), {}, {{0, 0, 0}, {2, 0, 0}, {0.7, 1.8, 0}, {0.9, 0.6, 1}, {2, 1.7, 1}}, "", {}};
  draft.squares = squares_of(points, draft.edges);
  return draft;
}

std::string flat_tetrahedron(const std::string& id, const std::string& epsilon) {
  return text_of(id, tetrahedra(epsilon));
}

/// The apex of the first tetrahedron is at the height √−ε.
std::string infeasible(const std::string& id, const std::string& epsilon) {
  Draft draft = tetrahedra("0");
  for (const int edge : {3, 4, 5}) {
    LongDecimal& square = draft.squares[static_cast<std::size_t>(edge)];
    square = square - LongDecimal(epsilon);
  }
  return text_of(id, draft);
}

/// Six points on a circle make K3,3 infinitesimally flexible (Bolker, Roth 1980); the last is ε outside.
std::string double_root(const std::string& id, const std::string& epsilon) {
  const LongDecimal out = LongDecimal("5") + LongDecimal(epsilon);
  const std::vector<Point> points{{"5", "0", "0"},  {"3", "4", "0"},   {"-3", "4", "0"},
                                  {"-5", "0", "0"}, {"-4", "-3", "0"}, {"0", LongDecimal("0") - out, "0"}};
  Draft draft{2,  {{0, 1}, {0, 3}, {0, 5}, {2, 1}, {2, 3}, {2, 5}, {4, 1}, {4, 3}, {4, 5}},
              {}, {{5, 0.4}, {2.5, 4}, {-3, 3.2}, {-5.2, 0.3}, {-4, -2.5}, {0.6, -5.3}},
              "", {}};
  draft.squares = squares_of(points, draft.edges);
  return text_of(id, draft);
}

/// Half-way between sketch and target the triangle is flat but for ε: there the path and its mirror image
/// come within about √ε of each other.
std::string near_miss(const std::string& id, const std::string& epsilon) {
  const LongDecimal bend = LongDecimal("4") * (LongDecimal("1.2") - LongDecimal(epsilon));
  const Draft draft{2,
                    {{0, 1}, {0, 2}, {1, 2}},
                    {"1", "1", "1.2"},
                    {{0, 0}, {1, 0}, {0.28, 0.96}},
                    fmt::format(R"({{"bent": "a1", "bend": {}}})", bend.text(20)),
                    {}};
  return text_of(id, draft, "length");
}

// ---- common tangents

std::string tangents(const std::string& id, const std::vector<Point>& centres,
                     const std::vector<LongDecimal>& squares) {
  Draft draft{3, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, squares, {}, "", {}};
  for (const Point& c : centres)
    draft.centres.push_back(
        fmt::format("[{}, {}, {}]", c[0].text(digits), c[1].text(digits), c[2].text(digits)));
  return text_of(id, draft);
}

std::string coplanar_centres(const std::string& id, const std::string& epsilon) {
  return tangents(id, {{"0", "0", "0"}, {"4", "0", "0"}, {"1", "3", "0"}, {"2.5", "1.7", epsilon}},
                  {"1", "1.21", "0.81", "1.44"});
}

std::string collinear_centres(const std::string& id, const std::string& epsilon) {
  const LongDecimal up(epsilon);
  return tangents(id, {{"0", "0", "0"}, {"2", up, "0"}, {"5", "0", up}, {"7", LongDecimal("0") - up, up}},
                  {"1", "1.21", "1.96", "0.81"});
}

std::string touching_spheres(const std::string& id, const std::string& epsilon) {
  const LongDecimal more = LongDecimal("2") + LongDecimal(epsilon);
  return tangents(id, {{"1", "1", "1"}, {"1", "-1", "-1"}, {"-1", "1", "-1"}, {"-1", "-1", "1"}},
                  {more, "2", more, "2"});
}

// ---- octahedra

const std::vector<std::array<double, 3>>& octahedron_sketch() {
  static const std::vector<std::array<double, 3>> sketch{{0, 0, 0},       {1, 0, 0},     {0.5, 1.3, 0},
                                                         {1.2, 0.5, 1.5}, {0, 1.8, 0.9}, {-0.2, -0.7, 1.3}};
  return sketch;
}

/// The lengths of the shipped octahedron.
const std::vector<double>& octahedron_lengths() {
  static const std::vector<double> lengths{1.1, 1.3, 1.7, 1.6, 1.2, 1.8, 1.6, 1.7, 1.3, 1.9, 2.2, 2.7};
  return lengths;
}

std::string scaled_octahedron(const std::string& id, double scale) {
  Draft draft{3, octahedron_edges(), {}, octahedron_sketch(), fmt::format(R"({{"bend": {}}})", 2 * scale),
              {}};
  for (const double length : octahedron_lengths()) draft.squares.emplace_back(length * scale);
  for (auto& point : draft.sketch)
    for (double& x : point) x *= scale;
  return text_of(id, draft, "length");
}

std::string scale_of_two(const std::string& id, const std::string& exponent) {
  return scaled_octahedron(id, std::ldexp(1.0, std::stoi(exponent)));
}

std::string scale_of_ten(const std::string& id, const std::string& exponent) {
  return scaled_octahedron(id, std::stod("1e" + exponent));
}

std::string octahedron_at(const std::string& id, const std::vector<Point>& points) {
  Draft draft{3, octahedron_edges(), {}, octahedron_sketch(), "", {}};
  draft.squares = squares_of(points, draft.edges);
  return text_of(id, draft);
}

std::string short_edge(const std::string& id, const std::string& epsilon) {
  return octahedron_at(id, {{"0", "0", "0"},
                            {epsilon, "0", "0"},
                            {"0.5", "1.3", "0"},
                            {"1.1", "0.6", "1.4"},
                            {"0.1", "1.7", "1"},
                            {"-0.3", "-0.6", "1.2"}});
}

/// At ε = 0 the closed chain of the edges 1–2, 2–4, 4–5 and 5–1 can be stretched flat, 1.8 + 1.8 = 1.9 + 1.7,
/// and a complex solution is at infinity; else it is as far away as about 1/√ε.
std::string escaping(const std::string& id, const std::string& epsilon) {
  Draft draft{3, octahedron_edges(), {}, octahedron_sketch(), "", {}};
  for (const double length : octahedron_lengths()) draft.squares.emplace_back(fmt::format("{}", length));
  draft.squares[0] = LongDecimal("1.8") + LongDecimal(epsilon);
  return text_of(id, draft, "length");
}

/// Cyclohexane's octahedron, whose solutions share diagonals, with edges of slightly different lengths.
std::string cyclohexane(const std::string& id, const std::string& epsilon) {
  static const std::vector<const char*> shifts{"0.31", "-0.17", "0.23", "0.05", "-0.29", "0.11",
                                               "0.19", "-0.07", "0.13", "0.02", "-0.21", "0.27"};
  Draft draft{3, octahedron_edges(), {}, octahedron_sketch(), "", {}};
  for (std::size_t e = 0; e < 12; ++e)
    draft.squares.push_back(LongDecimal(e < 9 ? "4" : "3") + LongDecimal(epsilon) * LongDecimal(shifts[e]));
  return text_of(id, draft);
}

/// A half-turn about the z-axis carries three points to the opposite ones: Bricard's first type, which moves.
/// Here one squared edge is longer by ε.
std::string bricard(const std::string& id, const std::string& epsilon) {
  const std::vector<Point> points{{"1", "0.3", "0.2"},   {"0.2", "1.1", "-0.5"},   {"0.6", "-0.7", "0.9"},
                                  {"-1", "-0.3", "0.2"}, {"-0.2", "-1.1", "-0.5"}, {"-0.6", "0.7", "0.9"}};
  Draft draft{3, octahedron_edges(), {}, octahedron_sketch(), "", {}};
  draft.squares = squares_of(points, draft.edges);
  draft.squares.back() = draft.squares.back() + LongDecimal(epsilon);
  return text_of(id, draft);
}

}  // namespace

std::vector<std::string> Family::members() const {
  std::vector<std::string> ids;
  for (const std::string& value : values) ids.push_back(fmt::format("{}@{}", name, value));
  return ids;
}

std::span<const Family> families() {
  static const std::vector<std::string> shrinking{"0.5",  "1e-1",  "1e-2",  "1e-4", "1e-6",
                                                  "1e-8", "1e-10", "1e-12", "1e-15"};
  /// Half a unit would leave triangles that cannot close.
  static const std::vector<std::string> shrinking_from_less{"0.25", "1e-1",  "1e-2",  "1e-4", "1e-6",
                                                            "1e-8", "1e-10", "1e-12", "1e-15"};
  static const std::vector<std::string> shrinking_to_zero{"0.5",  "1e-1",  "1e-2",  "1e-4",  "1e-6",
                                                          "1e-8", "1e-10", "1e-12", "1e-15", "0"};
  static const std::array all{
      Family{"flat-triangle", "a triangle of height ε: nearly tangent circles", shrinking, flat_triangle},
      Family{"flat-tetrahedron", "a tetrahedron of height ε: nearly tangent spheres", shrinking,
             flat_tetrahedron},
      Family{"infeasible", "a tetrahedron of height √−ε: no real solution", shrinking_from_less, infeasible},
      Family{"double-root", "K3,3 with six points on a circle but for ε", shrinking, double_root},
      Family{"near-miss", "a path that passes its mirror image at about √ε", shrinking, near_miss},
      Family{"coplanar-centres", "tangents of spheres whose centres lie in a plane but for ε", shrinking,
             coplanar_centres},
      Family{"collinear-centres", "tangents of spheres whose centres lie on a line but for ε", shrinking,
             collinear_centres},
      Family{"touching-spheres", "tangents of spheres that touch but for ε", shrinking, touching_spheres},
      Family{"cyclohexane", "an octahedron with solutions that share diagonals but for ε", shrinking,
             cyclohexane},
      Family{"short-edge", "an octahedron with an edge of length ε", shrinking, short_edge},
      Family{"escaping", "an octahedron with solutions at infinity but for ε", shrinking_to_zero, escaping},
      Family{"bricard", "an octahedron that moves but for ε", shrinking_to_zero, bricard},
      Family{"scale-of-two",
             "the octahedron times 2^k",
             {"0", "100", "-100", "500", "-500", "1000", "-1000"},
             scale_of_two},
      Family{"scale-of-ten", "the octahedron times 10^k", {"0", "100", "-100"}, scale_of_ten},
  };
  return all;
}

const Family* find_family(std::string_view name) {
  const auto all = families();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Family& family) { return family.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Instance load_member(const std::string& id) {
  const std::size_t at = id.find('@');
  return parse_instance(find_family(id.substr(0, at))->text(id, id.substr(at + 1)), id, "");
}

}  // namespace gcs
