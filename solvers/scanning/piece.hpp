#pragma once
/// Where a step of a plan can place an element over a cell of angles: pieces that together hold every possible position.

#include <algorithm>
#include <optional>
#include <vector>

#include "solvers/numeric/double_double.hpp"
#include "solvers/scanning/height_placing.hpp"

namespace gcs {

/// A number that is known to 2^-104, relative to it.
template <int N>
AffineForm<N> enclosing_form(const DoubleDouble& number) {
  using Form = AffineForm<N>;
  Form form(number.hi);
  form.rest =
      2 * (std::abs(number.lo) + Form::epsilon * Form::epsilon * std::abs(number.hi)) + Form::underflow;
  return form;
}

/// At least |x − x.mid| for all of its values.
template <int N>
double radius_about_middle(const AffineForm<N>& x) {
  return x.radius() + 4 * AffineForm<N>::epsilon * std::abs(x.mid);
}

/// A box of angles.
template <int N>
struct Cell {
  std::array<double, N> mid{};
  std::array<double, N> half{};

  /// As a form in its own symbol.
  AffineForm<N> angle(int i) const {
    AffineForm<N> angle(mid[i]);
    angle.slope[i] = half[i];
    return angle;
  }
};

/// Which part of a step's positions a piece is.
struct Choice {
  int side = 0;  ///< +1 or −1 where there are two
  /// If low < high, a range: near the branch end of two sides, of the height above the centres, times the
  /// length of their line or the area of their parallelogram; of the angle on a circle that meets a cylinder.
  double low = 0;
  double high = 0;
  int signs = 0;  ///< of what is given without a sign: a bit for each that is negative

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

/// A point of the circle in which a sphere meets another surface.
template <int N>
Pieces<N> circle_at(const std::array<FormSurface<N>, 2>& surfaces, const FormVector<N>& up,
                    const AffineForm<N>& angle) {
  const auto circle = common_circle(surfaces, up);
  if (!circle) return {{}, room_to_meet(surfaces)};
  if (circle->squared_radius.high() <= 0) return {};
  return {{{circle->at(angle), {circle->squared_radius}, {}, {}}}, {}};
}

}  // namespace gcs
