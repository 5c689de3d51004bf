#include "solvers/motions/collapse.hpp"

#include <algorithm>
#include <utility>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

using Row = std::vector<Rational>;

/// Σ sign·point = 0
struct SignedPoint {
  int point;
  int sign;
};
using PointSum = std::vector<SignedPoint>;

/// The span of rows, each of which has its first entry that is not 0 where no other has one.
class RowSpace {
 public:
  /// The row less what the space has of it: 0 where it lies in the space.
  Row reduced(Row row) const {
    for (const auto& [column, own] : rows_) subtract(row, own, column);
    return row;
  }

  /// False where the row lies in the space already.
  bool add(const Row& given) {
    Row row = reduced(given);
    const auto first = std::ranges::find_if(row, [](const Rational& entry) { return !entry.is_zero(); });
    if (first == row.end()) return false;
    const auto column = static_cast<std::size_t>(first - row.begin());
    const Rational pivot = *first;
    for (Rational& entry : row) entry = entry / pivot;
    for (auto& [other, own] : rows_) subtract(own, row, column);
    rows_.emplace_back(column, std::move(row));
    return true;
  }

 private:
  static void subtract(Row& row, const Row& own, std::size_t column) {
    const Rational factor = row[column];
    if (factor.is_zero()) return;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] - factor * own[i];
  }

  std::vector<std::pair<std::size_t, Row>> rows_;
};

class Collapser {
 public:
  Collapser(const DistanceSystem& system, const QuadraticSystem& distances, const ComplexPoints& points,
            double tolerance)
      : system_(system), distances_(distances), points_(points), tolerance_(tolerance) {
    result_.equations.unknowns = distances.unknowns;
    result_.equations.mirror =
        SignMasks(std::vector<SignMask>(static_cast<std::size_t>(distances.unknowns), 0));
  }

  void join_points() {
    for (int a = 0; a < points_.cols(); ++a)
      for (int b = a + 1; b < points_.cols(); ++b)
        if (is_small(points_.col(a) - points_.col(b)) && impose({{a, 1}, {b, -1}}))
          result_.coincident.push_back({a, b});
  }

  void join_bars(const std::vector<std::array<int, 2>>& equal_bars) {
    for (const auto& [e, f] : equal_bars) join_bars(e, f);
  }

  bool has_joined() const { return !result_.equations.equations.empty(); }

  /// Nothing where a distance that is not 0 is between points that are one.
  std::optional<Collapse> with_distances(const std::vector<Rational>& squares) && {
    std::vector<std::pair<Rational, Row>> kept;
    for (int e = 0; e < system_.equations(); ++e) {
      Row bar = bar_on_space(e);
      if (std::ranges::all_of(bar, &Rational::is_zero)) return std::nullopt;
      const std::pair<Rational, Row> distance{squares[static_cast<std::size_t>(e)], std::move(bar)};
      if (std::ranges::find(kept, distance) != kept.end()) continue;
      result_.equations.equations.push_back(distances_.equations[static_cast<std::size_t>(e)]);
      kept.push_back(distance);
    }
    return std::move(result_);
  }

 private:
  bool is_small(const Eigen::Vector3cd& difference) const {
    return difference.cwiseAbs().maxCoeff() <= tolerance_;
  }

  void join_bars(int e, int f) {
    const auto [a, b] = system_.edges()[static_cast<std::size_t>(e)];
    const auto [c, d] = system_.edges()[static_cast<std::size_t>(f)];
    const Eigen::Vector3cd one = points_.col(a) - points_.col(b), other = points_.col(c) - points_.col(d);
    for (const int sign : {1, -1})
      if (is_small(one - sign * other) && impose({{a, 1}, {b, -1}, {c, -sign}, {d, sign}}))
        result_.parallel.push_back({e, f});
  }

  /// Coordinates that the frame gives are 0.
  Row row_of(const PointSum& sum, int axis) const {
    Row row(static_cast<std::size_t>(distances_.unknowns));
    for (const auto& [point, sign] : sum)
      if (const int unknown = system_.unknown(point, axis); unknown >= 0)
        row[static_cast<std::size_t>(unknown)] = row[static_cast<std::size_t>(unknown)] + Rational(sign);
    return row;
  }

  /// Adds the linear equations that do not follow from those that are there; false where all do.
  bool impose(const PointSum& sum) {
    bool is_new = false;
    for (int axis = 0; axis < system_.dimension(); ++axis) {
      if (!space_.add(row_of(sum, axis))) continue;
      is_new = true;
      LinearForm form;
      for (const auto& [point, sign] : sum)
        if (const int unknown = system_.unknown(point, axis); unknown >= 0)
          form.terms.push_back({unknown, exactly(sign)});
      result_.equations.equations.push_back({{{form, LinearForm{{}, exactly(1)}}}, {}});
    }
    return is_new;
  }

  /// The difference of the ends on the linear space, all axes in a row; of each axis the first entry that is not 0 is
  /// positive, since its square alone counts.
  Row bar_on_space(int e) const {
    const auto [a, b] = system_.edges()[static_cast<std::size_t>(e)];
    Row bar;
    for (int axis = 0; axis < system_.dimension(); ++axis) {
      const Row row = space_.reduced(row_of({{a, 1}, {b, -1}}, axis));
      const auto first = std::ranges::find_if(row, [](const Rational& entry) { return !entry.is_zero(); });
      const Rational sign(first != row.end() && first->sign() < 0 ? -1 : 1);
      for (const Rational& entry : row) bar.push_back(sign * entry);
    }
    return bar;
  }

  const DistanceSystem& system_;
  const QuadraticSystem& distances_;
  const ComplexPoints& points_;
  double tolerance_;
  RowSpace space_;
  Collapse result_;
};

}  // namespace

CollapseSearch::CollapseSearch(const Scene& scene, const DistanceSystem& system, QuadraticSystem distances)
    : system_(system), distances_(std::move(distances)) {
  for (int e = 0; e < scene.constraint_count(); ++e) squares_.push_back(rational(given_square(scene, e)));
  for (int e = 0; e < scene.constraint_count(); ++e)
    for (int f = e + 1; f < scene.constraint_count(); ++f)
      if (squares_[static_cast<std::size_t>(e)] == squares_[static_cast<std::size_t>(f)])
        equal_bars_.push_back({e, f});
}

std::optional<Collapse> CollapseSearch::at(const ComplexPoints& points, double tolerance,
                                           bool with_parallel_bars) const {
  Collapser collapser(system_, distances_, points, tolerance);
  collapser.join_points();
  if (with_parallel_bars) collapser.join_bars(equal_bars_);
  return collapser.has_joined() ? std::move(collapser).with_distances(squares_) : std::nullopt;
}

}  // namespace gcs
