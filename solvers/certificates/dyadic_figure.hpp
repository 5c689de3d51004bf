#pragma once
/// Proven solutions in exact dyadic numbers, for checkers that somebody else has written.

#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/certificates/decimal_figure.hpp"

namespace gcs {

/// Whole numbers times 2^exponent. Exactly one solution, and a regular one, has every unknown within reach() of
/// them; so small a box leaves Newton's method, in exact arithmetic and with an inverse in doubles, room enough to show it
/// again, and numbers that are off by some units leave room for others that are computed from them. Lengths are in the
/// scene's unit, and the exponent is at most 0.
struct DyadicBox {
  static constexpr int radius = 1024;

  std::vector<DecimalNumber> numbers;
  int exponent = 0;
  int widening = 0;   ///< the radius is 2^widening times as large
  int solutions = 1;  ///< more: a cluster of so many, counted with multiplicities, in the place of the one
  /// The cluster is one solution: real, and that with the least denominators within radius·2^exponent.
  bool is_multiple = false;

  double reach() const { return std::ldexp(radius, exponent + widening); }
};

/// The zero of `inner` next to x. `outer` has the same unknowns, then others, and a zero where these are 0: it is the one of
/// `outer` in the box that has 0 ± radius·2^exponent for them, and a regular one. Nothing where no precision up to 1024 bits
/// proves them so well.
std::optional<DyadicBox> dyadic_box(const Certifier& inner, const Certifier& outer,
                                    const std::vector<std::complex<double>>& x);

/// The solutions next to figures in the scene's unit and frame, on so many threads; the same for any number of them. Real
/// solutions are in real numbers, and a box of any other holds no real one. Listed are, of each element that does not rest in
/// the frame, coordinates of a point, of a line a point of it, which is that nearest to the origin unless a body has the line,
/// and the direction, of a plane normal and offset. Nothing for one that no precision up to 1024 bits proves so well.
/// Of a cluster that several figures are in the first one has it. Precondition: !why_not_certified(scene).
std::vector<std::optional<DyadicBox>> dyadic_figures(const SceneEquations& equations, const Scene& scene,
                                                     const std::vector<Figure>& near, int threads);

}  // namespace gcs
