#pragma once
/// Follows several paths x(s) of f(x; A(s)) = 0 side by side, s from 0 to 1; see lane_kernel.hpp for how.

#include <array>
#include <complex>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "solvers/lanes/elimination.hpp"
#include "solvers/lanes/monomial_system.hpp"

namespace gcs {

/// The parameters on the way: A(s) = Σ coefficients[k]·s^k, k ≤ 3; `end` is A(1) without the rounding of that
/// sum. With rates, coefficients[0]·e^(rate·(s − 1)), and the other coefficients of what has a rate are 0.
struct Route {
  static constexpr int degree = 3;
  std::array<ComplexVectorX, degree + 1> coefficients;
  ComplexVectorX end;
  std::vector<double> rates{};  ///< one per parameter, or none
};

/// On its way, for 0 ≤ s ≤ 1.
ComplexVectorX parameters_at(const Route& route, double s);

struct TrackingOptions {
  static constexpr int highest_order = 40;

  int order = 12;           ///< of the Taylor predictor, from 4 to highest_order
  double tolerance = 1e-6;  ///< of a prediction, relative to how far the path goes until its series diverges
  int most_steps = 2000;    ///< of a path, rejected ones included
  int most_rejected = 24;   ///< in a row, or of twice as many: precision is missing
};

enum class LegEnd {
  arrived,
  short_steps,  ///< than the leg wants, or most are rejected: it is given up
  too_small,    ///< to count, or most are rejected for a leg that wants none so short: precision is missing
  too_many      ///< TrackingOptions::most_steps did not suffice
};

/// A path to be followed: its start and the parameters on its way. Both are referred to, not copied.
struct Leg {
  const std::complex<double>* start = nullptr;  ///< `unknowns` numbers
  const Route* route = nullptr;
  double shortest_step = 0;  ///< the leg is given up where it would take a shorter one; 0: never
  double from = 0;           ///< s at its start; on the way this is as near to the path as a step must end
};

/// Where a path was left and what it took.
struct LegState {
  LegEnd end = LegEnd::too_many;
  double s = 0;
  int steps = 0;
  int rejected = 0;
  /// Of Newton's method, the largest component's, relative to 1 + the largest |x_i|.
  double last_correction = 0;

  /// The next correction would be rounding: about the square of the last one.
  bool is_settled() const { return last_correction <= 1e-10; }
};

class LaneTracker {
 public:
  virtual ~LaneTracker() = default;
  virtual int lanes() const = 0;
  virtual void load(int lane, const Leg& leg) = 0;
  /// One step of every lane that holds a path.
  virtual void step() = 0;
  virtual bool is_busy(int lane) const = 0;
  /// Of the path that the lane held last. Precondition: it is no longer busy.
  virtual LegState state(int lane) const = 0;
  virtual void read(int lane, std::complex<double>* x) const = 0;
};

}  // namespace gcs
