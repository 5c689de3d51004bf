#include "solvers/counting/infinite_solutions.hpp"

#include <flint/nmod_mat.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <utility>

namespace gcs {
namespace {

using PointSet = std::uint64_t;
using Residue = mp_limb_t;
using Vector = std::array<Residue, 3>;

constexpr Residue prime = 2147483629;  // 2³¹ − 19, of which −1 is a square
constexpr int most_inner = 5;          // distances in S: its forms have 210 monomials of degree 6 then

PointSet bit(int point) { return PointSet{1} << point; }
bool has(PointSet set, int point) { return (set & bit(point)) != 0; }

Residue plus(Residue a, Residue b) { return (a + b) % prime; }
Residue minus(Residue a, Residue b) { return (a + prime - b) % prime; }
Residue times(Residue a, Residue b) { return a * b % prime; }
Residue negative(Residue a) { return minus(0, a); }
Residue inverse(Residue a) { return n_invmod(a, prime); }

Vector minus(const Vector& a, const Vector& b) {
  return {minus(a[0], b[0]), minus(a[1], b[1]), minus(a[2], b[2])};
}

Residue dot(const Vector& a, const Vector& b) {
  return plus(plus(times(a[0], b[0]), times(a[1], b[1])), times(a[2], b[2]));
}

Vector cross(const Vector& a, const Vector& b) {
  const auto component = [&](std::size_t i, std::size_t j) {
    return minus(times(a[i], b[j]), times(a[j], b[i]));
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

class ResidueMatrix {
 public:
  ResidueMatrix(std::size_t rows, std::size_t columns) {
    nmod_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns), prime);
  }
  ~ResidueMatrix() { nmod_mat_clear(matrix_); }
  ResidueMatrix(const ResidueMatrix&) = delete;
  ResidueMatrix& operator=(const ResidueMatrix&) = delete;

  Residue& operator()(std::size_t row, std::size_t column) { return matrix_->rows[row][column]; }
  slong rank() const { return nmod_mat_rank(matrix_); }
  /// Columns from the first on, each a solution of matrix·x = 0, that span these. How many they are.
  slong kernel(ResidueMatrix& columns) const { return nmod_mat_nullspace(columns.matrix_, matrix_); }

 private:
  nmod_mat_t matrix_;
};

using Exponents = std::vector<int>;

void add_monomials(int degree, std::size_t variable, Exponents& exponents, std::vector<Exponents>& all) {
  if (variable + 1 == exponents.size()) {
    exponents[variable] = degree;
    all.push_back(exponents);
    return;
  }
  for (int power = 0; power <= degree; ++power) {
    exponents[variable] = power;
    add_monomials(degree - power, variable + 1, exponents, all);
  }
}

std::vector<Exponents> monomials(int degree, std::size_t variables) {
  Exponents exponents(variables, 0);
  std::vector<Exponents> all;
  add_monomials(degree, 0, exponents, all);
  return all;
}

/// Coefficients of x_p·x_q for p ≤ q.
using QuadraticForm = std::map<std::pair<std::size_t, std::size_t>, Residue>;

/// Whether k forms in k variables have no common zero but 0: exactly then all monomials of degree k + 1 are combinations of
/// their multiples (Macaulay 1916).
bool meet_in_zero_alone(const std::vector<QuadraticForm>& forms) {
  const std::size_t k = forms.size();
  if (k == 0) return true;
  const auto degree = static_cast<int>(k) + 1;
  std::map<Exponents, std::size_t> column_of;
  for (const Exponents& monomial : monomials(degree, k)) column_of.emplace(monomial, column_of.size());
  const std::vector<Exponents> factors = monomials(degree - 2, k);
  ResidueMatrix multiples(k * factors.size(), column_of.size());
  std::size_t row = 0;
  for (const QuadraticForm& form : forms)
    for (const Exponents& factor : factors) {
      for (const auto& [variables, coefficient] : form) {
        Exponents product = factor;
        ++product[variables.first];
        ++product[variables.second];
        multiples(row, column_of.at(product)) = coefficient;
      }
      ++row;
    }
  return multiples.rank() == static_cast<slong>(column_of.size());
}

/// Without points that hang on three others: they double N and the figures at generic lengths.
struct Graph {
  Graph(std::size_t points, const std::vector<std::array<int, 2>>& all_edges,
        const std::vector<int>& all_held)
      : neighbours(points) {
    for (const int point : all_held) held |= bit(point);
    for (const auto& [a, b] : all_edges) {
      if (has(held, a) && has(held, b)) continue;
      near(a) |= bit(b);
      near(b) |= bit(a);
    }
    while (take_hung_point()) ++hung;
    for (int point = 0; point < static_cast<int>(neighbours.size()); ++point)
      if (near(point) != 0 && !has(held, point)) free.push_back(point);
    std::ranges::copy_if(all_edges, std::back_inserter(edges),
                         [&](const std::array<int, 2>& edge) { return has(near(edge[0]), edge[1]); });
  }

  PointSet& near(int point) { return neighbours[static_cast<std::size_t>(point)]; }
  PointSet near(int point) const { return neighbours[static_cast<std::size_t>(point)]; }

  PointSet held = 0;
  std::vector<PointSet> neighbours;  ///< of held points the free ones
  std::vector<int> free;
  std::vector<std::array<int, 2>> edges;  ///< not between held points
  int hung = 0;

 private:
  bool take_hung_point() {
    for (int point = 0; point < static_cast<int>(neighbours.size()); ++point) {
      if (has(held, point) || std::popcount(near(point)) != 3) continue;
      for (PointSet rest = std::exchange(near(point), 0); rest != 0; rest &= rest - 1)
        near(std::countr_zero(rest)) &= ~bit(point);
      return true;
    }
    return false;
  }
};

/// T
PointSet in_plane_of(const Graph& graph, PointSet set) {
  PointSet near = 0;
  for (PointSet rest = set; rest != 0; rest &= rest - 1) near |= graph.near(std::countr_zero(rest));
  return near & ~set;
}

/// Whether there are as many equations as unknowns, few of them in S, and no more held points in the plane than place it.
bool is_balanced(const Graph& graph, PointSet set) {
  const PointSet in_plane = in_plane_of(graph, set);
  int ends = 0, inner_ends = 0;
  for (PointSet rest = set; rest != 0; rest &= rest - 1) {
    const PointSet near = graph.near(std::countr_zero(rest));
    ends += std::popcount(near);
    inner_ends += std::popcount(near & set);
  }
  return std::popcount(in_plane & graph.held) <= 2 && inner_ends <= 2 * most_inner &&
         3 * std::popcount(set) + std::popcount(in_plane) - 2 == ends - inner_ends / 2;
}

/// One S, at a random place of the variety. Precondition: it is balanced.
class SetAtInfinity {
 public:
  SetAtInfinity(const Graph& graph, PointSet set)
      : graph_(graph), set_(set), in_plane_(in_plane_of(graph, set)) {
    for (const auto& [a, b] : graph.edges)
      if (has(set_, a) && has(set_, b)) inner_.push_back({a, b});
  }

  /// Nothing where the theorem does not serve.
  std::optional<Natural> count() {
    choose_place();
    const std::optional<int> doublings = doublings_of_places();
    if (!doublings || !is_isolated()) return std::nullopt;
    return Natural::power_of_two(*doublings + static_cast<int>(inner_.size()) + graph_.hung);
  }

 private:
  const Vector& at(int point) const { return places_[static_cast<std::size_t>(point)]; }

  Residue random() { return 1 + random_() % (prime - 1); }

  /// v = (1 − t², i(1 + t²), 2t)/(2t)
  void choose_place() {
    const Residue i = n_sqrtmod(prime - 1, prime), t = random(), square = times(t, t);
    const Residue scale = inverse(plus(t, t));
    v_ = {times(minus(1, square), scale), times(times(i, plus(1, square)), scale), 1};
    s_ = random();
    const Residue half = times(s_, inverse(2));
    for (std::size_t k = 0; k < graph_.neighbours.size(); ++k) {
      Vector& x = places_.emplace_back(Vector{random(), random(), random()});
      if (has(in_plane_, static_cast<int>(k)))
        x[2] = minus(half, plus(times(v_[0], x[0]), times(v_[1], x[1])));
    }
  }

  /// Of points of F and the plane, one after another.
  std::optional<int> doublings_of_places() const {
    PointSet placed = graph_.held, left = 0;
    for (const int point : graph_.free) left |= has(set_, point) ? 0 : bit(point);
    bool is_plane_placed = false;
    int doublings = 0;
    while (true) {
      if (const PointSet on = placed & in_plane_; !is_plane_placed && std::popcount(on) >= 2) {
        if (std::popcount(on) > 2) return std::nullopt;
        const int a = std::countr_zero(on), b = std::countr_zero(on & (on - 1));
        const Vector between = minus(at(a), at(b));
        doublings += dot(between, between) != 0 ? 1 : 0;
        is_plane_placed = true;
      }
      const auto next = std::ranges::find_if(graph_.free, [&](int point) {
        return has(left, point) && std::ssize(normals(point, placed, is_plane_placed)) >= 2;
      });
      if (next == graph_.free.end()) break;
      const std::vector<Vector> across = normals(*next, placed, is_plane_placed);
      if (across.size() > 2) return std::nullopt;
      const Vector along = cross(across[0], across[1]);
      doublings += dot(along, along) != 0 ? 1 : 0;
      placed |= bit(*next);
      left &= ~bit(*next);
    }
    return is_plane_placed && left == 0 ? std::optional(doublings) : std::nullopt;
  }

  /// Of the planes that the distances from placed points, and the plane, leave for the point beside a sphere.
  std::vector<Vector> normals(int point, PointSet placed, bool is_plane_placed) const {
    PointSet centres = graph_.near(point) & placed;
    std::vector<Vector> across;
    if (centres == 0) return across;
    const int first = std::countr_zero(centres);
    for (centres &= centres - 1; centres != 0; centres &= centres - 1)
      across.push_back(minus(at(std::countr_zero(centres)), at(first)));
    if (is_plane_placed && has(in_plane_, point)) across.push_back(v_);
    return across;
  }

  /// Unknowns are dx of F, and (dx₁, dx₂, ds, dw) of S, whose third coordinate stays 1.
  bool is_isolated() {
    std::vector<std::size_t> column(graph_.neighbours.size(), 0);
    std::size_t unknowns = 0;
    for (const int point : graph_.free) {
      column[static_cast<std::size_t>(point)] = unknowns;
      unknowns += has(set_, point) ? 4 : 3;
    }
    const std::size_t equations =
        graph_.edges.size() - inner_.size() + static_cast<std::size_t>(std::popcount(set_));
    if (unknowns != equations + inner_.size()) return false;
    ResidueMatrix derivatives(equations, unknowns);
    std::size_t row = 0;
    for (const auto& [a, b] : graph_.edges)
      if (!(has(set_, a) && has(set_, b))) write_distance(derivatives, row++, a, b, column);
    for (const int point : graph_.free)
      if (has(set_, point)) write_quadric(derivatives, row++, column[static_cast<std::size_t>(point)]);
    ResidueMatrix kernel(unknowns, unknowns);
    if (derivatives.kernel(kernel) != std::ssize(inner_)) return false;
    std::vector<QuadraticForm> forms;
    for (const auto& [a, b] : inner_)
      forms.push_back(
          inner_form(kernel, column[static_cast<std::size_t>(a)], column[static_cast<std::size_t>(b)]));
    return meet_in_zero_alone(forms);
  }

  /// |x − x'|² of two points of F, or s − 2 x·x' + (|x'|² − r²) w of one of S and one of F.
  void write_distance(ResidueMatrix& derivatives, std::size_t row, int a, int b,
                      const std::vector<std::size_t>& column) {
    if (has(set_, b)) std::swap(a, b);
    const std::size_t of_a = column[static_cast<std::size_t>(a)], of_b = column[static_cast<std::size_t>(b)];
    const bool is_b_free = !has(graph_.held, b);
    if (has(set_, a)) {
      const Vector& x = at(b);
      for (std::size_t i = 0; i < 2; ++i) derivatives(row, of_a + i) = negative(plus(x[i], x[i]));
      derivatives(row, of_a + 2) = 1;
      derivatives(row, of_a + 3) = minus(dot(x, x), random());
      for (std::size_t i = 0; i < 3 && is_b_free; ++i)
        derivatives(row, of_b + i) = negative(plus(v_[i], v_[i]));
      return;
    }
    const Vector between = minus(at(a), at(b));
    for (std::size_t i = 0; i < 3; ++i) {
      if (!has(graph_.held, a)) derivatives(row, of_a + i) = between[i];
      if (is_b_free) derivatives(row, of_b + i) = negative(between[i]);
    }
  }

  /// x·x − s w
  void write_quadric(ResidueMatrix& derivatives, std::size_t row, std::size_t of_point) const {
    for (std::size_t i = 0; i < 2; ++i) derivatives(row, of_point + i) = plus(v_[i], v_[i]);
    derivatives(row, of_point + 3) = negative(s_);
  }

  /// The theorem's form in coordinates of the kernel.
  QuadraticForm inner_form(ResidueMatrix& kernel, std::size_t a, std::size_t b) {
    const Residue square = random();
    const auto bilinear = [&](std::size_t p, std::size_t q) {
      const auto apart = [&](std::size_t i, std::size_t column) {
        return minus(kernel(a + i, column), kernel(b + i, column));
      };
      const Residue lengths = plus(times(apart(0, p), apart(0, q)), times(apart(1, p), apart(1, q)));
      const Residue mixed = times(apart(2, p), apart(3, q));
      const Residue at_infinity = times(square, times(kernel(a + 3, p), kernel(b + 3, q)));
      return minus(lengths, plus(mixed, at_infinity));
    };
    QuadraticForm form;
    for (std::size_t p = 0; p < inner_.size(); ++p)
      for (std::size_t q = p; q < inner_.size(); ++q)
        form[{p, q}] = p == q ? bilinear(p, p) : plus(bilinear(p, q), bilinear(q, p));
    return form;
  }

  const Graph& graph_;
  PointSet set_;
  PointSet in_plane_;                      ///< T
  std::vector<std::array<int, 2>> inner_;  ///< distances in S
  std::mt19937_64 random_{1};
  Vector v_{};
  Residue s_ = 0;
  std::vector<Vector> places_;
};

std::vector<int> points_of(PointSet set) {
  std::vector<int> points;
  for (; set != 0; set &= set - 1) points.push_back(std::countr_zero(set));
  return points;
}

}  // namespace

std::vector<InfiniteSolutions> infinite_solutions(std::size_t points,
                                                  const std::vector<std::array<int, 2>>& edges,
                                                  const std::vector<int>& held, std::int64_t& sets_left) {
  constexpr std::size_t most_points = 64, most_free = 40;
  std::vector<InfiniteSolutions> found;
  if (points > most_points) return found;
  const Graph graph(points, edges, held);
  if (graph.free.size() > most_free) return found;
  for (PointSet chosen = 1; chosen < PointSet{1} << graph.free.size() && sets_left > 0;
       ++chosen, --sets_left) {
    PointSet set = 0;
    for (PointSet rest = chosen; rest != 0; rest &= rest - 1)
      set |= bit(graph.free[static_cast<std::size_t>(std::countr_zero(rest))]);
    if (!is_balanced(graph, set)) continue;
    if (auto count = SetAtInfinity(graph, set).count()) found.push_back({points_of(set), *std::move(count)});
  }
  return found;
}

}  // namespace gcs
