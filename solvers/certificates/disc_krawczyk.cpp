#include "solvers/certificates/disc_krawczyk.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

Eigen::VectorXd constant(Eigen::Index size, double value) { return Eigen::VectorXd::Constant(size, value); }

template <typename Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <typename Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// `image`: of a box around x that lies in the one of that radius, where there is one solution.
template <typename Scalar>
Enclosure enclosure_of(const Vector<Scalar>& x, const KrawczykImage<Scalar>& image, double radius) {
  Enclosure enclosure;
  enclosure.unique = radius;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Scalar mid = x[i] - image.move[i];
    const double rounding = 2 * epsilon * std::abs(mid);
    const double spread = (image.spread[i] + rounding) * (1 + 4 * epsilon);
    enclosure.mid.push_back(mid);
    enclosure.radius.emplace_back(spread, std::is_same_v<Scalar, double> ? 0 : spread);
    // The box around x in which there is no other solution holds this one around mid.
    const double moved = std::abs(image.move[i]) * (1 + 4 * epsilon) + rounding;
    enclosure.unique = std::min(enclosure.unique, (radius - moved) * (1 - 2 * epsilon));
  }
  return enclosure;
}

/// The solution next to x, if there is one by the test.
template <typename System, typename Scalar>
std::optional<Enclosure> proven(const System& system, const Vector<Scalar>& x) {
  const LinearisedSystem<Scalar> f = linearised(system, x);
  const Matrix<Scalar> inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  const KrawczykOperator<Scalar> krawczyk(inverse, f);
  const auto moves_in = [&](const Eigen::VectorXd& box) { return jacobian_radius(system, x, box); };
  const auto image_of = [&](const Eigen::VectorXd& box) { return krawczyk.image(moves_in(box), box); };
  // In a box of this radius the Jacobian moves by half of what the test could bear.
  const Eigen::VectorXd moves = moves_in(constant(x.size(), 1)) * constant(x.size(), 1);
  const double radius = 1 / (2 * krawczyk.sizes_times(moves).maxCoeff());
  KrawczykImage<Scalar> image = image_of(constant(x.size(), radius));
  if (!(image.reach().array() < radius).all()) return std::nullopt;
  // The box shrinks about as fast as its square, down to what rounding leaves.
  while (true) {
    KrawczykImage<Scalar> smaller = image_of(image.reach());
    const bool is_done = !(smaller.spread.maxCoeff() < image.spread.maxCoeff() / 2);
    image = std::move(smaller);
    if (is_done) break;
  }
  return enclosure_of(x, image, radius);
}

/// Whether linearised(IntervalEquations) knows it.
bool has_short_real_forms(const QuadraticSystem& system) {
  constexpr std::size_t most = 100;
  const auto is_short_and_real = [](const LinearForm& form) {
    return form.terms.size() <= most && form.constant.value.imag() == 0 &&
           std::all_of(form.terms.begin(), form.terms.end(),
                       [](const ScaledUnknown& term) { return term.coefficient.value.imag() == 0; });
  };
  return std::all_of(
      system.equations.begin(), system.equations.end(), [&](const QuadraticEquation& equation) {
        return equation.products.size() <= most &&
               std::all_of(equation.products.begin(), equation.products.end(),
                           [&](const FormProduct& product) {
                             return is_short_and_real(product.left) && is_short_and_real(product.right);
                           });
      });
}

}  // namespace

std::optional<DiscKrawczyk> DiscKrawczyk::of(const QuadraticSystem& system) {
  if (auto differences = SquaredDifferences::of(system)) return DiscKrawczyk(std::move(*differences));
  if (has_short_real_forms(system)) return DiscKrawczyk(IntervalEquations(system));
  return std::nullopt;
}

std::optional<Enclosure> DiscKrawczyk::prove(const std::vector<std::complex<double>>& x, bool is_real) const {
  const Eigen::Map<const Eigen::VectorXcd> point(x.data(), static_cast<Eigen::Index>(x.size()));
  return std::visit(
      [&](const auto& system) {
        return is_real ? proven<std::decay_t<decltype(system)>, double>(system, point.real())
                       : proven<std::decay_t<decltype(system)>, std::complex<double>>(system, point);
      },
      system_);
}

}  // namespace gcs
