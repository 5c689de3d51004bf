#pragma once
/// Enclosures of the points that the steps of a scan plan place, over a cell of angles.
///
/// Where a sphere meets spheres and planes there are two ways. One carries the closed formula through; it always gives something,
/// up to the branch end, but takes what is unknown of a surface for many independent unknowns. The other
/// verifies an enclosure by Newton's method; there the unknown enters with its true weight, but it needs to
/// be away from the branch end.

#include <Eigen/LU>
#include <optional>

#include "solvers/numeric/affine_form.hpp"

namespace gcs {

/// A sphere |p − vector|² = number or, where it is one, a plane vector·p = number.
template <int N>
struct FormSurface {
  FormVector<N> vector;
  AffineForm<N> number;
  bool is_plane = false;
};

/// Along the plane that holds what a sphere and another surface have in common.
template <int N>
FormVector<N> common_normal(const FormSurface<N>& sphere, const FormSurface<N>& other) {
  return other.is_plane ? other.vector : other.vector - sphere.vector;
}

/// (p − c)·normal of its points p, where c is the sphere's centre.
template <int N>
AffineForm<N> offset_along(const FormVector<N>& normal, const FormSurface<N>& sphere,
                           const FormSurface<N>& other) {
  if (other.is_plane) return other.number - dot(normal, sphere.vector);
  return 0.5 * (sphere.number - other.number + square(normal));
}

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

/// Two circles in the plane z = const. Nothing where the centres may coincide within the cell.
template <int N>
std::optional<TwoPositions<N>> meet(const std::array<FormSurface<N>, 2>& circles) {
  const FormVector<N> axis = common_normal(circles[0], circles[1]);
  const AffineForm<N> gap = square(axis);
  if (!has_reciprocal(gap)) return std::nullopt;
  const AffineForm<N> one_over_gap = reciprocal(gap);
  const AffineForm<N> fraction = offset_along(axis, circles[0], circles[1]) * one_over_gap;
  return TwoPositions<N>{circles[0].vector + fraction * axis,
                         FormVector<N>{-axis[1], axis[0], AffineForm<N>()},
                         circles[0].number * one_over_gap - square(fraction)};
}

/// A sphere and two further surfaces. Nothing where their common planes may be parallel within the cell.
template <int N>
std::optional<TwoPositions<N>> meet(const std::array<FormSurface<N>, 3>& surfaces) {
  const FormVector<N> a = common_normal(surfaces[0], surfaces[1]);
  const FormVector<N> b = common_normal(surfaces[0], surfaces[2]);
  const FormVector<N> normal = cross(a, b);
  const AffineForm<N> area = square(normal);
  if (!has_reciprocal(area)) return std::nullopt;
  const AffineForm<N> one_over_area = reciprocal(area);
  const AffineForm<N> aa = square(a);
  const AffineForm<N> bb = square(b);
  const AffineForm<N> ab = dot(a, b);
  const AffineForm<N> along_a = offset_along(a, surfaces[0], surfaces[1]);
  const AffineForm<N> along_b = offset_along(b, surfaces[0], surfaces[2]);
  const FormVector<N> foot = (one_over_area * (along_a * bb - along_b * ab)) * a +
                             (one_over_area * (along_b * aa - along_a * ab)) * b;
  return TwoPositions<N>{surfaces[0].vector + foot, normal,
                         (surfaces[0].number - square(foot)) * one_over_area};
}

/// The circle in which a sphere meets another surface; angles count from a right angle to `up`. Nothing where the
/// centres may coincide within the cell, or `up` be normal to the circle.
template <int N>
std::optional<FormCircle<N>> common_circle(const std::array<FormSurface<N>, 2>& surfaces,
                                           const FormVector<N>& up) {
  const FormVector<N> axis = common_normal(surfaces[0], surfaces[1]);
  const AffineForm<N> gap = square(axis);
  if (!has_reciprocal(gap)) return std::nullopt;
  const AffineForm<N> one_over_gap = reciprocal(gap);
  const FormVector<N> second = up - (dot(up, axis) * one_over_gap) * axis;
  const AffineForm<N> length = square(second);
  if (!has_reciprocal(length)) return std::nullopt;
  const FormVector<N> second_unit = reciprocal(sqrt(length)) * second;
  const FormVector<N> axis_unit = sqrt(one_over_gap) * axis;
  const AffineForm<N> fraction = offset_along(axis, surfaces[0], surfaces[1]) * one_over_gap;
  return FormCircle<N>{surfaces[0].vector + fraction * axis, surfaces[0].number - square(fraction) * gap,
                       cross(second_unit, axis_unit), second_unit};
}

/// Not negative where the sphere meets the other surfaces: the discriminant times the squared length of the common normal,
/// or times the squared area of the parallelogram of two. A polynomial: it decides where these vanish.
template <int N>
AffineForm<N> room_to_meet(const std::array<FormSurface<N>, 2>& surfaces) {
  const FormVector<N> axis = common_normal(surfaces[0], surfaces[1]);
  return surfaces[0].number * square(axis) - square(offset_along(axis, surfaces[0], surfaces[1]));
}

template <int N>
AffineForm<N> room_to_meet(const std::array<FormSurface<N>, 3>& surfaces) {
  const FormVector<N> a = common_normal(surfaces[0], surfaces[1]);
  const FormVector<N> b = common_normal(surfaces[0], surfaces[2]);
  const AffineForm<N> along_a = offset_along(a, surfaces[0], surfaces[1]);
  const AffineForm<N> along_b = offset_along(b, surfaces[0], surfaces[2]);
  return surfaces[0].number * square(cross(a, b)) - square(along_a * b - along_b * a);
}

/// The middles of forms, as forms without symbols.
template <int N>
FormVector<0> middle_of(const FormVector<N>& x) {
  return {AffineForm<0>(x[0].mid), AffineForm<0>(x[1].mid), AffineForm<0>(x[2].mid)};
}

/// Points on D surfaces in D dimensions, the first a sphere, as fixed points of Newton's method. With m an intersection of
/// the middles, δ the way on from it to the point, d_i the way from the centre of sphere i to m, n_i the normal of plane i
/// and J the rows 2 d_i and n_i at their middles,
///   (J δ)_i = square_i − |d_i|² − |δ|² − 2 (d_i − mid d_i)·δ or offset_i − n_i·m − (n_i − mid n_i)·δ.
template <std::size_t D, int N>
class SidePlacing {
 public:
  /// Keeps a reference.
  explicit SidePlacing(const std::array<FormSurface<N>, D>& surfaces) : surfaces_(surfaces) {
    std::array<FormSurface<0>, D> middles;
    for (std::size_t i = 0; i < D; ++i)
      middles[i] = {middle_of(surfaces[i].vector), AffineForm<0>(surfaces[i].number.mid),
                    surfaces[i].is_plane};
    both_ = meet(middles);
    if (both_ && !(both_->discriminant.low() > 0)) both_.reset();
  }

  /// The point on one side for all values of the symbols, or nothing where that cannot be proven. Exactly one
  /// of the two intersections lies on each side of the common normals' line or plane, so that one that is found
  /// there is it.
  std::optional<FormVector<N>> verified(int side) const {
    if (!both_) return std::nullopt;
    const Newton newton(both_->on(side), surfaces_);
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
    std::array<FormVector<N>, D> gradients;  ///< without their middles
    std::array<bool, D> is_plane;
    std::array<AffineForm<N>, D> excess;
    Matrix inverse, defect;

    Newton(const FormVector<0>& start, const std::array<FormSurface<N>, D>& surfaces) {
      Matrix jacobian;
      for (std::size_t axis = 0; axis < D; ++axis) middle[axis].mid = start[axis].mid;
      for (std::size_t i = 0; i < D; ++i) {
        const FormSurface<N>& surface = surfaces[i];
        is_plane[i] = surface.is_plane;
        const FormVector<N> way = surface.is_plane ? surface.vector : middle - surface.vector;
        excess[i] = surface.number - (surface.is_plane ? dot(way, middle) : square(way));
        gradients[i] = surface.is_plane ? way : AffineForm<N>(2) * way;
        for (std::size_t axis = 0; axis < D; ++axis) {
          jacobian(i, axis) = gradients[i][axis].mid;
          gradients[i][axis].mid = 0;
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
      for (std::size_t i = 0; i < D; ++i) {
        right[i] = excess[i] - dot(gradients[i], way);
        if (!is_plane[i]) right[i] = right[i] - bend;
      }
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

  /// Of the point above the line or plane of the common normals, with a positive factor.
  AffineForm<N> height(const FormVector<N>& point) const {
    const FormVector<N> axis = common_normal(surfaces_[0], surfaces_[1]);
    const FormVector<N> way = point - surfaces_[0].vector;
    if constexpr (D == 2)
      return axis[0] * way[1] - axis[1] * way[0];
    else
      return dot(cross(axis, common_normal(surfaces_[0], surfaces_[2])), way);
  }

  const std::array<FormSurface<N>, D>& surfaces_;
  std::optional<TwoPositions<0>> both_;
};

}  // namespace gcs
