#include "solvers/certificates/dyadic_figure.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>

#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// Exactly one solution is within `spread` of the middle in every unknown, and no other within `unique`.
struct Place {
  BallMatrix middle;
  double spread = 0;
  double unique = 0;
  int bits = bits_of_doubles;
};

Place place_of(const Enclosure& enclosure) {
  Place place{BallKrawczyk::vector(enclosure.mid), 0, enclosure.unique};
  for (const std::complex<double>& radius : enclosure.radius)
    place.spread = std::max(place.spread, std::hypot(radius.real(), radius.imag()));
  place.spread *= 1 + 4 * std::numeric_limits<double>::epsilon();
  return place;
}

Place place_of(const BallKrawczyk::Proof& proof, slong bits) {
  Place place{proof.solution, 0, proof.unique, static_cast<int>(bits)};
  acb_mat_get_mid(place.middle.get(), place.middle.get());
  BallMatrix rest(proof.solution.rows(), 1);
  acb_mat_sub(rest.get(), proof.solution.get(), place.middle.get(), bits);
  for (slong i = 0; i < rest.rows(); ++i) place.spread = std::max(place.spread, magnitude(rest(i, 0)));
  return place;
}

/// In units of 2^exponent, rounded towards 0.
std::string whole_number(const arb_t number, int exponent) {
  fmpz_t whole;
  fmpz_init(whole);
  arf_get_fmpz_fixed_si(whole, arb_midref(number), exponent);
  char* digits = fmpz_get_str(nullptr, 10, whole);
  std::string text = digits;
  flint_free(digits);
  fmpz_clear(whole);
  return text;
}

/// The exponent of a unit in which place and rounding are off by less than 4, half the radius; `size`: of the unknowns.
/// Nothing where the box would be too large: Newton's method contracts balls of about the size of `unique`.
std::optional<int> exponent_for(const Place& place, double size) {
  const int exponent = std::ilogb(std::max(place.spread, std::ldexp(size, -place.bits)));
  if (place.unique < std::ldexp(4 * DyadicFigure::radius, exponent)) return std::nullopt;
  return exponent;
}

DecimalNumber whole_numbers(acb_srcptr value, int exponent) {
  return {whole_number(acb_realref(value), exponent), whole_number(acb_imagref(value), exponent)};
}

std::optional<DyadicBox> box_of(const Place& place, double unique_of_outer) {
  Place both = place;
  both.unique = std::min(place.unique, unique_of_outer);
  const std::optional<int> exponent = exponent_for(both, 1);
  if (!exponent) return std::nullopt;
  DyadicBox box{{}, *exponent};
  for (slong i = 0; i < place.middle.rows(); ++i)
    box.numbers.push_back(whole_numbers(place.middle(i, 0), *exponent));
  return box;
}

bool is_real_within(const BallMatrix& middle, double reach) {
  for (slong i = 0; i < middle.rows(); ++i)
    if (std::abs(rounded_midpoint(middle(i, 0)).imag()) > reach) return false;
  return true;
}

class DyadicWriter {
 public:
  DyadicWriter(const SceneEquations& equations, const Scene& scene)
      : equations_(equations), scene_(scene), certifier_(equations.system()) {}

  std::optional<DyadicFigure> figure(const Figure& near) const {
    const ComplexValues x = equations_.coordinates(near);
    if (const Certificate certificate = certifier_.certify(x); certificate.is_proven)
      if (auto result = figure(place_of(certificate.enclosure), near.is_real())) return result;
    for (const slong bits : ball_precisions)
      if (const auto proof = certifier_.prove(x, bits))
        if (auto result = figure(place_of(*proof, bits), near.is_real())) return result;
    return std::nullopt;
  }

 private:
  std::optional<DyadicFigure> figure(const Place& place, bool is_real) const {
    const std::optional<int> exponent = exponent_for(place, scene_.size());
    if (!exponent ||
        (!is_real && is_real_within(place.middle, std::ldexp(2 * DyadicFigure::radius, *exponent))))
      return std::nullopt;
    DyadicFigure figure{{}, *exponent + scene_.unit_exponent()};
    for (int point = 0; point < scene_.point_count(); ++point) {
      DecimalVector& numbers = figure.points.emplace_back();
      for (int axis = 0; axis < scene_.dimension(); ++axis) {
        const int unknown = equations_.point_unknown(point, axis);
        if (unknown < 0) continue;
        numbers[static_cast<std::size_t>(axis)] = whole_numbers(place.middle(unknown, 0), *exponent);
      }
    }
    return figure;
  }

  const SceneEquations& equations_;
  const Scene& scene_;
  Certifier certifier_;
};

}  // namespace

std::optional<DyadicBox> dyadic_box(const Certifier& inner, const Certifier& outer,
                                    const std::vector<std::complex<double>>& x) {
  std::vector<std::complex<double>> with_zeros = x;
  with_zeros.resize(static_cast<std::size_t>(outer.system().unknowns));
  const Certificate at = inner.certify(x), around = outer.certify(with_zeros);
  if (at.is_proven && around.is_proven)
    if (auto box = box_of(place_of(at.enclosure), around.enclosure.unique)) return box;
  for (const slong bits : ball_precisions) {
    const auto inner_proof = inner.prove(x, bits), outer_proof = outer.prove(with_zeros, bits);
    if (!inner_proof || !outer_proof) continue;
    if (auto box = box_of(place_of(*inner_proof, bits), outer_proof->unique)) return box;
  }
  return std::nullopt;
}

std::vector<std::optional<DyadicFigure>> dyadic_figures(const SceneEquations& equations, const Scene& scene,
                                                        const std::vector<Figure>& near, int threads) {
  const DyadicWriter writer(equations, scene);
  std::vector<std::optional<DyadicFigure>> figures(near.size());
  share_on_threads(near.size(), threads, [&](std::size_t i) { figures[i] = writer.figure(near[i]); });
  return figures;
}

}  // namespace gcs
