#pragma once
/// Where a step of a scan plan can place its point over a cell of angles: pieces that together hold every
/// possible position.

#include <numbers>
#include <vector>

#include "solvers/numeric/double_double.hpp"
#include "solvers/scanning/cylinder_placing.hpp"
#include "solvers/scanning/height_placing.hpp"
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
  /// If low < high, a range: near the branch end of two sides, of the height above the centres, times the
  /// length of their line or the area of their parallelogram; of the angle on a circle that meets a cylinder.
  double low = 0;
  double high = 0;

  bool is_range() const { return low < high; }
  double mid() const { return (low + high) / 2; }
  double half() const { return (high - low) / 2; }
};

template <int N>
struct Piece {
  FormVector<N> position;
  std::vector<AffineForm<N>> exists;  ///< all are not negative where the point exists, on this piece
  Choice choice;
  /// If given, the position is in terms of the range of `choice`, whose symbol runs from −1 at its low to 1
  /// at its high end and takes the place of the one exchanged; `exists` still has the latter.
  std::optional<Exchange<N>> exchange;
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

  /// `squares` are right to 2^-104 relative.
  StepPieces(const std::vector<DoubleDouble>& squares, int angles) : angles_(angles) {
    for (const DoubleDouble& s : squares) {
      Form form(s.hi);
      form.rest = 2 * (std::abs(s.lo) + Form::epsilon * Form::epsilon * s.hi) + Form::underflow;
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
    return {{{in_frame_or_around(step, points, cell), {}, {}, {}}}, {}};
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
    if (circle->squared_radius.high() <= 0) return {};
    return {{{circle->at(angle(cell, step.first_angle)), {circle->squared_radius}, {}, {}}}, {}};
  }

  template <std::size_t D>
  Pieces<N> on_two_sides(const ScanStep& step, const std::vector<Position>& points,
                         const std::optional<Choice>& within) const {
    std::array<Position, D> centers;
    std::array<Form, D> squares;
    gather(step, points, centers, squares);
    const SidePlacing<D, N> placing(centers, squares);
    std::optional<Meeting> meeting;  // of both sides, once asked
    Pieces<N> pieces;
    for (const int side : {1, -1}) {
      if (side < 0 && step.upper) continue;
      if (within && within->side != side) continue;
      const auto point = placing.verified(side);
      Piece<N> piece{point.value_or(Position{}), {}, {side}, {}};
      const bool has_range = within && within->is_range();
      if (!point || has_range) {
        if (!meeting) meeting = Meeting{room_to_meet(centers, squares), meet<D>(centers, squares)};
        if (!take_heights(meeting->room, has_range ? &*within : nullptr, piece)) continue;
        if (!point && !meeting->both) return {{}, meeting->room};
        if (!point && !place_near_end<D>({centers, squares}, *meeting, points, piece)) continue;
      }
      pieces.list.push_back(std::move(piece));
    }
    return pieces;
  }

  /// How circles or spheres meet on both sides, by the closed formula.
  struct Meeting {
    Form room;  ///< room_to_meet: the square of what a range of heights is of
    std::optional<TwoPositions<N>> both;
  };

  /// Restricts the piece to heights that `room` and `within`, if given, leave. False where there are none.
  static bool take_heights(const Form& room, const Choice* within, Piece<N>& piece) {
    if (room.high() <= 0) return false;
    piece.exists.push_back(room);
    piece.choice.low = std::sqrt(std::max(0.0, room.low()));
    piece.choice.high = std::sqrt(room.high());
    if (within == nullptr) return true;
    piece.choice.low = std::max(piece.choice.low, within->low);
    piece.choice.high = std::min(piece.choice.high, within->high);
    piece.exists.push_back(room + -within->low * within->low);
    piece.exists.push_back(-room + within->high * within->high);
    return !(piece.choice.low > piece.choice.high);
  }

  /// By the closed formula or, where that leaves less unknown, by the height. False where there is no point.
  template <std::size_t D>
  static bool place_near_end(const HeightPlacing<D, N>& placing, const Meeting& meeting,
                             const std::vector<Position>& points, Piece<N>& piece) {
    if (meeting.both->discriminant.high() <= 0) return false;
    piece.exists.push_back(meeting.both->discriminant);
    piece.position = meeting.both->on(piece.choice.side);
    const auto rough = angle_by_height(meeting.room, piece);
    if (!rough) return true;
    const Form height = piece.choice.side * ranging(piece.choice, rough->exchange.symbol);
    const PointByHeight<N> sharp = placing.sharpened(*rough, meeting.both->offset, height);
    if (!sharp.is_worth_it(points, piece.position)) return true;
    piece.position = sharp.position;
    piece.exchange = sharp.exchange;
    return true;
  }

  /// The middle of the range and as much of the symbol as reaches its ends.
  static Form ranging(const Choice& range, int symbol) {
    Form form(range.mid());
    form.slope[symbol] = range.half();
    form.rest = 4 * Form::epsilon * std::max(std::abs(range.low), std::abs(range.high));
    return form;
  }

  /// room = height² solved for the symbol on which the room depends most. Nothing where it depends on none,
  /// or the range is a point.
  static std::optional<PointByHeight<N>> angle_by_height(const Form& room, const Piece<N>& piece) {
    const auto is_less = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto most = std::max_element(room.slope.begin(), room.slope.end(), is_less);
    if (*most == 0 || !piece.choice.is_range()) return std::nullopt;
    const int symbol = static_cast<int>(most - room.slope.begin());
    Form others = room;
    others.slope[symbol] = 0;
    Form value = (1 / *most) * (square(ranging(piece.choice, symbol)) - others);
    if (!(std::abs(value.mid) + value.radius() <= 1)) {
      value = Form();
      value.rest = 1;  // all that a symbol can be
    }
    const Exchange<N> exchange{symbol, value};
    return PointByHeight<N>{exchange.of(piece.position), exchange};
  }

  Pieces<N> around_line(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell,
                        const std::optional<Choice>& within) const {
    const Form& radius_square = square_of(step.cylinder);
    if (step.freedom == 1) return {{{Position{Form(), Form(), sqrt(radius_square)}, {}, {}, {}}}, {}};
    if (step.angles() == 1) return at_angle_around_line(step, points, cell, within);
    std::array<Position, 2> centers;
    std::array<Form, 2> squares;
    gather(step, points, centers, squares);
    const auto circle = common_circle(centers, squares, Position{Form(1), Form(), Form()});
    if (!circle) return {{}, room_to_meet(centers, squares)};
    Pieces<N> pieces;
    if (circle->squared_radius.high() <= 0) return pieces;
    if (within) {
      meet_cylinder(*circle, radius_square, *within, pieces.list);
    } else {
      meet_cylinder(*circle, radius_square, {0, -std::numbers::pi, 0}, pieces.list);
      meet_cylinder(*circle, radius_square, {0, 0, std::numbers::pi}, pieces.list);
    }
    for (Piece<N>& piece : pieces.list)
      piece.position = sharpened_on_cylinder(piece.position, centers, squares, radius_square);
    return pieces;
  }

  /// On a sphere at an angle around the line: of the square of the way along it to the centre, what is left.
  Pieces<N> at_angle_around_line(const ScanStep& step, const std::vector<Position>& points,
                                 const Cell<N>& cell, const std::optional<Choice>& within) const {
    const ScanSphere& sphere = step.spheres[0];
    const Form radius = sqrt(square_of(step.cylinder));
    const auto [c, s] = cosine_and_sine(angle(cell, step.first_angle));
    const Position& center = points[sphere.center];
    Position point{center[0], radius * c, radius * s};
    const Position across{Form(), point[1] - center[1], point[2] - center[2]};
    const Form rest = square_of(sphere.constraint) - square(across);
    Pieces<N> pieces;
    if (rest.high() <= 0) return pieces;
    const Form x = sqrt(rest);
    for (const int side : {1, -1}) {
      if (side < 0 && step.upper) continue;
      if (within && within->side != side) continue;
      point[0] = side > 0 ? center[0] + x : center[0] - x;
      pieces.list.push_back({point, {rest}, {side}, {}});
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
    list.push_back({circle.at(phi), {circle.squared_radius}, part, {}});
  }

  static constexpr double tight = 0.1;     ///< of the branch's own slope: narrower is not worth another pass
  static constexpr double narrowed = 0.7;  ///< less progress than this is left to smaller cells
  static constexpr double short_enough = 6;  ///< a shorter piece would know little more, for the cell's sake
  static constexpr double fine = 1e-13;      ///< radians: rounding is not far below

  int angles_;
  std::vector<Form> squares_;
};

}  // namespace gcs
