#pragma once
/// Where a step of a scan plan can place its point over a cell of angles: pieces that together hold every
/// possible position.

#include <numbers>
#include <vector>

#include "solvers/numeric/double_double.hpp"
#include "solvers/scanning/form_placing.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// A box of angles.
template <int N>
struct Cell {
  std::array<double, N> mid{};
  std::array<double, N> half{};

  double width() const { return *std::max_element(half.begin(), half.end()); }
};

/// Which part of a step's positions a piece is.
struct Choice {
  int side = 0;  ///< +1 or −1 where there are two
  /// If low < high, a range: of the height above the foot, in units of the offset, near the branch end of two
  /// sides; of the angle on a circle that meets a cylinder.
  double low = 0;
  double high = 0;

  double width() const { return high - low; }
};

template <int N>
struct Piece {
  FormVector<N> position;
  std::vector<AffineForm<N>> exists;  ///< all are not negative where the point exists, on this piece
  Choice choice;
};

template <int N>
struct Pieces {
  std::vector<Piece<N>> list;
  /// The list is empty because the position is not bounded on this cell; what may exist is where this is not
  /// negative.
  std::optional<AffineForm<N>> unbounded_where;
};

/// Pieces of the steps of one plan. Symbol i is angle i of the plan; a plan with a cylinder needs one symbol
/// more.
template <int N>
class StepPieces {
 public:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;

  StepPieces(const std::vector<DoubleDouble>& squares, int angles) : angles_(angles) {
    for (const DoubleDouble& s : squares) {
      Form form(s.hi);
      form.rest = 2 * std::abs(s.lo);
      squares_.push_back(form);
    }
  }

  const Form& square_of(int constraint) const { return squares_[constraint]; }

  /// `points` holds the points placed before; `within` restricts to a piece found on a larger cell.
  Pieces<N> of(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell,
               const std::optional<Choice>& within) const {
    if (step.cylinder >= 0) return around_line(step, points, cell, within);
    if (step.freedom == 2 && step.angles() == 0) return on_two_sides<2>(step, points, within);
    if (step.freedom == 3 && step.angles() == 0) return on_two_sides<3>(step, points, within);
    if (step.freedom == 3 && step.angles() == 1) return on_circle(step, points, cell);
    return {{{in_frame_or_around(step, points, cell), {}, {}}}, {}};
  }

 private:
  Form angle(const Cell<N>& cell, int i) const {
    Form angle(cell.mid[i]);
    angle.slope[i] = cell.half[i];
    return angle;
  }

  /// A point of the frame, or one at any angles around another.
  Position in_frame_or_around(const ScanStep& step, const std::vector<Position>& points,
                              const Cell<N>& cell) const {
    if (step.freedom == 0) return {};
    const ScanSphere& sphere = step.spheres[0];
    const Form radius = sqrt(square_of(sphere.constraint));
    if (step.freedom == 1) return {radius, Form(), Form()};
    const auto [c, s] = cosine_and_sine(angle(cell, step.first_angle));
    if (step.angles() == 1) return points[sphere.center] + radius * Position{c, s, Form()};
    const auto [level, height] = cosine_and_sine(angle(cell, step.first_angle + 1));
    return points[sphere.center] + radius * Position{level * c, level * s, height};
  }

  template <std::size_t D>
  void gather(const ScanStep& step, const std::vector<Position>& points, std::array<Position, D>& centers,
              std::array<Form, D>& squares) const {
    for (std::size_t i = 0; i < D; ++i) {
      centers[i] = points[step.spheres[i].center];
      squares[i] = square_of(step.spheres[i].constraint);
    }
  }

  Pieces<N> on_circle(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell) const {
    // The centres of the upper point lie in the xy-plane; others in any direction but, as a rule, this one.
    const Position up =
        step.upper ? Position{Form(), Form(), Form(1)} : Position{Form(0.36), Form(0.48), Form(0.8)};
    std::array<Position, 2> centers;
    std::array<Form, 2> squares;
    gather(step, points, centers, squares);
    const auto circle = common_circle(centers, squares, up);
    if (!circle) return {{}, room_to_meet(centers, squares)};
    if (!(circle->squared_radius.high() > 0)) return {};
    return {{{circle->at(angle(cell, step.first_angle)), {circle->squared_radius}, {}}}, {}};
  }

  template <std::size_t D>
  Pieces<N> on_two_sides(const ScanStep& step, const std::vector<Position>& points,
                         const std::optional<Choice>& within) const {
    std::array<Position, D> centers;
    std::array<Form, D> squares;
    gather(step, points, centers, squares);
    const SidePlacing<D, N> placing(centers, squares);
    std::optional<std::optional<TwoPositions<N>>> closed;  // the formula's answer for both sides, once asked
    Pieces<N> pieces;
    for (const int side : {1, -1}) {
      if (side < 0 && step.upper) continue;
      if (within && within->side != side) continue;
      if (const auto point = placing.verified(side)) {
        pieces.list.push_back({*point, {}, {side}});
        continue;
      }
      if (!closed) closed = meet<D>(centers, squares);
      if (!*closed) return {{}, room_to_meet(centers, squares)};
      if (const auto piece = near_branch_end(**closed, side, within)) pieces.list.push_back(*piece);
    }
    return pieces;
  }

  /// By the height above the foot, of which a range can be known better than the angles tell.
  std::optional<Piece<N>> near_branch_end(const TwoPositions<N>& both, int side,
                                          const std::optional<Choice>& within) const {
    const Form& discriminant = both.discriminant;
    if (!(discriminant.high() > 0)) return std::nullopt;
    Form height = sqrt(discriminant);
    Choice choice{side, std::max(0.0, height.low()), height.high()};
    std::vector<Form> exists{discriminant};
    if (within && within->width() > 0) {
      choice.low = std::max(choice.low, within->low);
      choice.high = std::min(choice.high, within->high);
      if (!(choice.low <= choice.high)) return std::nullopt;
      exists.push_back(discriminant + -within->low * within->low);
      exists.push_back(-discriminant + within->high * within->high);
      if (choice.width() / 2 < height.rest) {
        height = Form((choice.low + choice.high) / 2);
        height.rest = choice.width() / 2 * (1 + 8 * Form::epsilon) + 4 * Form::epsilon * choice.high;
      }
    }
    const Position point = side > 0 ? both.foot + height * both.offset : both.foot - height * both.offset;
    return Piece<N>{point, std::move(exists), choice};
  }

  Pieces<N> around_line(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell,
                        const std::optional<Choice>& within) const {
    const Form& radius_square = square_of(step.cylinder);
    if (step.freedom == 1) return {{{Position{Form(), Form(), sqrt(radius_square)}, {}, {}}}, {}};
    if (step.angles() == 1) return at_angle_around_line(step, points, cell, within);
    std::array<Position, 2> centers;
    std::array<Form, 2> squares;
    gather(step, points, centers, squares);
    const auto circle = common_circle(centers, squares, Position{Form(1), Form(), Form()});
    if (!circle) return {{}, room_to_meet(centers, squares)};
    Pieces<N> pieces;
    if (!(circle->squared_radius.high() > 0)) return pieces;
    constexpr double pi = std::numbers::pi;
    if (within) {
      meet_cylinder(*circle, radius_square, *within, pieces.list);
    } else {
      meet_cylinder(*circle, radius_square, {0, -pi, 0}, pieces.list);
      meet_cylinder(*circle, radius_square, {0, 0, pi}, pieces.list);
    }
    return pieces;
  }

  /// On a sphere around a point of the plane x = 0, at an angle around the line: x² is what is left.
  Pieces<N> at_angle_around_line(const ScanStep& step, const std::vector<Position>& points,
                                 const Cell<N>& cell, const std::optional<Choice>& within) const {
    const ScanSphere& sphere = step.spheres[0];
    const Form radius = sqrt(square_of(step.cylinder));
    const auto [c, s] = cosine_and_sine(angle(cell, step.first_angle));
    Position point{Form(), radius * c, radius * s};
    const Form rest = square_of(sphere.constraint) - square(point - points[sphere.center]);
    Pieces<N> pieces;
    if (!(rest.high() > 0)) return pieces;
    const Form x = sqrt(rest);
    for (const int side : {1, -1}) {
      if (side < 0 && step.upper) continue;
      if (within && within->side != side) continue;
      point[0] = side > 0 ? x : -x;
      pieces.list.push_back({point, {rest}, {side}});
    }
    return pieces;
  }

  /// Where the circle meets the cylinder at angles in `range`. What the angles of the plan say of the angle
  /// on the circle is solved to first order, so that a piece follows a branch; near a branch end, where they
  /// say little, pieces are as short as the cell is narrow.
  void meet_cylinder(const FormCircle<N>& circle, const Form& radius_square, Choice range,
                     std::vector<Piece<N>>& list) const {
    for (;;) {
      const double half = (range.high - range.low) / 2;
      Form phi((range.low + range.high) / 2);
      phi.slope[angles_] = half;
      const Form excess = excess_over(circle, radius_square, phi);
      if (!excess.contains_zero()) return;
      Form branch(phi.mid);
      branch.rest = half * (1 + 4 * Form::epsilon);
      const double own = std::abs(excess.slope[angles_]);
      if (own > excess.reach() - own + excess.rest) {
        branch = solved(phi, half, excess);
        const Choice part{0, std::max(range.low, branch.low()), std::min(range.high, branch.high())};
        if (!(part.low <= part.high)) return;
        const bool is_narrower = part.high - part.low <= narrowed * 2 * half;
        range = part;
        if (branch.rest <= tight * (branch.reach() + fine)) return append(circle, branch, range, list);
        if (is_narrower) continue;
      }
      const double unavoidable = excess_over(circle, radius_square, Form(phi.mid)).radius();
      if (excess.radius() <= short_enough * unavoidable || half <= fine)
        return append(circle, branch, range, list);
      const double middle = (range.low + range.high) / 2;
      meet_cylinder(circle, radius_square, {0, range.low, middle}, list);
      range.low = middle;
    }
  }

  static Form excess_over(const FormCircle<N>& circle, const Form& radius_square, const Form& phi) {
    const Position point = circle.at(phi);
    return square(point[1]) + square(point[2]) - radius_square;
  }

  /// excess = 0 solved for the symbol of φ = mid + half ξ. Precondition: it depends on it.
  Form solved(const Form& phi, double half, const Form& excess) const {
    Form others = excess;
    others.slope[angles_] = 0;
    const Form xi = (-1 / excess.slope[angles_]) * others;
    return half * xi + phi.mid;
  }

  static void append(const FormCircle<N>& circle, const Form& phi, const Choice& part,
                     std::vector<Piece<N>>& list) {
    list.push_back({circle.at(phi), {circle.squared_radius}, part});
  }

  static constexpr double tight = 0.1;     ///< of the branch's own slope: narrower is not worth another pass
  static constexpr double narrowed = 0.7;  ///< less progress than this is left to smaller cells
  static constexpr double short_enough = 3;  ///< a shorter piece would know little more, for the cell's sake
  static constexpr double fine = 1e-13;      ///< radians: rounding is not far below

  int angles_;
  std::vector<Form> squares_;
};

}  // namespace gcs
