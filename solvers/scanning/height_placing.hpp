#pragma once
/// Enclosures of points near the end of their branch.
///
/// Where the sides on which spheres meet come together, a point moves by the root of what an angle moves, and
/// no enclosure in terms of the angle is sharp. There the point's height above the line or plane of the
/// centres is the parameter, and the angle depends on it: both are smooth in it, through the branch end.

#include <vector>

#include "solvers/scanning/form_contraction.hpp"
#include "solvers/scanning/form_placing.hpp"

namespace gcs {

/// A symbol given up: on the branch it is a form in the others and in the one that takes its place.
template <int N>
struct Exchange {
  int symbol = -1;
  AffineForm<N> value;

  AffineForm<N> of(const AffineForm<N>& x) const {
    AffineForm<N> others = x;
    others.slope[symbol] = 0;
    return others + x.slope[symbol] * value;
  }
  FormVector<N> of(const FormVector<N>& x) const { return {of(x[0]), of(x[1]), of(x[2])}; }
};

/// How far a symbol moves a point's coordinates, together.
template <int N>
double moved_by(int symbol, const FormVector<N>& point) {
  return std::abs(point[0].slope[symbol]) + std::abs(point[1].slope[symbol]) +
         std::abs(point[2].slope[symbol]);
}

/// A point in terms of its height, and the angle that the height replaces.
template <int N>
struct PointByHeight {
  FormVector<N> position;
  Exchange<N> exchange;

  /// Whether all points, of which `placed` are still in terms of the angle, become better known than with
  /// this one at `by_angle`, and so well that what halving the height can take away is the most of what is
  /// unknown. `placed` may hold zero vectors for points that are not placed.
  bool is_worth_it(const std::vector<FormVector<N>>& placed, const FormVector<N>& by_angle) const {
    double before = unknown_of(by_angle);
    double unknown = unknown_of(position);
    double moved = moved_by(exchange.symbol, position);
    for (const FormVector<N>& point : placed) {
      const FormVector<N> exchanged = exchange.of(point);
      before = std::max(before, unknown_of(point));
      unknown = std::max(unknown, unknown_of(exchanged));
      moved = std::max(moved, moved_by(exchange.symbol, exchanged));
    }
    return unknown < std::min(before, moved);
  }
};

/// Sharpens what is known of a point p on D surfaces in D dimensions, the first a sphere around c_0, at the height
/// n·(p − c_0) = σ along the normal n of their common normals' line or plane. With x the exchanged symbol less its middle,
/// d_i the constant way from the centre of sphere i to the middle m of the point, δ = p − m, s_i and n' the slopes
/// of c_i and n by x, e_i and e_n what else is in m − d_i − c_i and n − n_0, and
/// v_i = p − c_i − d_i = δ − s_i x + e_i,
///   2 d_i·δ − 2 d_i·s_i x = squares_i − |d_i|² − 2 d_i·e_i − |v_i|²,
///   n_0·δ + (n'·d_0 − n_0·s_0) x = σ − n_0·d_0 − n_0·e_0 − e_n·d_0 − (n' x + e_n)·v_0;
/// of a plane q_i·p = o_i, with the constants q_0 and o_0, the slopes q' and o' and what else there is, e_q and e_o,
///   q_0·δ + (q'·m − o') x = o_0 + e_o − q_0·m − e_q·m − (q' x + e_q)·δ.
/// The matrix is regular at the branch end too. Every point of the branch satisfies them: an enclosure put
/// in on the right gives another one.
template <std::size_t D, int N>
class HeightPlacing {
 public:
  /// Keeps a reference.
  explicit HeightPlacing(const std::array<FormSurface<N>, D>& surfaces) : surfaces_(surfaces) {}

  /// At the heights `sigma` along `normal`, from an enclosure in the same symbols; surfaces and the
  /// normal are in terms of the angle.
  PointByHeight<N> sharpened(PointByHeight<N> known, const FormVector<N>& normal,
                             const AffineForm<N>& sigma) const {
    for (int i = 0; i < most_passes; ++i) {
      const PointByHeight<N> next = pass(known, normal, sigma);
      if (!(unknown_of(next.position) < unknown_of(known.position))) break;
      known = next;
    }
    return known;
  }

 private:
  static constexpr int most_passes = 4;  ///< what is unknown falls with its square: more do not pay
  static constexpr int size = static_cast<int>(D) + 1;
  using Equations = FormEquations<size, N>;
  using Form = AffineForm<N>;
  using Position = FormVector<N>;
  using Point = Eigen::Vector3d;

  /// constant + slope x + others.
  struct Expansion {
    Point constant, slope;
    Position others;

    Expansion(const Position& form, const Exchange<N>& at_middle) : others(at_middle.of(form)) {
      for (int axis = 0; axis < 3; ++axis) {
        slope[axis] = form[axis].slope[at_middle.symbol];
        constant[axis] = others[axis].mid;
        others[axis].mid = 0;
      }
    }
  };

  PointByHeight<N> pass(const PointByHeight<N>& known, const Position& normal, const Form& sigma) const {
    Point middle;
    Position delta = known.position;
    for (int axis = 0; axis < 3; ++axis) {
      middle[axis] = delta[axis].mid;
      delta[axis].mid = 0;
    }
    const double angle = known.exchange.value.mid;
    const Exchange<N> at_middle{known.exchange.symbol, Form(angle)};
    Form x = known.exchange.value;
    x.mid = 0;
    std::array<double, size> reach;
    for (std::size_t axis = 0; axis < D; ++axis) reach[axis] = delta[axis].radius();
    reach[D] = x.radius();
    const std::array<Form, size> solved = equations(middle, delta, at_middle, x, normal, sigma).solve(reach);
    PointByHeight<N> result{constant_form<N>(middle), {at_middle.symbol, solved[D] + angle}};
    for (std::size_t axis = 0; axis < D; ++axis) result.position[axis] = result.position[axis] + solved[axis];
    return result;
  }

  Equations equations(const Point& middle, const Position& delta, const Exchange<N>& at_middle, const Form& x,
                      const Position& normal, const Form& sigma) const {
    Equations result;
    const Expansion n(normal, at_middle);
    for (std::size_t i = 0; i < D; ++i) {
      if (surfaces_[i].is_plane) {
        take_plane(i, middle, delta, at_middle, x, result);
        continue;
      }
      const Expansion c(surfaces_[i].vector, at_middle);
      const Point d = middle - c.constant;
      const Position e =
          constant_form<N>(middle) - constant_form<N>(d) - constant_form<N>(c.constant) - c.others;
      const Position v = delta - x * constant_form<N>(c.slope) + e;
      result.matrix.row(i) << 2 * d.head<D>().transpose(), -2 * d.dot(c.slope);
      result.terms.row(i) << 2 * d.head<D>().cwiseAbs().transpose(), 2 * d.cwiseAbs().dot(c.slope.cwiseAbs());
      result.right[i] = surfaces_[i].number - square(constant_form<N>(d)) - 2 * dot(d, e) - square(v);
      if (i > 0) continue;
      result.matrix.row(D) << n.constant.template head<D>().transpose(),
          n.slope.dot(d) - n.constant.dot(c.slope);
      result.terms.row(D) << n.constant.template head<D>().cwiseAbs().transpose(),
          n.slope.cwiseAbs().dot(d.cwiseAbs()) + n.constant.cwiseAbs().dot(c.slope.cwiseAbs());
      result.right[D] = sigma - dot(n.constant, constant_form<N>(d)) - dot(n.constant, e) - dot(d, n.others) -
                        dot(x * constant_form<N>(n.slope) + n.others, v);
    }
    return result;
  }

  void take_plane(std::size_t i, const Point& middle, const Position& delta, const Exchange<N>& at_middle,
                  const Form& x, Equations& result) const {
    const Expansion q(surfaces_[i].vector, at_middle);
    const Form& number = surfaces_[i].number;
    const double rate = number.slope[static_cast<std::size_t>(at_middle.symbol)];
    result.matrix.row(i) << q.constant.template head<D>().transpose(), q.slope.dot(middle) - rate;
    result.terms.row(i) << q.constant.template head<D>().cwiseAbs().transpose(),
        q.slope.cwiseAbs().dot(middle.cwiseAbs()) + std::abs(rate);
    result.right[i] = at_middle.of(number) - dot(q.constant, constant_form<N>(middle)) -
                      dot(middle, q.others) - dot(x * constant_form<N>(q.slope) + q.others, delta);
  }

  const std::array<FormSurface<N>, D>& surfaces_;
};

}  // namespace gcs
