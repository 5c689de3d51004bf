#pragma once
/// Where a step of a scan plan can place its point over a cell of angles: pieces that together hold every
/// possible position.

#include <vector>

#include "solvers/scanning/circle_zeros.hpp"
#include "solvers/scanning/cylinder_placing.hpp"
#include "solvers/scanning/scan_plan.hpp"
#include "solvers/scanning/two_sides.hpp"

namespace gcs {

/// Pieces of the steps of one plan. Symbol i is angle i of the plan; a plan with a cylinder needs one symbol
/// more.
template <int N>
class StepPieces {
 public:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;

  /// `squares` are right to 2^-104 relative.
  StepPieces(const std::vector<DoubleDouble>& squares, int angles) : angles_(angles) {
    for (const DoubleDouble& square : squares) squares_.push_back(enclosing_form<N>(square));
  }

  const Form& square_of(int constraint) const { return squares_[constraint]; }

  /// `points` holds the points placed before; `within` restricts to a piece found on a larger cell.
  Pieces<N> of(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell,
               const std::optional<Choice>& within) const {
    if (step.cylinder >= 0) return around_line(step, points, cell, within);
    if (step.freedom == 2 && step.angles() == 0)
      return TwoSides<2, N>(spheres<2>(step, points), points).pieces(within, step.upper);
    if (step.freedom == 3 && step.angles() == 0)
      return TwoSides<3, N>(spheres<3>(step, points), points).pieces(within, step.upper);
    if (step.freedom == 3 && step.angles() == 1) return on_circle(step, points, cell);
    return {{{in_frame_or_around(step, points, cell), {}, {}, {}}}, {}};
  }

 private:
  /// A point of the frame, or one at any angles around another.
  Position in_frame_or_around(const ScanStep& step, const std::vector<Position>& points,
                              const Cell<N>& cell) const {
    if (step.freedom == 0) return {};
    const ScanSphere& sphere = step.spheres[0];
    const Form radius = sqrt(square_of(sphere.constraint));
    if (step.freedom == 1) return {radius, Form(), Form()};
    const auto [c, s] = cosine_and_sine(cell.angle(step.first_angle));
    if (step.angles() == 1) return points[sphere.center] + radius * Position{c, s, Form()};
    const auto [level, height] = cosine_and_sine(cell.angle(step.first_angle + 1));
    return points[sphere.center] + radius * Position{level * c, level * s, height};
  }

  template <std::size_t D>
  std::array<FormSurface<N>, D> spheres(const ScanStep& step, const std::vector<Position>& points) const {
    std::array<FormSurface<N>, D> spheres;
    for (std::size_t i = 0; i < D; ++i)
      spheres[i] = {points[step.spheres[i].center], square_of(step.spheres[i].constraint)};
    return spheres;
  }

  Pieces<N> on_circle(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell) const {
    // The centres of the upper point lie in the xy-plane; others in any direction but, as a rule, this one.
    const Position up =
        step.upper ? Position{Form(), Form(), Form(1)} : Position{Form(0.36), Form(0.48), Form(0.8)};
    return circle_at(spheres<2>(step, points), up, cell.angle(step.first_angle));
  }

  Pieces<N> around_line(const ScanStep& step, const std::vector<Position>& points, const Cell<N>& cell,
                        const std::optional<Choice>& within) const {
    const Form& radius_square = square_of(step.cylinder);
    if (step.freedom == 1) return {{{Position{Form(), Form(), sqrt(radius_square)}, {}, {}, {}}}, {}};
    if (step.angles() == 1) return at_angle_around_line(step, points, cell, within);
    const auto two = spheres<2>(step, points);
    const auto circle = common_circle(two, Position{Form(1), Form(), Form()});
    if (!circle) return {{}, room_to_meet(two)};
    if (circle->squared_radius.high() <= 0) return {};
    const auto excess = [&](const Position& at) { return square(at[1]) + square(at[2]) - radius_square; };
    Pieces<N> pieces{CircleZeros(*circle, excess, angles_).pieces(within), {}};
    for (Piece<N>& piece : pieces.list)
      piece.position = sharpened_on_cylinder(piece.position, two, radius_square);
    return pieces;
  }

  /// On a sphere at an angle around the line: of the square of the way along it to the centre, what is left.
  Pieces<N> at_angle_around_line(const ScanStep& step, const std::vector<Position>& points,
                                 const Cell<N>& cell, const std::optional<Choice>& within) const {
    const ScanSphere& sphere = step.spheres[0];
    const Form radius = sqrt(square_of(step.cylinder));
    const auto [c, s] = cosine_and_sine(cell.angle(step.first_angle));
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

  int angles_;
  std::vector<Form> squares_;
};

}  // namespace gcs
