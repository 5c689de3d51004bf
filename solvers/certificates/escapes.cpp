#include "solvers/certificates/escapes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

/// Of walks that are looked at, and choices of signs: a second.
constexpr int most_steps = 10'000'000;

/// There are more where lengths are equal in many ways.
constexpr std::size_t most_walks = 256;

/// Of a sum of doubles, each right to a rounding, relative to its terms: what is above is no exact zero.
constexpr double rounding = 1e-13;

/// Of the pieces into which a walk cuts a scene, all unions are tried if they are not more.
constexpr std::size_t most_pieces = 4;

/// Whether Σ signs·√squares = 0, exactly. Square roots of rational numbers are linearly dependent over the rational ones
/// only where the quotient of two of the numbers is a square (Besicovitch 1940).
bool vanishes(const std::vector<Rational>& squares, const std::vector<int>& signs) {
  struct Multiple {
    Rational of;  ///< of its square root
    Rational coefficient;
  };
  std::vector<Multiple> sum;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    std::optional<Rational> quotient;
    const auto same = std::find_if(sum.begin(), sum.end(), [&](const Multiple& multiple) {
      quotient = (squares[i] / multiple.of).root();
      return quotient.has_value();
    });
    if (same == sum.end())
      sum.push_back({squares[i], Rational(signs[i])});
    else
      same->coefficient = same->coefficient + Rational(signs[i]) * *quotient;
  }
  return std::all_of(sum.begin(), sum.end(), [](const Multiple& m) { return m.coefficient.is_zero(); });
}

class WalkSearch {
 public:
  explicit WalkSearch(const Scene& scene) : scene_(scene), joined_(neighbours_of(scene)) {}

  std::vector<ClosedWalk> run() {
    for (int first = 0; first < scene_.point_count(); ++first) {
      walk_ = {first};
      go_on();
    }
    const auto plain = static_cast<int>(found_.size());
    for (across_ = 0; across_ < plain; ++across_) go_across();
    return std::move(found_);
  }

 private:
  const std::map<int, int>& neighbours(int point) const { return joined_[static_cast<std::size_t>(point)]; }

  /// The first corner is the smallest one, and the second is smaller than the last: every walk comes once. A corner that
  /// is joined to the first one is the last.
  void go_on() {
    for (const auto& [next, edge] : neighbours(walk_.back())) {
      if (is_enough()) return;
      if (next <= walk_.front() || !is_chordless(next)) continue;
      edges_.push_back(edge);
      walk_.push_back(next);
      const auto closing = neighbours(next).find(walk_.front());
      if (walk_.size() == 2 || closing == neighbours(next).end())
        go_on();
      else if (walk_.size() > 3 && walk_[1] < next)
        close(closing->second);
      walk_.pop_back();
      edges_.pop_back();
    }
  }

  bool is_enough() { return ++steps_ > most_steps || found_.size() >= most_walks; }

  const ClosedWalk& crossed() const { return found_[static_cast<std::size_t>(across_)]; }

  /// Walks that end at one corner of another walk, and step from there to the corner at which they began.
  void go_across() {
    const std::vector<int> corners = crossed().corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 2; j < corners.size() - (i == 0 ? 1 : 0); ++j) {
        walk_ = {corners[i]};
        go_on_to(corners[j]);
      }
  }

  void go_on_to(int last) {
    for (const auto& [neighbour, edge] : neighbours(walk_.back())) {
      if (is_enough()) return;
      const int next = neighbour;
      const bool is_joined = std::any_of(walk_.begin(), walk_.end() - 1, [&](int corner) {
        return corner == next || neighbours(corner).contains(next);
      });
      if (is_joined) continue;
      edges_.push_back(edge);
      walk_.push_back(next);
      if (next != last)
        go_on_to(last);
      else if (walk_.size() > 3)
        close_across();
      walk_.pop_back();
      edges_.pop_back();
    }
  }

  /// The steps of the crossed walk from the last corner to the first one, by the number of the first step.
  std::pair<std::size_t, std::size_t> crossed_steps() const {
    const std::vector<int>& corners = crossed().corners;
    const auto place = [&](int corner) {
      return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
    };
    const std::size_t from = place(walk_.back()), to = place(walk_.front());
    return {from, to > from ? to : to + corners.size()};
  }

  /// The last step is the sum of those of the crossed walk, whichever way its coordinate goes.
  void close_across() {
    const auto [from, to] = crossed_steps();
    const ClosedWalk base = crossed();
    const auto is_crossed = [&](int edge) { return std::ranges::find(base.edges, edge) != base.edges.end(); };
    if (std::ranges::all_of(edges_, is_crossed)) return;
    double length = 0;
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t step = i % base.edges.size();
      length += base.signs[step] * scene_.target_lengths()[static_cast<std::size_t>(base.edges[step])];
    }
    std::vector<double> lengths = lengths_of_edges();
    const double rest = std::accumulate(lengths.begin(), lengths.end(), std::abs(length));
    if (std::abs(length) <= rest * rounding) return;
    lengths.push_back(std::abs(length));
    std::vector<int> signs{1};
    choose_signs(lengths, lengths.front(), rest - lengths.front(), rest * rounding, signs);
  }

  std::vector<double> lengths_of_edges() const {
    std::vector<double> lengths;
    for (const int e : edges_) lengths.push_back(scene_.target_lengths()[static_cast<std::size_t>(e)]);
    return lengths;
  }

  /// Whether a next corner is joined to the last one alone, but for the first.
  bool is_chordless(int next) const {
    return std::none_of(walk_.begin() + (walk_.size() > 1 ? 1 : 0), walk_.end() - 1,
                        [&](int corner) { return neighbours(next).contains(corner); });
  }

  void close(int edge) {
    edges_.push_back(edge);
    const std::vector<double> lengths = lengths_of_edges();
    const double rest = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    std::vector<int> signs{1};
    choose_signs(lengths, lengths.front(), rest - lengths.front(), rest * rounding, signs);
    edges_.pop_back();
  }

  /// `rest`: the sum of the lengths whose signs are to be chosen.
  void choose_signs(const std::vector<double>& lengths, double sum, double rest, double tolerance,
                    std::vector<int>& signs) {
    if (is_enough() || std::abs(sum) > rest + tolerance) return;
    if (signs.size() == lengths.size()) {
      take(signs);
      return;
    }
    const double length = lengths[signs.size()];
    for (const int sign : {1, -1}) {
      signs.push_back(sign);
      choose_signs(lengths, sum + sign * length, rest - length, tolerance, signs);
      signs.pop_back();
    }
  }

  /// Of the crossed walk's coordinate the sense is open: both are tried.
  void take(const std::vector<int>& signs) {
    std::vector<Rational> squares;
    for (const int edge : edges_) squares.push_back(square(edge));
    if (across_ < 0) {
      if (vanishes(squares, signs)) found_.push_back({walk_, edges_, signs, -1});
      return;
    }
    const ClosedWalk base = crossed();
    const auto [from, to] = crossed_steps();
    for (std::size_t i = from; i < to; ++i) squares.push_back(square(base.edges[i % base.edges.size()]));
    std::vector<int> edges = edges_;
    edges.push_back(-1);
    for (const int sense : {1, -1}) {
      std::vector<int> all(signs.begin(), signs.end() - 1);
      for (std::size_t i = from; i < to; ++i) all.push_back(sense * base.signs[i % base.signs.size()]);
      if (vanishes(squares, all)) found_.push_back({walk_, edges, signs, across_});
    }
  }

  Rational square(int edge) const { return rational(given_square(scene_, edge)); }

  const Scene& scene_;
  Neighbours joined_;
  std::vector<int> walk_, edges_;
  int across_ = -1;  ///< the number of the walk that is crossed
  int steps_ = 0;
  std::vector<ClosedWalk> found_;
};

/// What is connected without these points, in order.
std::vector<std::set<int>> pieces_without(const Neighbours& joined, const std::vector<int>& removed) {
  std::vector<std::set<int>> pieces;
  std::set<int> seen(removed.begin(), removed.end());
  for (int first = 0; first < static_cast<int>(joined.size()); ++first) {
    if (!seen.insert(first).second) continue;
    std::set<int>& piece = pieces.emplace_back();
    std::vector<int> open{first};
    while (!open.empty()) {
      const int point = open.back();
      open.pop_back();
      piece.insert(point);
      for (const auto& [next, edge] : joined[static_cast<std::size_t>(point)])
        if (seen.insert(next).second) open.push_back(next);
    }
  }
  return pieces;
}

}  // namespace

Neighbours neighbours_of(const Scene& scene) {
  Neighbours joined(static_cast<std::size_t>(scene.point_count()));
  for (int e = 0; e < scene.constraint_count(); ++e) {
    const auto [a, b] = scene.problem().constraints[static_cast<std::size_t>(e)].between;
    joined[static_cast<std::size_t>(a)][b] = e;
    joined[static_cast<std::size_t>(b)][a] = e;
  }
  return joined;
}

std::vector<ClosedWalk> closed_walks(const Scene& scene) { return WalkSearch(scene).run(); }

std::vector<Escape> escapes(const Scene& scene, const Reference& frame,
                            const std::vector<ClosedWalk>& walks) {
  const Neighbours joined = neighbours_of(scene);
  std::vector<Escape> result;
  for (std::size_t number = 0; number < walks.size(); ++number) {
    const ClosedWalk& walk = walks[number];
    std::vector<std::set<int>> pieces = pieces_without(joined, walk.corners);
    std::erase_if(pieces, [&](const std::set<int>& piece) {
      return piece.contains(frame.origin) || piece.contains(frame.axis) || piece.contains(frame.plane);
    });
    if (pieces.size() > most_pieces) continue;
    for (unsigned chosen = 1; chosen < 1U << pieces.size(); ++chosen) {
      std::set<int> points;
      for (std::size_t i = 0; i < pieces.size(); ++i)
        if ((chosen >> i) & 1U) points.insert(pieces[i].begin(), pieces[i].end());
      const bool are_next = std::all_of(walk.corners.begin(), walk.corners.end(), [&](int corner) {
        const auto& next = joined[static_cast<std::size_t>(corner)];
        return std::any_of(next.begin(), next.end(), [&](const auto& n) { return points.contains(n.first); });
      });
      if (are_next) result.push_back({{points.begin(), points.end()}, walk, static_cast<int>(number)});
    }
  }
  return result;
}

}  // namespace gcs
