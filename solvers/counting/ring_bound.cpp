#include "solvers/counting/ring_bound.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace gcs {
namespace {

constexpr std::size_t ring_size = 6;

using Body = std::vector<int>;  ///< points in order
using Edge = std::array<int, 2>;

bool contains(const Body& body, int point) { return std::binary_search(body.begin(), body.end(), point); }

/// The triangle with all points that are placed, one after another, by three distances from it.
Body grown_from(const Body& triangle, const std::vector<std::vector<int>>& neighbours) {
  constexpr int enough = 3;
  std::vector<int> distances(neighbours.size(), 0);
  for (const int point : triangle) distances[point] = enough;
  Body body = triangle;
  for (std::size_t i = 0; i < body.size(); ++i)
    for (const int other : neighbours[body[i]])
      if (++distances[other] == enough) body.push_back(other);
  std::sort(body.begin(), body.end());
  return body;
}

bool is_maximal(const Body& body, const std::set<Body>& all) {
  return std::none_of(all.begin(), all.end(), [&](const Body& other) {
    return other.size() > body.size() && std::includes(other.begin(), other.end(), body.begin(), body.end());
  });
}

class RingSearch {
 public:
  RingSearch(int points, const std::vector<Edge>& edges, const std::vector<std::vector<int>>& triangles)
      : neighbours_(static_cast<std::size_t>(points)), edges_(edges) {
    for (const auto& [a, b] : edges) {
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
    }
    std::set<Body> grown;
    for (const Body& triangle : triangles) grown.insert(grown_from(triangle, neighbours_));
    std::copy_if(grown.begin(), grown.end(), std::back_inserter(bodies_),
                 [&](const Body& body) { return is_maximal(body, grown); });
  }

  /// Empty: there is no ring.
  std::vector<Body> find() const {
    std::vector<Body> ring;
    if (!bodies_suffice()) return ring;
    for (std::size_t first = 0; first + ring_size <= bodies_.size(); ++first) {
      ring = {bodies_[first]};
      if (closes(ring, first)) return ring;
    }
    return {};
  }

 private:
  /// A ring of n points has bodies of n + 12 together, by (iv). Where the largest are that large they hold
  /// all but a few of the 3n − 6 edges, so that there are few others and the search is short.
  bool bodies_suffice() const {
    std::vector<std::size_t> sizes;
    for (const Body& body : bodies_) sizes.push_back(body.size());
    std::sort(sizes.rbegin(), sizes.rend());
    std::size_t sum = 0;
    for (std::size_t i = 0; i < std::min(ring_size, sizes.size()); ++i) sum += sizes[i];
    return sum >= neighbours_.size() + 2 * ring_size;
  }

  /// Completes the chain to a ring by bodies after the first, if it can.
  bool closes(std::vector<Body>& chain, std::size_t first) const {
    if (chain.size() == ring_size) return is_ring(chain);
    for (std::size_t next = first + 1; next < bodies_.size(); ++next) {
      if (std::find(chain.begin(), chain.end(), bodies_[next]) != chain.end()) continue;
      if (!hinge(chain.back(), bodies_[next])) continue;
      chain.push_back(bodies_[next]);
      if (closes(chain, first)) return true;
      chain.pop_back();
    }
    return false;
  }

  /// The two points that the bodies share, if they share no more and their distance is given.
  std::optional<Edge> hinge(const Body& a, const Body& b) const {
    Body shared;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(shared));
    if (shared.size() != 2) return std::nullopt;
    const std::vector<int>& joined = neighbours_[shared[0]];
    if (std::find(joined.begin(), joined.end(), shared[1]) == joined.end()) return std::nullopt;
    return Edge{shared[0], shared[1]};
  }

  /// Whether a chain of hinged bodies closes and satisfies (iii) and (iv).
  bool is_ring(const std::vector<Body>& chain) const {
    std::vector<Edge> hinges;
    for (std::size_t i = 0; i < ring_size; ++i) {
      const auto shared = hinge(chain[i], chain[(i + 1) % ring_size]);
      if (!shared) return false;
      hinges.push_back(*shared);
    }
    return holds_edges(chain, hinges) && holds_points(chain, hinges);
  }

  /// (iii). It makes the hinges differ: two in one edge would put it into three bodies.
  bool holds_edges(const std::vector<Body>& ring, const std::vector<Edge>& hinges) const {
    return std::all_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
      const Edge sorted{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
      const bool is_hinge = std::find(hinges.begin(), hinges.end(), sorted) != hinges.end();
      return std::count_if(ring.begin(), ring.end(), [&](const Body& body) {
               return contains(body, edge[0]) && contains(body, edge[1]);
             }) == (is_hinge ? 2 : 1);
    });
  }

  /// (iv).
  bool holds_points(const std::vector<Body>& ring, const std::vector<Edge>& hinges) const {
    for (int point = 0; point < static_cast<int>(neighbours_.size()); ++point) {
      const auto bodies =
          std::count_if(ring.begin(), ring.end(), [&](const Body& body) { return contains(body, point); });
      const auto on_hinges = std::count_if(hinges.begin(), hinges.end(), [&](const Edge& hinge) {
        return hinge[0] == point || hinge[1] == point;
      });
      if (bodies != on_hinges + 1) return false;
    }
    return true;
  }

  std::vector<std::vector<int>> neighbours_;
  const std::vector<Edge>& edges_;
  std::vector<Body> bodies_;
};

}  // namespace

std::optional<RingBound> ring_bound(int points, const std::vector<std::array<int, 2>>& edges,
                                    const std::vector<std::vector<int>>& triangles) {
  std::vector<Body> ring = RingSearch(points, edges, triangles).find();
  if (ring.empty()) return std::nullopt;
  return RingBound{Natural::power_of_two(points - 2), std::move(ring)};
}

}  // namespace gcs
