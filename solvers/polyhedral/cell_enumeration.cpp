#include "solvers/polyhedral/cell_enumeration.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <random>
#include <utility>

#include "solvers/polyhedral/support_forms.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// A bit per edge of all supports.
using EdgeBits = std::vector<std::uint64_t>;

bool contains(const EdgeBits& bits, int edge) { return (bits[edge / 64] >> (edge % 64) & 1U) != 0; }
void insert(EdgeBits& bits, int edge) { bits[edge / 64] |= std::uint64_t{1} << (edge % 64); }
void erase(EdgeBits& bits, int edge) { bits[edge / 64] &= ~(std::uint64_t{1} << (edge % 64)); }

constexpr std::array<int, 2> not_chosen{-1, -1};

/// Edges of some supports, and where all of them are lowest.
struct Node {
  Dictionary polyhedron;
  CellEdges edges;      ///< not_chosen where there is none yet
  EdgeBits candidates;  ///< that may be lowest somewhere in the polyhedron
  int newest = -1;      ///< the support whose edge was chosen last
};

/// Divided by the largest absolute value.
std::vector<std::vector<double>> normalized(const Lifting& lifting) {
  std::int64_t largest = 1;
  for (const auto& values : lifting)
    for (const std::int64_t value : values) largest = std::max(largest, std::abs(value));
  std::vector<std::vector<double>> result;
  for (const auto& values : lifting) {
    std::vector<double>& quotients = result.emplace_back();
    for (const std::int64_t value : values)
      quotients.push_back(static_cast<double>(value) / static_cast<double>(largest));
  }
  return result;
}

class Enumeration {
 public:
  Enumeration(const Supports& supports, const Lifting& lifting, const std::stop_token& stop);

  std::vector<Node> root() const;
  int levels() const { return static_cast<int>(forms_.size()); }
  /// The nodes with one edge more.
  std::vector<Node> children(Node node, SimplexWork& work) const;
  /// Appends the cells below the node.
  void descend(Node node, EnumeratedCells& found) const;

 private:
  int edge_number(int i, int a, int b) const { return first_edge_[i] + a * forms_[i].points() + b; }
  int candidates_left(const Node& node, int i) const;
  std::vector<int> open_supports(const Node& node) const;
  bool is_affected(const Node& node, int i) const;
  void narrow(Node& node, int i, SimplexWork& work) const;
  int choose_support(Node& node, SimplexWork& work) const;
  void add_candidates(const Node& node, int i, double* target) const;
  bool may_be_independent(const Node& node) const;

  const std::stop_token& stop_;
  std::vector<SupportForms> forms_;
  std::vector<int> first_edge_;    ///< one more than supports
  std::vector<double> weight_of_;  ///< random, one per edge
};

Enumeration::Enumeration(const Supports& supports, const Lifting& lifting, const std::stop_token& stop)
    : stop_(stop), first_edge_{0} {
  const auto heights = normalized(lifting);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    forms_.emplace_back(supports[i], heights[i]);
    first_edge_.push_back(first_edge_.back() + forms_[i].points() * forms_[i].points());
  }
  std::mt19937_64 random(0);
  for (int edge = 0; edge < first_edge_.back(); ++edge)
    weight_of_.push_back(1 + static_cast<double>(random() >> 11U) * 0x1p-53);
}

std::vector<Node> Enumeration::root() const {
  Node node{Dictionary(levels()), CellEdges(forms_.size(), not_chosen),
            EdgeBits(static_cast<std::size_t>(first_edge_.back()) / 64 + 1, 0)};
  for (int i = 0; i < levels(); ++i)
    for (int b = 1; b < forms_[i].points(); ++b)
      for (int a = 0; a < b; ++a) insert(node.candidates, edge_number(i, a, b));
  return {std::move(node)};
}

int Enumeration::candidates_left(const Node& node, int i) const {
  int count = 0;
  for (int edge = first_edge_[i]; edge < first_edge_[i + 1]; ++edge) count += contains(node.candidates, edge);
  return count;
}

/// Those without an edge, the ones with fewest candidates first.
std::vector<int> Enumeration::open_supports(const Node& node) const {
  std::vector<std::pair<int, int>> open;
  for (int i = 0; i < levels(); ++i)
    if (node.edges[i] == not_chosen) open.emplace_back(candidates_left(node, i), i);
  std::sort(open.begin(), open.end());
  std::vector<int> supports;
  for (const auto& [count, i] : open) supports.push_back(i);
  return supports;
}

/// Leaves the candidates of support i that are lowest somewhere in the polyhedron.
void Enumeration::narrow(Node& node, int i, SimplexWork& work) const {
  for (int a = 0; a < forms_[i].points(); ++a) {
    const auto is_candidate = [&](int b) { return contains(node.candidates, edge_number(i, a, b)); };
    std::vector<int> lowest;
    visit_edges_from(a, node.polyhedron, forms_[i], work, is_candidate,
                     [&](int b, const Dictionary&) { lowest.push_back(b); });
    for (int b = a + 1; b < forms_[i].points(); ++b) erase(node.candidates, edge_number(i, a, b));
    for (const int b : lowest) insert(node.candidates, edge_number(i, a, b));
  }
}

bool Enumeration::is_affected(const Node& node, int i) const {
  return node.newest < 0 || forms_[i].meets(forms_[node.newest]);
}

/// The open support with fewest candidates, or −1 where one has none. Those that meet the newest are
/// narrowed, and the chosen one itself; a single candidate leaves no choice, so the others need not be looked
/// at.
int Enumeration::choose_support(Node& node, SimplexWork& work) const {
  std::vector<bool> is_narrowed(forms_.size(), false);
  for (const int i : open_supports(node)) {
    if (!is_affected(node, i)) continue;
    narrow(node, i, work);
    is_narrowed[i] = true;
    if (candidates_left(node, i) <= 1) break;
  }
  int best = open_supports(node).front();
  while (candidates_left(node, best) > 0 && !is_narrowed[best]) {
    narrow(node, best, work);
    is_narrowed[best] = true;
    best = open_supports(node).front();
  }
  return candidates_left(node, best) > 0 ? best : -1;
}

/// Adds the candidates of support i with their weights.
void Enumeration::add_candidates(const Node& node, int i, double* target) const {
  for (int a = 0; a < forms_[i].points(); ++a)
    for (int b = a + 1; b < forms_[i].points(); ++b)
      if (const int edge = edge_number(i, a, b); contains(node.candidates, edge))
        node.polyhedron.add_restricted(forms_[i].excess(b, a), weight_of_[edge], target);
}

/// Whether a candidate can be taken of every open support so that all are independent along the polyhedron,
/// as the edges of a cell are: they can if and only if general elements of their spans are (R. Rado: A
/// theorem on independence relations, Quart. J. Math. 13 (1942)).
bool Enumeration::may_be_independent(const Node& node) const {
  // Rounding in the dictionary is some orders below; random combinations come as near to dependence with a
  // probability of this order.
  constexpr double independent = 1e-11;
  const int dimension = node.polyhedron.dimension();
  Eigen::MatrixXd combinations = Eigen::MatrixXd::Zero(1 + dimension, dimension);
  int column = 0;
  for (const int i : open_supports(node)) add_candidates(node, i, combinations.col(column++).data());
  Eigen::FullPivLU<Eigen::MatrixXd> lu(combinations.bottomRows(dimension));
  lu.setThreshold(independent);
  return lu.isInvertible();
}

std::vector<Node> Enumeration::children(Node node, SimplexWork& work) const {
  std::vector<Node> result;
  const int i = choose_support(node, work);
  if (i < 0 || !may_be_independent(node)) return result;
  for (int a = 0; a < forms_[i].points(); ++a) {
    const auto is_candidate = [&](int b) { return contains(node.candidates, edge_number(i, a, b)); };
    visit_edges_from(a, node.polyhedron, forms_[i], work, is_candidate, [&](int b, const Dictionary& lowest) {
      result.push_back({lowest.face(b), node.edges, node.candidates, i});
      result.back().edges[i] = {a, b};
    });
  }
  return result;
}

void Enumeration::descend(Node node, EnumeratedCells& found) const {
  if (stop_.stop_requested()) return;
  if (std::count(node.edges.begin(), node.edges.end(), not_chosen) == 0) {
    found.cells.push_back(std::move(node.edges));
    return;
  }
  for (Node& child : children(std::move(node), found.work)) descend(std::move(child), found);
}

/// Nodes of one level, enough of them to share out among threads, or all cells.
std::vector<Node> first_nodes(const Enumeration& enumeration, SimplexWork& work) {
  constexpr std::size_t enough = 64;
  std::vector<Node> nodes = enumeration.root();
  for (int level = 0; level < enumeration.levels() && nodes.size() < enough; ++level) {
    std::vector<Node> next;
    for (Node& node : nodes)
      for (Node& child : enumeration.children(std::move(node), work)) next.push_back(std::move(child));
    nodes = std::move(next);
  }
  return nodes;
}

std::vector<EnumeratedCells> descend_all(const Enumeration& enumeration, std::vector<Node> nodes,
                                         int threads) {
  std::vector<EnumeratedCells> found(nodes.size());
  share_on_threads(nodes.size(), threads,
                   [&](std::size_t i) { enumeration.descend(std::move(nodes[i]), found[i]); });
  return found;
}

}  // namespace

EnumeratedCells enumerate_cells(const Supports& supports, const Lifting& lifting, int threads,
                                const std::stop_token& stop) {
  const Enumeration enumeration(supports, lifting, stop);
  EnumeratedCells result;
  std::vector<Node> nodes = first_nodes(enumeration, result.work);
  for (EnumeratedCells& part : descend_all(enumeration, std::move(nodes), threads)) {
    std::move(part.cells.begin(), part.cells.end(), std::back_inserter(result.cells));
    result.work += part.work;
  }
  std::sort(result.cells.begin(), result.cells.end());
  return result;
}

}  // namespace gcs
