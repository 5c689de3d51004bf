#include "solvers/certificates/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/certificates/ball_cluster.hpp"
#include "solvers/certificates/multiple_solution.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Newton's method that still moves, but by less than this of the solution's size, is closing in on a
/// solution as slowly as it does on multiple ones: by a bit a step.
constexpr double slow_convergence = 1e-6;

using Point = std::vector<std::complex<double>>;

bool is_real(const Point& x) {
  return std::all_of(x.begin(), x.end(), [](const auto& value) { return value.imag() == 0; });
}

bool has_real_coefficients(const LinearForm& form) {
  return form.constant.value.imag() == 0 &&
         std::all_of(form.terms.begin(), form.terms.end(),
                     [](const ScaledUnknown& term) { return term.coefficient.value.imag() == 0; });
}

bool has_real_coefficients(const QuadraticSystem& system) {
  for (const QuadraticEquation& equation : system.equations) {
    if (equation.given.value.imag() != 0) return false;
    for (const FormProduct& product : equation.products)
      if (!has_real_coefficients(product.left) || !has_real_coefficients(product.right)) return false;
  }
  return true;
}

std::string cause_of(const BallKrawczyk::Newton& newton) {
  if (newton.converged) return "it is so nearly singular that no surroundings are proven to hold it alone";
  if (newton.is_singular || newton.correction < slow_convergence)
    return "it is singular: a multiple solution, or several that " + std::to_string(ball_precisions.back()) +
           " bits do not tell apart";
  return "Newton's method from it leads to no solution";
}

}  // namespace

// The conjugate of a solution is a solution too: the same one where it lies in the box that holds no other.
Certificate::Realness realness(const Enclosure& enclosure) {
  using Realness = Certificate::Realness;
  bool is_own_conjugate = true, is_in_reals = true;
  for (std::size_t i = 0; i < enclosure.mid.size(); ++i) {
    const double height = std::abs(enclosure.mid[i].imag()), radius = enclosure.radius[i].imag();
    if (height > radius) return Realness::not_real;
    const double reach = 2 * height + std::abs(enclosure.radius[i]) * (1 + 4 * epsilon);
    is_own_conjugate = is_own_conjugate && reach < enclosure.unique * (1 - 4 * epsilon);
    is_in_reals = is_in_reals && height == 0 && radius == 0;
  }
  return is_own_conjugate || is_in_reals ? Realness::real : Realness::undecided;
}

double Certificate::offset(std::size_t i, std::complex<double> x_i) const {
  const std::complex<double> mid = enclosure.mid[i];
  return (std::abs(x_i - mid) + std::abs(enclosure.radius[i])) * (1 + 8 * epsilon);
}

Certifier::Certifier(QuadraticSystem system)
    : system_(std::move(system)),
      is_real_(has_real_coefficients(system_)),
      discs_(DiscKrawczyk::of(system_)),
      levels_(std::make_unique<Level[]>(ball_precisions.size())) {}

const BallKrawczyk& Certifier::level(std::size_t number) const {
  Level& level = levels_[number];
  std::call_once(level.is_made, [&] { level.balls.emplace(system_, ball_precisions[number]); });
  return *level.balls;
}

Certificate Certifier::certify(const Point& x, int least_bits) const {
  Certificate certificate;
  const auto is_settled = [&] {
    return certificate.is_proven && (!is_real_ || certificate.realness != Certificate::Realness::undecided);
  };
  const auto take = [&](Enclosure enclosure, int bits) {
    certificate.is_proven = true;
    certificate.bits = bits;
    certificate.enclosure = std::move(enclosure);
    certificate.cause.clear();
    if (is_real_) certificate.realness = realness(certificate.enclosure);
  };
  if (discs_ && least_bits <= bits_of_doubles)
    if (auto enclosure = discs_->prove(x, is_real_ && is_real(x)))
      take(std::move(*enclosure), bits_of_doubles);
  BallMatrix start = BallKrawczyk::vector(x);
  for (std::size_t i = 0; i < ball_precisions.size() && !is_settled(); ++i) {
    if (ball_precisions[i] < least_bits) continue;
    const BallKrawczyk& balls = level(i);
    const BallKrawczyk::Newton newton = balls.refined(start);
    const auto proof = newton.converged ? balls.prove(newton.x) : std::nullopt;
    if (proof)
      take(enclosure_of(*proof), static_cast<int>(balls.bits()));
    else if (!certificate.is_proven)
      certificate.cause = cause_of(newton);
    if (newton.converged) start = newton.x;
  }
  if (!certificate.is_proven) find_cluster(x, certificate);
  return certificate;
}

/// Its radius is no smaller than the error of x, which is a double: the lowest precision will do.
void Certifier::find_cluster(const Point& x, Certificate& certificate) const {
  const auto cluster = prove_cluster(level(0), x);
  if (!cluster) return;
  certificate.cluster = cluster->solutions;
  certificate.bits = static_cast<int>(ball_precisions.front());
  certificate.enclosure.mid = x;
  for (const double radius : cluster->radius) certificate.enclosure.radius.emplace_back(radius, radius);
  // Of one solution the enclosure holds that, whichever polydisc proves how often it counts.
  const auto fractions = simplest_fractions(x, cluster->radius);
  certificate.is_multiple =
      fractions && least_multiplicity(system_, *fractions, cluster->solutions) == cluster->solutions &&
      solutions_about(level(0), enclosed(*fractions, level(0).bits()), std::vector<double>(x.size(), 0.0)) ==
          cluster->solutions;
  if (certificate.is_multiple) certificate.realness = Certificate::Realness::real;
  certificate.cause = "it is singular or nearly so, a cluster of " + std::to_string(cluster->solutions) +
                      " solutions, counted with multiplicities";
}

std::optional<BallKrawczyk::Proof> Certifier::prove(const Point& x, slong bits) const {
  const BallKrawczyk level(system_, bits);
  const BallKrawczyk::Newton newton = level.refined(BallKrawczyk::vector(x));
  return newton.converged ? level.prove(newton.x) : std::nullopt;
}

}  // namespace gcs
