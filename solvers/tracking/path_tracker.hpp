#pragma once
/// Follows the paths of a homotopy H(x, t) = 0 in C^n from t = 0 to t = 1.
///
/// Predictor: the classical Runge–Kutta method of order 4 for dx/dt = −H_x⁻¹ H_t, which needs nothing but the
/// homotopy's first derivatives. Corrector: Newton's method at fixed t. The step is doubled after three
/// accepted ones and halved where the corrector has to move the prediction too far: that is what keeps a path
/// from being taken for its neighbour, and it is a heuristic.
///
/// A path whose end is regular is followed to it. For the others there is an endgame (Morgan, Sommese,
/// Wampler 1991): t goes around 1 in a circle until the path closes, after w rounds; the mean of the samples
/// is x(1) but for terms that fall with a power of the radius, by Cauchy's formula for a power series in
/// (1 − t)^(1/w). Where other branch points are within the circle the mean is none of the path's; it is no
/// zero of H(·, 1) then, and the circle is made smaller. An end with w > 1 or a singular Jacobian is
/// singular.
///
/// Paths have to stay bounded: ends at infinity become ordinary points where the homotopy is homogeneous and
/// one of its equations is a random affine patch (Sommese, Wampler 2005, section 3.7).

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <limits>
#include <numbers>
#include <string>

#include "solvers/running/work.hpp"

namespace gcs {

template <int n>
using ComplexVector = Eigen::Matrix<std::complex<double>, n, 1>;
template <int n>
using ComplexMatrix = Eigen::Matrix<std::complex<double>, n, n>;

/// H, H_x and H_t at one place.
template <int n>
struct HomotopyValue {
  ComplexVector<n> value;
  ComplexMatrix<n> jacobian;
  ComplexVector<n> t_derivative;
};

template <class H>
concept Homotopy = requires(const H& homotopy, const ComplexVector<H::unknowns>& x, std::complex<double> t) {
  { homotopy.at(x, t) } -> std::same_as<HomotopyValue<H::unknowns>>;
};

/// The value and Jacobian of a system of n equations in n unknowns.
template <int n>
struct SystemValue {
  ComplexVector<n> value;
  ComplexMatrix<n> jacobian;
};

/// (1 − t) γ start + t target, with γ on the unit circle (Sommese, Wampler 2005, section 8.3).
template <int n>
HomotopyValue<n> straight_line(const SystemValue<n>& start, const SystemValue<n>& target,
                               std::complex<double> gamma, std::complex<double> t) {
  const std::complex<double> of_start = (1.0 - t) * gamma;
  return {of_start * start.value + t * target.value, of_start * start.jacobian + t * target.jacobian,
          target.value - gamma * start.value};
}

template <int n>
struct TrackingEnd {
  enum class Kind { regular, singular, failed };
  Kind kind = Kind::failed;
  ComplexVector<n> x = ComplexVector<n>::Zero();  ///< at t = 1, or where it failed
  int winding_number = 1;
  std::string cause;  ///< why it failed
};

template <Homotopy H>
class PathTracker {
 public:
  static constexpr int n = H::unknowns;
  using Complex = std::complex<double>;
  using Vector = ComplexVector<n>;
  using End = TrackingEnd<n>;

  /// Unknowns and equations are to be of order 1. Adds to `work`.
  PathTracker(const H& homotopy, WorkCounters& work) : homotopy_(homotopy), work_(work) {}

  /// The end of the path that starts at `start`, a regular zero of H(·, 0).
  End follow(const Vector& start) {
    Vector x = start;
    if (!move(x, 0, 1 - largest_radius)) return failed(x, "the steps became too small before the endgame");
    if (Vector end = x; move(end, 1 - largest_radius, 1) && is_regular(end))
      return {End::Kind::regular, end, 1, ""};
    return endgame(x);
  }

 private:
  /// Beyond it the endgame cannot know of singularities of the path near t = 1.
  static constexpr double largest_radius = 1.0 / 16;
  /// Circles below this are too small for the rounding of what is near t = 1.
  static constexpr double smallest_radius = 1e-12;
  static constexpr double radius_ratio = 1.0 / 8;
  static constexpr double smallest_step = 1e-10;  ///< of a stretch of the path
  static constexpr int most_rounds = 24;
  static constexpr int corners = 16;             ///< samples of a round
  static constexpr double closed = 1e-7;         ///< two samples are one point, relative to 1 + |x|
  static constexpr double agreed = 1e-13;        ///< two means, likewise: rounding
  static constexpr double nearly_agreed = 1e-8;  ///< where rounding lets them agree no better
  static constexpr double zero = 1e-11;          ///< the equations, relative, at a mean right to rounding
  static constexpr double singular = 1e-10;      ///< reciprocal condition, in which units differ
  /// A Newton step at a regular end, relative to 1 + |x|; near a double one steps of 1e-8 only halve.
  static constexpr double at_rest = 1e-9;
  /// The same, relative to the reciprocal condition: below 1/2 a simple zero is near (Kantorovich).
  static constexpr double convergent = 1e-3;

  /// A walk around t = 1 and how many rounds it took; 0: it did not close.
  struct Loop {
    int rounds = 0;
    Vector mean = Vector::Zero();
  };

  static End failed(const Vector& x, const std::string& cause) { return {End::Kind::failed, x, 1, cause}; }

  /// Along a straight line in t. False when the steps become too small.
  bool move(Vector& x, Complex from, Complex to) {
    double done = 0, step = 0.25;
    int accepted = 0;
    while (done < 1) {
      step = std::min(step, 1 - done);
      const Complex t = from + done * (to - from), dt = step * (to - from);
      Vector next = x;
      if (predict(next, t, dt) && correct(next, t + dt)) {
        x = next;
        done += step;
        ++work_.iterations;
        if (++accepted % 3 == 0) step *= 2;
        continue;
      }
      ++work_.rejected_steps;
      accepted = 0;
      step /= 2;
      if (step < smallest_step) return false;
    }
    return true;
  }

  /// Counts the work of it.
  HomotopyValue<n> evaluate(const Vector& x, Complex t) {
    ++work_.evaluations;
    ++work_.jacobians;
    return homotopy_.at(x, t);
  }

  /// Counts the work of it.
  Eigen::PartialPivLU<Eigen::MatrixXcd> factorise(const HomotopyValue<n>& at) {
    ++work_.factorisations;
    return Eigen::PartialPivLU<Eigen::MatrixXcd>(at.jacobian);
  }

  /// dx/dt
  Vector slope(const Vector& x, Complex t) {
    const HomotopyValue<n> at = evaluate(x, t);
    return -factorise(at).solve(at.t_derivative);
  }

  bool predict(Vector& x, Complex t, Complex dt) {
    const Vector k1 = slope(x, t);
    const Vector k2 = slope(x + dt / 2.0 * k1, t + dt / 2.0);
    const Vector k3 = slope(x + dt / 2.0 * k2, t + dt / 2.0);
    const Vector k4 = slope(x + dt * k3, t + dt);
    x += dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    return x.allFinite();
  }

  /// The first correction tells how good the prediction was; after the last one the error is of the order of
  /// its square.
  bool correct(Vector& x, Complex t) {
    constexpr int most_iterations = 3;
    constexpr double furthest = 1e-5, last = 1e-8;
    for (int i = 0; i < most_iterations; ++i) {
      const HomotopyValue<n> at = evaluate(x, t);
      const Vector change = factorise(at).solve(at.value);
      ++work_.newton_iterations;
      x -= change;
      const double length = change.norm() / (1 + x.norm());
      if (!(length <= furthest)) return false;
      if (length <= last) return true;
    }
    return false;
  }

  /// Adds the samples of one round to `sum`. False when the path was lost.
  bool go_around(double radius, Vector& x, Vector& sum) {
    const auto place = [radius](int corner) {
      return 1.0 - std::polar(radius, 2 * std::numbers::pi * corner / corners);
    };
    for (int corner = 0; corner < corners; ++corner) {
      sum += x;
      if (!move(x, place(corner), place(corner + 1))) return false;
    }
    return true;
  }

  Loop walk(const Vector& start, double radius) {
    Vector x = start, sum = Vector::Zero();
    for (int round = 1; round <= most_rounds; ++round) {
      if (!go_around(radius, x, sum)) return {};
      if ((x - start).norm() <= closed * (1 + start.norm()))
        return {round, sum / static_cast<double>(corners * round)};
    }
    return {};
  }

  /// The means of two walks of as many rounds agree when the terms that they neglect are below rounding.
  End endgame(Vector x) {
    Loop last;
    double last_change = std::numeric_limits<double>::infinity();
    for (double radius = largest_radius; radius >= smallest_radius; radius *= radius_ratio) {
      const Loop loop = walk(x, radius);
      const double change = loop.rounds > 0 && loop.rounds == last.rounds
                                ? (loop.mean - last.mean).norm() / (1 + loop.mean.norm())
                                : std::numeric_limits<double>::infinity();
      const bool agree = change <= agreed || (change <= nearly_agreed && change > last_change);
      if (agree && is_zero(loop.mean)) return end_at(loop);
      last_change = change;
      last = loop;
      if (!move(x, 1 - radius, 1 - radius_ratio * radius))
        return failed(x, "the steps became too small in the endgame");
    }
    return failed(x, "the circles around the end did not agree");
  }

  /// Of H(·, 1), relative to what moving x by its own size would change.
  bool is_zero(const Vector& x) {
    const HomotopyValue<n> at = evaluate(x, 1);
    return at.value.norm() <= zero * at.jacobian.norm() * (1 + x.norm());
  }

  bool is_regular(const Vector& x) {
    const HomotopyValue<n> at = evaluate(x, 1);
    const Eigen::PartialPivLU<Eigen::MatrixXcd> lu = factorise(at);
    const double reciprocal = lu.rcond(), step = lu.solve(at.value).norm() / (1 + x.norm());
    return reciprocal > singular && step <= std::min(at_rest, convergent * reciprocal);
  }

  End end_at(const Loop& loop) {
    const bool regular = loop.rounds == 1 && is_regular(loop.mean);
    return {regular ? End::Kind::regular : End::Kind::singular, loop.mean, loop.rounds, ""};
  }

  const H& homotopy_;
  WorkCounters& work_;
};

}  // namespace gcs
