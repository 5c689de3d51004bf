/// Minimally rigid graphs of the plane with random lengths, as they are and as cones in space: all points at the distance
/// 1 from a further one are on a sphere, and the distances between them are their lengths there.

#include "harness/instances/families_graphs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "harness/instances/family_draft.hpp"
#include "harness/instances/family_lists.hpp"
#include "solvers/counting/laman_graphs.hpp"

namespace gcs {
namespace {

/// Their numbers of realisations are those of OEIS A306420, which has no graph, and whose codes 64 bits do not hold: found by
/// Henneberg's steps from twelve points.
const GraphEdges most_of_thirteen{{7, 8}, {6, 9},  {5, 10}, {4, 8},  {4, 6},  {4, 5},   {3, 9}, {3, 7},
                                  {3, 5}, {2, 10}, {2, 8},  {2, 6},  {1, 10}, {1, 9},   {1, 7}, {0, 9},
                                  {0, 8}, {5, 11}, {0, 11}, {6, 11}, {0, 12}, {10, 12}, {7, 12}};

const GraphEdges most_of_fourteen{{8, 9},  {7, 10}, {6, 11},  {5, 8},  {5, 7},  {4, 9},  {4, 7},
                                  {4, 6},  {3, 10}, {3, 8},   {3, 6},  {2, 11}, {2, 9},  {2, 7},
                                  {1, 11}, {1, 10}, {1, 8},   {0, 10}, {0, 9},  {5, 12}, {6, 12},
                                  {0, 12}, {0, 13}, {11, 13}, {5, 13}};

/// Of so many points a graph with most realisations in the plane: from six on Capco et al. 2018, table 1.
GraphEdges graph_with_most(int points) {
  if (points == 13) return most_of_thirteen;
  if (points == 14) return most_of_fourteen;
  static const std::map<int, std::uint64_t> codes{{3, 0b111},
                                                  {4, 0b111110},
                                                  {5, 0b1111111000},
                                                  {6, 7916},
                                                  {7, 1269995},
                                                  {8, 170989214},
                                                  {9, 11177989553},
                                                  {10, 4778440734593},
                                                  {11, 18120782205838348},
                                                  {12, 252590061719913632}};
  return graph_of_code(points, codes.at(points));
}

/// Squares of lengths between 1 and 2, any three of which make a triangle.
std::vector<LongDecimal> random_squares(const std::string& id, std::size_t count) {
  std::seed_seq seed(id.begin(), id.end());
  std::mt19937_64 random(seed);
  std::vector<LongDecimal> squares;
  for (std::size_t i = 0; i < count; ++i) squares.emplace_back(fmt::format("1.{:06}", random() % 1'000'000));
  return squares;
}

Draft in_plane(const std::string& id, const GraphMember& graph) {
  return {.dimension = 2,
          .points = graph.points,
          .edges = graph.edges,
          .squares = random_squares(id, graph.edges.size())};
}

Draft as_cone(const std::string& id, const GraphMember& graph) {
  Draft draft = in_plane(id, graph);
  draft.dimension = 3;
  for (int point = 0; point < graph.points; ++point) {
    draft.edges.push_back({point, graph.points});
    draft.squares.emplace_back("1");
  }
  ++draft.points;
  return draft;
}

std::string graph_text(const std::string& id, const std::string&) {
  const GraphMember graph = *graph_member(id);
  return text_of(id, graph.is_on_sphere ? as_cone(id, graph) : in_plane(id, graph));
}

/// 1, 2, …
std::vector<std::string> numbers_from(int first, int last) {
  std::vector<std::string> numbers;
  for (int number = first; number <= last; ++number) numbers.push_back(fmt::format("{}", number));
  return numbers;
}

/// All graphs of 6, 7 and 8 points: found when they are first asked for.
const std::vector<GraphEdges>& graphs_of(int points) {
  static const std::array all{all_laman_graphs(6), all_laman_graphs(7), all_laman_graphs(8)};
  return all.at(static_cast<std::size_t>(points - 6));
}

}  // namespace

std::span<const InstanceFamily> graph_families() {
  static const std::vector<InstanceFamily> all{
      {"laman-6", "the minimally rigid graphs of 6 points in the plane", numbers_from(1, 13), graph_text},
      {"laman-7", "those of 7 points", numbers_from(1, 70), graph_text},
      {"laman-8", "those of 8 points", numbers_from(1, 608), graph_text},
      {"laman-most", "a graph of n points with most realisations in the plane", numbers_from(3, 14),
       graph_text},
      {"sphere-6", "those of 6 points on a sphere, a cone in space", numbers_from(1, 13), graph_text},
      {"sphere-7", "those of 7 points on a sphere", numbers_from(1, 70), graph_text},
      {"sphere-8", "those of 8 points on a sphere", numbers_from(1, 608), graph_text},
      {"sphere-most", "the graph of n points with most realisations in the plane, on a sphere",
       numbers_from(6, 12), graph_text}};
  return all;
}

std::optional<GraphMember> graph_member(const std::string& id) {
  const auto families = graph_families();
  const auto found = std::find_if(families.begin(), families.end(), [&](const InstanceFamily& family) {
    return id.starts_with(std::string(family.name) + "@");
  });
  if (found == families.end()) return std::nullopt;
  const int number = std::stoi(id.substr(found->name.size() + 1));
  GraphMember member{.points = number, .edges = {}, .is_on_sphere = found->name.starts_with("sphere")};
  if (found->name.ends_with("most")) {
    member.edges = graph_with_most(number);
    return member;
  }
  member.points = found->name.back() - '0';
  member.edges = graphs_of(member.points).at(static_cast<std::size_t>(number - 1));
  return member;
}

}  // namespace gcs
