#pragma once
/// Proven solutions in decimals, with as many digits as are asked for.

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "solvers/certificates/scene_equations.hpp"

namespace gcs {

/// A complex number in decimals; `im` is "0" in a real solution.
struct DecimalNumber {
  std::string re = "0";
  std::string im = "0";
};
using DecimalVector = std::array<DecimalNumber, 3>;

struct DecimalFigure {
  struct Line {
    DecimalVector point;
    DecimalVector direction;
  };
  struct Plane {
    DecimalVector normal;
    DecimalNumber offset;
  };
  std::vector<DecimalVector> points;  ///< in the file's unit of length
  std::vector<Line> lines;
  std::vector<Plane> planes{};
  double error = 0;   ///< at least the error of every real and imaginary part
  double unique = 0;  ///< no other solution has all unknowns within this, in the scene's unit
  int bits = 0;       ///< of the balls in which it is proven
};

/// The solution next to a figure in the scene's unit and frame, each number rounded to `digits` significant
/// ones; nothing where no precision up to 32 bits for each digit proves it so well.
std::optional<DecimalFigure> decimal_figure(const SceneEquations& equations, const Scene& scene,
                                            const Figure& near, int digits);

/// So many significant digits of a figure's numbers that rounding to them moves no given distance by more than a double's
/// rounding of it would; where constraints are of other kinds, no distance of the scene's size. Precondition: the figure is
/// finite.
int digits_that_hold(const Scene& scene, const Figure& figure);

/// One for each figure, on so many threads; the same for any number of them. After a request to stop nothing
/// for those that are left.
std::vector<std::optional<DecimalFigure>> decimal_figures(const SceneEquations& equations, const Scene& scene,
                                                          const std::vector<Figure>& near, int digits,
                                                          int threads, const std::stop_token& stop = {});

}  // namespace gcs
