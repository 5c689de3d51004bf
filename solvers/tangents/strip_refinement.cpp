#include "solvers/tangents/strip_refinement.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

using Complex = std::complex<double>;
using LineVector = Eigen::Matrix<Complex, 6, 1>;
using LineMatrix = Eigen::Matrix<Complex, 6, 6>;

/// The unknowns: direction with u·u = 1 and point with p·u = 0, from the first centre.
struct WideLine {
  WideVector u;
  WideVector p;

  void subtract(const LineVector& change) {
    for (int i = 0; i < 3; ++i) {
      u[i] = u[i] - widened(change[i]);
      p[i] = p[i] - widened(change[3 + i]);
    }
  }
};

/// The spheres after a rotation.
struct TurnedSpheres {
  std::array<WideVector, 3> centers;
  std::array<ComplexDoubleDouble, 3> constants;  ///< c·c + r_1² − r²
  DoubleDouble first_square;

  TurnedSpheres(const FourSpheres& spheres, const Strip& strip, double b) : first_square(spheres[0].square) {
    for (std::size_t i = 0; i < 3; ++i) {
      centers[i] = turned_by(b, strip.centers()[i]);
      constants[i] = isotropic_product(centers[i], centers[i]) - (spheres[i + 1].square - first_square);
    }
  }
};

/// Of c·p − (c·c + r_1² − r²)/2 + (c·u)²/2, u·p, (p·p − r_1²)/2 and (u·u − 1)/2.
LineVector residual(const TurnedSpheres& spheres, const WideLine& line) {
  const ComplexDoubleDouble half = widened(Complex(0.5));
  LineVector result;
  for (std::size_t i = 0; i < 3; ++i) {
    const ComplexDoubleDouble along = isotropic_product(spheres.centers[i], line.u);
    result[static_cast<Eigen::Index>(i)] =
        (isotropic_product(spheres.centers[i], line.p) + half * (along * along - spheres.constants[i]))
            .value();
  }
  result[3] = isotropic_product(line.u, line.p).value();
  result[4] = (isotropic_product(line.p, line.p) - spheres.first_square).value() / 2.0;
  result[5] = (isotropic_product(line.u, line.u) - DoubleDouble{1, 0}).value() / 2.0;
  return result;
}

/// Columns: u, p.
LineMatrix jacobian(const TurnedSpheres& spheres, const WideLine& line) {
  const Eigen::Vector3cd u = narrowed(line.u), p = narrowed(line.p);
  const Eigen::RowVector3cd of_u = isotropic_dual(u), of_p = isotropic_dual(p);
  LineMatrix result = LineMatrix::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3cd c = narrowed(spheres.centers[static_cast<std::size_t>(i)]);
    const Eigen::RowVector3cd of_c = isotropic_dual(c);
    result.row(i) << isotropic_product(c, u) * of_c, of_c;
  }
  result.row(3) << of_p, of_u;
  result.row(4).tail<3>() = of_p;
  result.row(5).head<3>() = of_u;
  return result;
}

/// Whether it converges, quadratically but for the rounding of the linear solves.
bool refine(const TurnedSpheres& spheres, WideLine& line, WorkCounters& work) {
  constexpr int most_iterations = 10;
  // Relative to the line's coordinates. The rounding of doubles is far above it, and that of double-double
  // times the condition of a simple line below.
  constexpr double settled = 1e-22;
  for (int i = 0; i < most_iterations; ++i) {
    const LineVector change =
        Eigen::PartialPivLU<Eigen::MatrixXcd>(jacobian(spheres, line)).solve(residual(spheres, line));
    line.subtract(change);
    ++work.newton_iterations;
    const double size_u = narrowed(line.u).norm(), size_p = 1 + narrowed(line.p).norm();
    if (change.head<3>().norm() <= settled * size_u && change.tail<3>().norm() <= settled * size_p)
      return true;
  }
  return false;
}

/// The product of the direction with the point nearest to the first centre is 0: computed from large coordinates it is not.
ComplexTangent in_spheres_coordinates(const Strip& strip, const WideLine& line) {
  const WideVector u = strip.cartesian(line.u), origin = strip.wide_origin();
  WideVector p = strip.cartesian(line.p);
  const ComplexDoubleDouble along = bilinear_product(u, origin);
  for (std::size_t i = 0; i < 3; ++i) p[i] = p[i] + origin[i] - along * u[i];
  return {narrowed(p), narrowed(u)};
}

}  // namespace

std::optional<RefinedTangent> refined_in_strip(const FourSpheres& spheres, const Strip& strip,
                                               const ScaledLine& line, WorkCounters& work) {
  const double b = line.balancing_rotation(strip.largest_rotation());
  const ScaledLine turned = line.turned(b);
  const Complex uu = isotropic_product(turned.direction, turned.direction);
  WideLine wide{widened(Eigen::Vector3cd(turned.direction / std::sqrt(uu))),
                widened(Eigen::Vector3cd(turned.scaled_point / uu))};
  if (!refine(TurnedSpheres(spheres, strip, b), wide, work)) return std::nullopt;
  const WideLine back{turned_by(1 / b, wide.u), turned_by(1 / b, wide.p)};
  return RefinedTangent{in_spheres_coordinates(strip, back), {narrowed(back.u), narrowed(back.p)}};
}

void TangentsInStrip::take(const RefinedTangent& tangent) {
  const auto is_same = [&](const ScaledLine& other) {
    return difference(tangent.in_strip, other, strip_.largest_rotation()) <= same_line;
  };
  if (std::ranges::any_of(known_, is_same)) return;
  known_.push_back(tangent.in_strip);
  known_.push_back(tangent.in_strip.conjugate());
  found.add_simple(tangent.line);
}

}  // namespace gcs
