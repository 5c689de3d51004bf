#pragma once
/// Where a step of a plan of points, lines and planes can place its element over a cell of angles: the same instructions as
/// element_places.hpp has at given angles, in enclosures.

#include <cstddef>

#include "solvers/construction/element_plan.hpp"
#include "solvers/scanning/circle_zeros.hpp"
#include "solvers/scanning/two_sides.hpp"

namespace gcs {

/// Where the elements of a problem are in a list of vectors: of a point its coordinates; of a line a point and the
/// direction, of a plane the normal and, in the first component, the offset.
class ElementSlots {
 public:
  explicit ElementSlots(const ProblemStatement& problem) : problem_(&problem) {}

  std::size_t first(int entity) const {
    const auto points = problem_->points.size(), lines = problem_->lines.size();
    if (problem_->is_point(entity)) return static_cast<std::size_t>(entity);
    if (problem_->is_line(entity)) return points + 2 * static_cast<std::size_t>(problem_->line_of(entity));
    return points + 2 * lines + 2 * static_cast<std::size_t>(problem_->plane_of(entity));
  }
  std::size_t second(int entity) const { return first(entity) + 1; }
  std::size_t count() const {
    return problem_->points.size() + 2 * problem_->lines.size() + 2 * problem_->planes.size();
  }

 private:
  const ProblemStatement* problem_;
};

/// The number that a constraint gives, as instructions see it: see GivenFrom. It is not negative but where a plane sees
/// its sides.
template <int N>
struct GivenForm {
  AffineForm<N> value;
  AffineForm<N> square;
};

/// The instruction of one step, in enclosures of what is placed before.
template <int N>
class ElementPieces {
 public:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;
  using Positions = std::vector<Position>;

  /// `given`: of each that the step has. `symbol`: of the forms', one that no angle has. Keeps references.
  ElementPieces(const ProblemStatement& problem, const ElementStep& step,
                const std::vector<GivenForm<N>>& given, const Positions& placed, const Cell<N>& cell,
                const std::optional<Choice>& within, int symbol)
      : problem_(problem),
        slots_(problem),
        step_(step),
        given_(given),
        placed_(placed),
        cell_(cell),
        within_(within),
        symbol_(symbol) {}

  /// Of a point, a plane's normal, the normal of a line in the plane, the direction of a line through a point, or a point
  /// of a line in a given direction.
  Pieces<N> pieces() const {
    if (problem_.is_point(step_.place)) return of_point();
    if (problem_.is_plane(step_.place)) return of_plane();
    return problem_.dimension == 2 ? on_sphere(unit_sphere(), cuts_of_line_normal()) : of_line();
  }

  /// The vectors of the element at one of its pieces.
  std::array<Position, 2> element_at(const Position& at) const {
    if (problem_.is_point(step_.place)) return {at};
    const Given first = from(0).front();
    if (problem_.is_plane(step_.place)) return {at, Position{dot(at, point(first)) - value(first)}};
    if (problem_.dimension == 2) return {point(first) - value(first) * at, Position{at[1], -at[0], Form()}};
    if (const auto through = point_on_line()) return {point(*through), at};
    return {at, *given_direction()};
  }

 private:
  /// By the number in the step's list.
  using Given = std::size_t;

  /// A surface or, where `either` is given, two planes: number ± either.
  struct Cut {
    FormSurface<N> surface;
    std::optional<Form> either = {};
  };
  using Cuts = std::vector<Cut>;

  struct Line {
    Position point, direction;
  };

  const GivenFrom& constraint(Given one) const { return step_.given[one]; }
  const Form& value(Given one) const { return given_[one].value; }
  bool is_on(Given one) const { return is_on_line(problem_, step_.place, constraint(one)); }
  const Position& point(Given one) const { return placed_[slots_.first(constraint(one).other)]; }
  Line line(Given one) const {
    const int other = constraint(one).other;
    return {placed_[slots_.first(other)], placed_[slots_.second(other)]};
  }
  const Position& normal(Given one) const { return placed_[slots_.first(constraint(one).other)]; }
  const Form& offset(Given one) const { return placed_[slots_.second(constraint(one).other)][0]; }
  Position direction(Given one) const {
    return problem_.is_plane(constraint(one).other) ? normal(one) : line(one).direction;
  }

  std::vector<Given> from(int rank) const {
    std::vector<Given> result;
    for (Given one = 0; one < step_.given.size(); ++one)
      if (constraint(one).met_by != MetBy::one_direction && rank_of(problem_, constraint(one).other) == rank)
        result.push_back(one);
    return result;
  }
  std::optional<Position> given_direction() const {
    for (Given one = 0; one < step_.given.size(); ++one)
      if (constraint(one).met_by == MetBy::one_direction) return direction(one);
    return std::nullopt;
  }
  std::optional<Given> point_on_line() const {
    for (const Given one : from(0))
      if (is_on(one)) return one;
    return std::nullopt;
  }

  static Position constant(double x, double y, double z) { return {Form(x), Form(y), Form(z)}; }
  static FormSurface<N> unit_sphere() { return {Position{}, Form(1)}; }
  static Cut cut(const Position& normal, const Form& number) { return {{normal, number, true}}; }
  /// A number of either sign, which is 0 where it is given as 0.
  Cut cut(const Position& normal, const Form& middle, Given either) const {
    Cut result = cut(normal, middle);
    if (constraint(either).value != 0) result.either = value(either);
    return result;
  }
  /// A right angle to the left of a line in the plane.
  static Position across(const Line& line) { return {-line.direction[1], line.direction[0], Form()}; }
  static Position beside(const Position& vector, const Position& direction) {
    return vector - dot(vector, direction) * direction;
  }

  /// Nothing is known of the element on this cell.
  static Pieces<N> unknown() { return {{}, Form(1)}; }

  // Spheres that are cut.

  /// At angles what the first two cuts leave open; both signs where neither is given.
  Pieces<N> on_sphere(const FormSurface<N>& sphere, Cuts cuts, bool only_positive = false) const {
    if (cuts.size() > 2) cuts.resize(2);
    int free_signs = 0;
    for (const Cut& cut : cuts) free_signs += cut.either ? 1 : 0;
    Pieces<N> all;
    for (int signs = 0; signs < 1 << free_signs; ++signs) {
      if (within_ && within_->signs != signs) continue;
      Pieces<N> some = on_surfaces(sphere, with_signs(cuts, signs), only_positive);
      if (some.unbounded_where) return free_signs > 0 ? unknown() : some;
      for (Piece<N>& piece : some.list) {
        piece.choice.signs = signs;
        all.list.push_back(std::move(piece));
      }
    }
    return all;
  }

  static std::vector<FormSurface<N>> with_signs(const Cuts& cuts, int signs) {
    std::vector<FormSurface<N>> surfaces;
    for (const Cut& cut : cuts) {
      surfaces.push_back(cut.surface);
      if (!cut.either) continue;
      Form& number = surfaces.back().number;
      number = (signs & 1) == 0 ? number + *cut.either : number - *cut.either;
      signs >>= 1;
    }
    return surfaces;
  }

  Pieces<N> on_surfaces(const FormSurface<N>& sphere, const std::vector<FormSurface<N>>& others,
                        bool only_positive) const {
    Pieces<N> pieces;
    if (others.size() == 2) {
      pieces = TwoSides<3, N>({sphere, others[0], others[1]}, placed_).pieces(within_, false);
    } else if (others.size() == 1) {
      pieces = circle_at<N>({sphere, others[0]}, up(), cell_.angle(step_.first_angle));
    } else {
      const auto [c, s] = cosine_and_sine(cell_.angle(step_.first_angle));
      const auto [level, height] = cosine_and_sine(cell_.angle(step_.first_angle + 1));
      pieces.list.push_back(
          {sphere.vector + sqrt(sphere.number) * Position{level * c, level * s, height}, {}, {}, {}});
    }
    if (only_positive)
      for (Piece<N>& piece : pieces.list)
        if (!piece.exchange) piece.exists.push_back(piece.position[step_.positive]);
    return pieces;
  }

  /// Where an angle is a right one: any direction but, as a rule, the circle's axis.
  static Position up() { return constant(0.36, 0.48, 0.8); }

  // Points.

  FormSurface<N> sphere(Given one) const { return {point(one), given_[one].square}; }

  Pieces<N> of_point() const {
    if (step_.is_origin) return {{Piece<N>{}}, {}};
    if (problem_.dimension == 3 && !from(2).empty()) return of_point_by_line(from(2));
    const std::vector<Given> spheres = from(0);
    if (spheres.empty()) return where_planes_meet(planes_of_point());
    return on_sphere(sphere(spheres.front()), surfaces_of_point(), step_.positive >= 0);
  }

  /// Planes that the point lies in: of the frame, at distances, and, in the plane, beside lines.
  Cuts planes_of_point() const {
    Cuts planes;
    for (const int axis : step_.zeros)
      planes.push_back(cut(constant(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0), Form()));
    for (const Given one : from(1)) planes.push_back(cut(normal(one), offset(one) + value(one)));
    if (problem_.dimension == 2)
      for (const Given one : from(2)) {
        const Position normal = across(line(one));
        planes.push_back(cut(normal, dot(normal, line(one).point), one));
      }
    return planes;
  }

  /// Zeros, spheres but the first, planes.
  Cuts surfaces_of_point() const {
    Cuts cuts = planes_of_point(), further;
    const std::vector<Given> spheres = from(0);
    for (std::size_t i = 1; i < spheres.size(); ++i) further.push_back({sphere(spheres[i])});
    cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(step_.zeros.size()), further.begin(),
                further.end());
    return cuts;
  }

  /// By Cramer's rule, whatever the signs.
  Pieces<N> where_planes_meet(const Cuts& planes) const {
    const Position &a = planes[0].surface.vector, &b = planes[1].surface.vector,
                   &c = planes[2].surface.vector;
    const Form volume = dot(a, cross(b, c));
    const bool is_negative = volume.mid < 0;
    if (!has_reciprocal(is_negative ? -volume : volume)) return unknown();
    const Form inverse = is_negative ? -reciprocal(-volume) : reciprocal(volume);
    Pieces<N> pieces;
    int free_signs = 0;
    for (const Cut& plane : planes) free_signs += plane.either ? 1 : 0;
    for (int signs = 0; signs < 1 << free_signs; ++signs) {
      if (within_ && within_->signs != signs) continue;
      const std::vector<FormSurface<N>> cuts = with_signs(planes, signs);
      Piece<N> piece{inverse * (cuts[0].number * cross(b, c) + cuts[1].number * cross(c, a) +
                                cuts[2].number * cross(a, b)),
                     {},
                     {},
                     {}};
      piece.choice.signs = signs;
      pieces.list.push_back(std::move(piece));
    }
    return pieces;
  }

  Pieces<N> of_point_by_line(const std::vector<Given>& lines) const {
    if (is_on(lines.back())) return met_on(line(lines.back()), lines.front());
    const std::vector<Given> spheres = from(0);
    const Cuts planes = planes_of_point();
    if (spheres.empty() && planes.size() == 2) {
      const auto common = common_line(planes[0].surface, planes[1].surface);
      return common ? met_on(*common, lines.front()) : unknown();
    }
    if (spheres.size() + planes.size() == 2) return of_circle_and_tube(lines.front());
    const auto along = ruling(lines.front());
    return along ? met_on(*along, lines.back()) : unknown();
  }

  /// The line that is at an angle on a cylinder. Nothing where the right angle's direction may be that of the axis.
  std::optional<Line> ruling(Given tube) const {
    const Line axis = line(tube);
    const Position second = beside(up(), axis.direction);
    const Form square_of_second = square(second);
    if (!has_reciprocal(square_of_second)) return std::nullopt;
    const Position v = reciprocal(sqrt(square_of_second)) * second, u = cross(v, axis.direction);
    const auto [c, s] = cosine_and_sine(cell_.angle(step_.first_angle));
    return Line{axis.point + value(tube) * (c * u + s * v), axis.direction};
  }

  /// Its direction is not of length 1.
  static std::optional<Line> common_line(const FormSurface<N>& a, const FormSurface<N>& b) {
    const Position along = cross(a.vector, b.vector);
    const Form area = square(along);
    if (!has_reciprocal(area)) return std::nullopt;
    return Line{reciprocal(area) * (a.number * cross(b.vector, along) + b.number * cross(along, a.vector)),
                along};
  }

  /// Where a line meets the first sphere or plane or, without these, the cylinder.
  Pieces<N> met_on(const Line& on, Given tube) const {
    if (const auto spheres = from(0); !spheres.empty())
      return at_reach(on, on.point - point(spheres[0]), on.direction, given_[spheres[0]].square);
    if (const auto planes = from(1); planes.size() == 1 && step_.zeros.empty()) {
      const Form rate = dot(normal(planes[0]), on.direction);
      const Form short_of = offset(planes[0]) + value(planes[0]) - dot(normal(planes[0]), on.point);
      const Form square_of_rate = square(rate);
      if (!has_reciprocal(square_of_rate)) return unknown();
      return {{{on.point + (short_of * rate * reciprocal(square_of_rate)) * on.direction, {}, {}, {}}}, {}};
    }
    const Line axis = line(tube);
    return at_reach(on, beside(on.point - axis.point, axis.direction), beside(on.direction, axis.direction),
                    given_[tube].square);
  }

  /// The places point + λ·direction at which |from + λ·along|² is a square.
  Pieces<N> at_reach(const Line& on, const Position& from, const Position& along,
                     const Form& square_of_reach) const {
    const Form length = square(along), middle = dot(from, along);
    const Form discriminant = square(middle) - length * (square(from) - square_of_reach);
    Pieces<N> pieces;
    if (discriminant.high() <= 0) return pieces;
    if (!has_reciprocal(length)) return unknown();
    const Form root = sqrt(discriminant), one_over_length = reciprocal(length);
    for (const int side : {1, -1}) {
      if (within_ && within_->side != side) continue;
      const Form way = one_over_length * (side > 0 ? root - middle : -root - middle);
      pieces.list.push_back({on.point + way * on.direction, {discriminant}, {side}, {}});
    }
    return pieces;
  }

  /// On a sphere and a further surface.
  Pieces<N> of_circle_and_tube(Given tube) const {
    const std::array<FormSurface<N>, 2> surfaces{sphere(from(0).front()),
                                                 surfaces_of_point().front().surface};
    const auto circle = common_circle(surfaces, up());
    if (!circle) return {{}, room_to_meet(surfaces)};
    if (circle->squared_radius.high() <= 0) return {};
    const Line axis = line(tube);
    const auto excess = [&](const Position& at) {
      return square(beside(at - axis.point, axis.direction)) - given_[tube].square;
    };
    return {CircleZeros(*circle, excess, symbol_).pieces(within_), {}};
  }

  // Normals and directions.

  Pieces<N> of_plane() const {
    if (const auto along = given_direction()) return both_ways(*along);
    return on_sphere(unit_sphere(), cuts_of_normal());
  }

  Pieces<N> both_ways(const Position& along) const {
    Pieces<N> pieces;
    for (const int side : {1, -1})
      if (!within_ || within_->side == side)
        pieces.list.push_back({side > 0 ? along : Form(-1) * along, {}, {side}, {}});
    return pieces;
  }

  Cuts cuts_of_normal() const {
    const std::vector<Given> points = from(0);
    Cuts cuts;
    for (std::size_t i = 1; i < points.size(); ++i)
      cuts.push_back(cut(point(points[i]) - point(points[0]), value(points[i]) - value(points[0])));
    for (const Given one : from(1)) cuts.push_back(cut(normal(one), value(one)));
    for (const Given one : from(2)) cuts.push_back(cut(line(one).direction, Form(), one));
    return cuts;
  }

  /// With the normal towards the first point.
  Cuts cuts_of_line_normal() const {
    const std::vector<Given> points = from(0);
    Cuts cuts{cut(constant(0, 0, 1), Form())};
    for (std::size_t i = 1; i < points.size(); ++i)
      cuts.push_back(cut(point(points[i]) - point(points[0]), -value(points[0]), points[i]));
    for (const Given one : from(2)) cuts.push_back(cut(across(line(one)), Form(), one));
    if (const auto along = given_direction()) cuts.push_back(cut(*along, Form()));
    return cuts;
  }

  Pieces<N> of_line() const {
    const auto through = point_on_line();
    if (!through) return of_line_along(*given_direction());
    if (const auto along = given_direction()) return {{{*along, {}, {}, {}}}, {}};
    Cuts cuts;
    std::vector<Form> squares;
    for (const Given one : from(0)) {
      if (one == *through) continue;
      const Position way = point(one) - point(*through);
      if (is_on(one)) return normalised(way);
      squares.push_back(square(way) - given_[one].square);
      if (squares.back().high() <= 0) return {};
      cuts.push_back({{way, Form(), true}, sqrt(squares.back())});
    }
    for (const int rank : {1, 2})
      for (const Given one : from(rank)) cuts.push_back(cut(direction(one), Form(), one));
    Pieces<N> pieces = on_sphere(unit_sphere(), cuts);
    for (Piece<N>& piece : pieces.list)
      piece.exists.insert(piece.exists.end(), squares.begin(), squares.end());
    return pieces;
  }

  static Pieces<N> normalised(const Position& way) {
    const Form length = square(way);
    if (!has_reciprocal(length)) return unknown();
    return {{{reciprocal(sqrt(length)) * way, {}, {}, {}}}, {}};
  }

  /// In the plane at a right angle to it the line is a point on circles.
  Pieces<N> of_line_along(const Position& along) const {
    Cuts cuts{cut(along, Form())};
    std::vector<FormSurface<N>> spheres;
    for (const Given one : from(0)) spheres.push_back({beside(point(one), along), given_[one].square});
    for (std::size_t i = 1; i < spheres.size(); ++i) cuts.push_back({spheres[i]});
    return on_sphere(spheres.front(), cuts);
  }

  const ProblemStatement& problem_;
  ElementSlots slots_;
  const ElementStep& step_;
  const std::vector<GivenForm<N>>& given_;
  const Positions& placed_;
  const Cell<N>& cell_;
  const std::optional<Choice>& within_;
  int symbol_;
};

}  // namespace gcs
