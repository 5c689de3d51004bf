#pragma once
/// Proven solutions in exact dyadic numbers, for checkers that somebody else has written.

#include <complex>
#include <optional>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/certificates/decimal_figure.hpp"

namespace gcs {

/// Whole numbers times 2^exponent. Exactly one solution, and a regular one, has every unknown within radius·2^exponent of
/// them; so small a box leaves Newton's method, in exact arithmetic and with an inverse in doubles, room enough to show it
/// again. Lengths are in the scene's unit, and the exponent is at most 0.
struct DyadicBox {
  static constexpr int radius = 8;

  std::vector<DecimalNumber> numbers;
  int exponent = 0;
};

/// The zero of `inner` next to x. `outer` has the same unknowns, then others, and a zero where these are 0: it is the one of
/// `outer` in the box that has 0 ± radius·2^exponent for them, and a regular one. Nothing where no precision up to 1024 bits
/// proves them so well.
std::optional<DyadicBox> dyadic_box(const Certifier& inner, const Certifier& outer,
                                    const std::vector<std::complex<double>>& x);

/// The solutions next to figures in the scene's unit and frame, on so many threads; the same for any number of them. Real
/// solutions are in real numbers, and a box of any other holds no real one. Listed are, as far as frame and positions leave
/// them open, the coordinates of points, of lines the point nearest to the origin and the direction, of planes normal and
/// offset; and of distances between a point and a line that both have unknowns (p − f)·u. Nothing for one that no precision
/// up to 1024 bits proves so well. Precondition: !why_not_certified(scene).
std::vector<std::optional<DyadicBox>> dyadic_figures(const SceneEquations& equations, const Scene& scene,
                                                     const std::vector<Figure>& near, int threads);

}  // namespace gcs
