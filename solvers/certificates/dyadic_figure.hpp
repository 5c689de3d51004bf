#pragma once
/// Proven solutions in exact dyadic numbers, for checkers that somebody else has written.

#include <complex>
#include <optional>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/certificates/decimal_figure.hpp"

namespace gcs {

/// Coordinates are whole numbers times 2^exponent, in the file's unit of length. Exactly one solution, and a regular
/// one, has every unknown coordinate within radius·2^exponent of them; so small a box leaves Newton's method, in exact
/// arithmetic and with an inverse in doubles, room enough to show it again. Real solutions are in real numbers, and
/// a box of any other holds no real one.
struct DyadicFigure {
  static constexpr int radius = 8;

  std::vector<DecimalVector> points;  ///< the whole numbers
  int exponent = 0;
};

/// Likewise all unknowns of a system.
struct DyadicBox {
  std::vector<DecimalNumber> numbers;
  int exponent = 0;
};

/// The zero of `inner` next to x. `outer` has the same unknowns, then others, and a zero where these are 0: it is the one of
/// `outer` in the box that has 0 ± radius·2^exponent for them, and a regular one. Nothing where no precision up to 1024 bits
/// proves them so well.
std::optional<DyadicBox> dyadic_box(const Certifier& inner, const Certifier& outer,
                                    const std::vector<std::complex<double>>& x);

/// The solutions next to figures in the scene's unit and frame, on so many threads; the same for any number of them. Nothing
/// for one that no precision up to 1024 bits proves so well. Precondition: the scene is of points, none with a given
/// position, and distances between them.
std::vector<std::optional<DyadicFigure>> dyadic_figures(const SceneEquations& equations, const Scene& scene,
                                                        const std::vector<Figure>& near, int threads);

}  // namespace gcs
