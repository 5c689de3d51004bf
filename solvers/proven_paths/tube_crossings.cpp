#include "solvers/proven_paths/tube_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

constexpr double smallest_piece = 0x1p-40;  ///< of the half length

/// t − level along the tube's polynomial, and how far the arc's own t and dt/ds are from it, rounding
/// included.
class TimeCurve {
 public:
  TimeCurve(const PathTube& tube, double level)
      : coefficients_(tube.curve().coefficients().row(tube.curve().coefficients().rows() - 1)) {
    double power = 1, size = std::abs(coefficients_[0]) + std::abs(level), speed = 0;
    for (Eigen::Index n = 1; n < coefficients_.size(); ++n, power *= tube.half_length()) {
      size += std::abs(coefficients_[n]) * power * tube.half_length();
      speed += static_cast<double>(n) * std::abs(coefficients_[n]) * power;
    }
    coefficients_[0] -= level;
    // A Taylor shift of order n loses at most 2n roundings of what the terms of both shifts add up to.
    const double rounding =
        static_cast<double>(4 * coefficients_.size()) * std::numeric_limits<double>::epsilon();
    error_ = (tube.time_radius() + rounding * size) * round_up;
    slope_error_ = (tube.time_speed_radius() + rounding * speed) * round_up;
  }

  double value(double s) const {
    double result = 0;
    for (Eigen::Index n = coefficients_.size() - 1; n >= 0; --n) result = result * s + coefficients_[n];
    return result;
  }

  int side(double s) const {
    const double at = value(s);
    return at > error_ ? 1 : at < -error_ ? -1 : 0;
  }

  struct Piece {
    bool misses_zero = false;
    bool is_monotone = false;
    bool rises = false;
    bool falls = false;
  };
  Piece piece(double first, double last) const {
    Eigen::VectorXd shifted = coefficients_;
    const double middle = (first + last) / 2, half = (last - first) / 2 * round_up;
    for (Eigen::Index level = 0; level < shifted.size(); ++level)
      for (Eigen::Index n = shifted.size() - 2; n >= level; --n) shifted[n] += middle * shifted[n + 1];
    double spread = 0, slope_spread = 0, power = 1;
    for (Eigen::Index n = 1; n < shifted.size(); ++n) {
      if (n > 1) slope_spread += static_cast<double>(n) * std::abs(shifted[n]) * power;
      power *= half;
      spread += std::abs(shifted[n]) * power;
    }
    const double slope_reach = (slope_spread + slope_error_) * round_up;
    return {std::abs(shifted[0]) > (spread + error_) * round_up, std::abs(shifted[1]) > slope_reach,
            shifted[1] > slope_reach, shifted[1] < -slope_reach};
  }

  double root(double low, double high, int side_of_high) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (value(middle) * side_of_high > 0 ? high : low) = middle;
    }
    return (low + high) / 2;
  }

 private:
  Eigen::VectorXd coefficients_;
  double error_ = 0, slope_error_ = 0;
};

/// How far from `first` on, in steps of at least `smallest`, t is proven to grow.
double grown_until(const TimeCurve& curve, double first, double last, double smallest) {
  if (curve.piece(first, last).rises) return last;
  if (last - first < smallest) return first;
  const double middle = (first + last) / 2, until = grown_until(curve, first, middle, smallest);
  return until < middle ? until : grown_until(curve, middle, last, smallest);
}

struct End {
  double s = 0;
  int side = 0;
};

class Isolation {
 public:
  Isolation(const TimeCurve& curve, double smallest) : curve_(curve), smallest_(smallest) {}

  bool decide(const End& first, const End& last) {
    const TimeCurve::Piece piece = curve_.piece(first.s, last.s);
    if (piece.misses_zero) return true;
    if (piece.is_monotone) {
      if (first.side != last.side) found.push_back({curve_.root(first.s, last.s, last.side), last.side});
      return true;
    }
    if (last.s - first.s < smallest_) return false;
    for (const double part : {0.5, 0.37, 0.61}) {
      const double s = first.s + part * (last.s - first.s);
      const End middle{s, curve_.side(s)};
      if (middle.side != 0) return decide(first, middle) && decide(middle, last);
    }
    return false;
  }

  std::vector<TubeCrossing> found;

 private:
  const TimeCurve& curve_;
  double smallest_;
};

}  // namespace

int side_of(const PathTube& tube, double level, double s) { return TimeCurve(tube, level).side(s); }

std::optional<std::vector<TubeCrossing>> crossings_of(const PathTube& tube, double level,
                                                      const ParameterRange& first,
                                                      const ParameterRange& last) {
  const TimeCurve curve(tube, level);
  const End start{first.high, curve.side(first.high)}, end{last.low, curve.side(last.low)};
  if (!curve.piece(first.low, first.high).misses_zero || !curve.piece(last.low, last.high).misses_zero)
    return std::nullopt;
  if (start.side == 0 || end.side == 0) return std::nullopt;
  Isolation isolation(curve, smallest_piece * tube.half_length());
  if (!isolation.decide(start, end)) return std::nullopt;
  return isolation.found;
}

TubeGrowth growth_of(const PathTube& tube, double first, double last) {
  const TimeCurve curve(tube, 0);
  const double smallest = smallest_piece * tube.half_length();
  TubeGrowth growth{grown_until(curve, first, last, smallest), std::nullopt};
  for (double ahead = smallest; growth.until + ahead <= last && growth.until < last; ahead *= 2) {
    const double s = growth.until + ahead;
    if (!curve.piece(s, s).falls) continue;
    growth.falls_at = s;
    break;
  }
  return growth;
}

PointBox arc_between(const PathTube& tube, const ParameterRange& s) {
  PointBox box = tube.at((s.low + s.high) / 2).hull();
  const PointBox tangent = tube.tangent(s);
  box.radius += (s.high - s.low) / 2 * round_up * (tangent.mid.cwiseAbs() + tangent.radius);
  box.radius *= round_up;
  return box;
}

std::optional<PointBox> enclosed_crossing(const PathTube& tube, double level, const ParameterRange& s) {
  constexpr int most_widenings = 12;
  const Eigen::Index time = tube.curve().coefficients().rows() - 1;
  double near = TimeCurve(tube, level).root(s.low, s.high, 1), reach = 0;
  for (int i = 0; i < 2; ++i) {
    const ArcPoint at = tube.at(near);
    const double slope = at.tangent.mid[time], step = (at.point.mid[time] - level) / slope;
    near = std::clamp(near - step, s.low, s.high);
    reach = (1.25 * at.hull().radius[time] + std::abs(at.point.mid[time]) * 0x1p-50) / slope;
  }
  if (!(reach > 0)) return std::nullopt;
  const auto side_at = [&](double place) {
    const PointBox box = tube.at(place).hull();
    return box.mid[time] - box.radius[time] > level ? 1 : box.mid[time] + box.radius[time] < level ? -1 : 0;
  };
  for (int i = 0; i < most_widenings; ++i, reach *= 2) {
    const ParameterRange around{std::max(near - reach, s.low), std::min(near + reach, s.high)};
    if (side_at(around.low) < 0 && side_at(around.high) > 0) return arc_between(tube, around);
  }
  return std::nullopt;
}

}  // namespace gcs
