#pragma once
/// Enclosures of the points that the steps of a scan plan place, over a cell of angles.
///
/// Where spheres meet there are two ways. One carries the closed formula through; it always gives something,
/// up to the branch end, but takes what is unknown of a centre for many independent unknowns. The other
/// verifies an enclosure by Newton's method; there the unknown enters with its true weight, but it needs to
/// be away from the branch end.

#include <Eigen/LU>
#include <optional>

#include "solvers/numeric/affine_form.hpp"

namespace gcs {

/// foot ± √discriminant · offset.
template <int N>
struct TwoPositions {
  FormVector<N> foot;
  FormVector<N> offset;
  AffineForm<N> discriminant;

  /// Precondition: discriminant.high() > 0.
  FormVector<N> on(int side) const {
    const AffineForm<N> height = sqrt(discriminant);
    return side > 0 ? foot + height * offset : foot - height * offset;
  }
};

/// A circle in space: centre, radius and the directions of angle 0 and of a right angle.
template <int N>
struct FormCircle {
  FormVector<N> center;
  AffineForm<N> squared_radius;
  FormVector<N> first;
  FormVector<N> second;

  /// Precondition: squared_radius.high() > 0.
  FormVector<N> at(const AffineForm<N>& angle) const {
    const auto [c, s] = cosine_and_sine(angle);
    return center + sqrt(squared_radius) * (c * first + s * second);
  }
};

/// Where along b − a, as a fraction of it, the plane lies in which spheres around a and b meet.
template <int N>
AffineForm<N> fraction_to_common_plane(const AffineForm<N>& squared_gap, const AffineForm<N>& one_over_gap,
                                       const AffineForm<N>& square_a, const AffineForm<N>& square_b) {
  return 0.5 * ((square_a - square_b + squared_gap) * one_over_gap);
}

/// Two circles in the plane z = const. Nothing where the centres may coincide within the cell.
template <int N>
std::optional<TwoPositions<N>> meet_circles(const std::array<FormVector<N>, 2>& centers,
                                            const std::array<AffineForm<N>, 2>& squares) {
  const FormVector<N> axis = centers[1] - centers[0];
  const AffineForm<N> gap = square(axis[0]) + square(axis[1]);
  if (!has_reciprocal(gap)) return std::nullopt;
  const AffineForm<N> one_over_gap = reciprocal(gap);
  const AffineForm<N> fraction = fraction_to_common_plane(gap, one_over_gap, squares[0], squares[1]);
  return TwoPositions<N>{centers[0] + fraction * axis, FormVector<N>{-axis[1], axis[0], AffineForm<N>()},
                         squares[0] * one_over_gap - square(fraction)};
}

/// Three spheres. Nothing where the centres may be collinear within the cell.
template <int N>
std::optional<TwoPositions<N>> meet_spheres(const std::array<FormVector<N>, 3>& centers,
                                            const std::array<AffineForm<N>, 3>& squares) {
  const FormVector<N> a = centers[1] - centers[0];
  const FormVector<N> b = centers[2] - centers[0];
  const FormVector<N> normal = cross(a, b);
  const AffineForm<N> area = square(normal);
  if (!has_reciprocal(area)) return std::nullopt;
  const AffineForm<N> one_over_area = reciprocal(area);
  const AffineForm<N> aa = square(a);
  const AffineForm<N> bb = square(b);
  const AffineForm<N> ab = dot(a, b);
  const AffineForm<N> along_a = 0.5 * (squares[0] - squares[1] + aa);  // of (p − c_0)·a
  const AffineForm<N> along_b = 0.5 * (squares[0] - squares[2] + bb);
  const FormVector<N> foot = (one_over_area * (along_a * bb - along_b * ab)) * a +
                             (one_over_area * (along_b * aa - along_a * ab)) * b;
  return TwoPositions<N>{centers[0] + foot, normal, (squares[0] - square(foot)) * one_over_area};
}

/// The circle in which two spheres meet; angles count from a right angle to `up`. Nothing where the centres
/// may coincide within the cell, or lie in the direction of `up` from each other.
template <int N>
std::optional<FormCircle<N>> common_circle(const std::array<FormVector<N>, 2>& centers,
                                           const std::array<AffineForm<N>, 2>& squares,
                                           const FormVector<N>& up) {
  const FormVector<N> axis = centers[1] - centers[0];
  const AffineForm<N> gap = square(axis);
  if (!has_reciprocal(gap)) return std::nullopt;
  const AffineForm<N> one_over_gap = reciprocal(gap);
  const FormVector<N> second = up - (dot(up, axis) * one_over_gap) * axis;
  const AffineForm<N> length = square(second);
  if (!has_reciprocal(length)) return std::nullopt;
  const FormVector<N> second_unit = reciprocal(sqrt(length)) * second;
  const FormVector<N> axis_unit = sqrt(one_over_gap) * axis;
  const AffineForm<N> fraction = fraction_to_common_plane(gap, one_over_gap, squares[0], squares[1]);
  return FormCircle<N>{centers[0] + fraction * axis, squares[0] - square(fraction) * gap,
                       cross(second_unit, axis_unit), second_unit};
}

/// Not negative where circles or spheres of these centres meet: the discriminant times the squared gap of the
/// circles' centres, or times the squared area of the parallelogram of the spheres'. A polynomial: it decides
/// where these vanish.
template <int N>
AffineForm<N> room_to_meet(const std::array<FormVector<N>, 2>& centers,
                           const std::array<AffineForm<N>, 2>& squares) {
  const AffineForm<N> gap = square(centers[1] - centers[0]);
  return squares[0] * gap - 0.25 * square(squares[0] - squares[1] + gap);
}

template <int N>
AffineForm<N> room_to_meet(const std::array<FormVector<N>, 3>& centers,
                           const std::array<AffineForm<N>, 3>& squares) {
  const FormVector<N> a = centers[1] - centers[0];
  const FormVector<N> b = centers[2] - centers[0];
  const AffineForm<N> along_a = 0.5 * (squares[0] - squares[1] + square(a));
  const AffineForm<N> along_b = 0.5 * (squares[0] - squares[2] + square(b));
  return squares[0] * square(cross(a, b)) - square(along_a * b - along_b * a);
}

/// The middles of forms, as forms without symbols.
template <int N>
FormVector<0> middle_of(const FormVector<N>& x) {
  return {AffineForm<0>(x[0].mid), AffineForm<0>(x[1].mid), AffineForm<0>(x[2].mid)};
}

/// Two circles (D = 2) or three spheres (D = 3).
template <std::size_t D, int N>
std::optional<TwoPositions<N>> meet(const std::array<FormVector<N>, D>& centers,
                                    const std::array<AffineForm<N>, D>& squares) {
  if constexpr (D == 2)
    return meet_circles(centers, squares);
  else
    return meet_spheres(centers, squares);
}

/// Points at given squared distances from D centres in D dimensions as fixed points of Newton's method. With
/// m an intersection of the middles, d_i the way to it from centre i, δ the way on from it to the point and J
/// the rows d_i at their middles,
///   2 J δ = squares − |d_i|² − |δ|² − 2 (d_i − mid d_i)·δ.
template <std::size_t D, int N>
class SidePlacing {
 public:
  /// Keeps references.
  SidePlacing(const std::array<FormVector<N>, D>& centers, const std::array<AffineForm<N>, D>& squares)
      : centers_(centers), squares_(squares) {
    std::array<FormVector<0>, D> middles;
    std::array<AffineForm<0>, D> middle_squares;
    for (std::size_t i = 0; i < D; ++i) {
      middles[i] = middle_of(centers[i]);
      middle_squares[i] = AffineForm<0>(squares[i].mid);
    }
    both_ = meet<D>(middles, middle_squares);
    if (both_ && !(both_->discriminant.low() > 0)) both_.reset();
  }

  /// The point on one side for all values of the symbols, or nothing where that cannot be proven. Exactly one
  /// of the two intersections lies on each side of the centres' line or plane, so that one that is found
  /// there is it.
  std::optional<FormVector<N>> verified(int side) const {
    if (!both_) return std::nullopt;
    const Newton newton(both_->on(side), centers_, squares_);
    if (!newton.inverse.allFinite()) return std::nullopt;
    FormVector<N> guess = newton.step({});
    const FormVector<N> second = newton.step(guess);
    for (std::size_t axis = 0; axis < D; ++axis)
      guess[axis].rest =
          2 * std::max(second[axis].rest, guess[axis].rest) + distance(second[axis], guess[axis]);
    const FormVector<N> way = newton.step(guess);
    for (std::size_t axis = 0; axis < D; ++axis)
      if (!(distance(way[axis], guess[axis]) + way[axis].rest < guess[axis].rest)) return std::nullopt;
    const FormVector<N> point = newton.middle + way;
    if (!((static_cast<double>(side) * height(point)).low() > 0)) return std::nullopt;
    return point;
  }

 private:
  using Matrix = Eigen::Matrix<double, D, D>;

  struct Newton {
    FormVector<N> middle{};
    std::array<FormVector<N>, D> ways;  ///< without their middles
    std::array<AffineForm<N>, D> excess;
    Matrix inverse, defect;

    Newton(const FormVector<0>& start, const std::array<FormVector<N>, D>& centers,
           const std::array<AffineForm<N>, D>& squares) {
      Matrix jacobian;
      for (std::size_t axis = 0; axis < D; ++axis) middle[axis].mid = start[axis].mid;
      for (std::size_t i = 0; i < D; ++i) {
        ways[i] = middle - centers[i];
        excess[i] = squares[i] - square(ways[i]);
        for (std::size_t axis = 0; axis < D; ++axis) {
          jacobian(i, axis) = 2 * ways[i][axis].mid;
          ways[i][axis].mid = 0;
        }
      }
      inverse = jacobian.inverse();
      // The inverse is rounded: what of δ it leaves over.
      defect = (inverse * jacobian - Matrix::Identity()).cwiseAbs() +
               16 * AffineForm<N>::epsilon * inverse.cwiseAbs() * jacobian.cwiseAbs();
    }

    FormVector<N> step(const FormVector<N>& way) const {
      const AffineForm<N> bend = square(way);
      std::array<AffineForm<N>, D> right;
      for (std::size_t i = 0; i < D; ++i) right[i] = excess[i] - bend - 2.0 * dot(ways[i], way);
      FormVector<N> result{};
      for (std::size_t row = 0; row < D; ++row)
        for (std::size_t i = 0; i < D; ++i) {
          result[row] = result[row] + inverse(row, i) * right[i];
          result[row].rest += defect(row, i) * (std::abs(way[i].mid) + way[i].radius());
        }
      return result;
    }
  };

  /// Between the linear parts, at most.
  static double distance(const AffineForm<N>& x, const AffineForm<N>& y) {
    double sum = std::abs(x.mid - y.mid);
    for (int i = 0; i < N; ++i) sum += std::abs(x.slope[i] - y.slope[i]);
    return sum * (1 + 8 * AffineForm<N>::epsilon);
  }

  /// Of the point above the line or plane of the centres, with a positive factor.
  AffineForm<N> height(const FormVector<N>& point) const {
    const FormVector<N> axis = centers_[1] - centers_[0];
    const FormVector<N> way = point - centers_[0];
    if constexpr (D == 2)
      return axis[0] * way[1] - axis[1] * way[0];
    else
      return dot(cross(axis, centers_[2] - centers_[0]), way);
  }

  const std::array<FormVector<N>, D>& centers_;
  const std::array<AffineForm<N>, D>& squares_;
  std::optional<TwoPositions<0>> both_;
};

}  // namespace gcs
