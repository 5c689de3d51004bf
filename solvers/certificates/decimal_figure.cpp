#include "solvers/certificates/decimal_figure.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <cmath>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// The decimals of a proof's balls, and how far they are off.
class Decimals {
 public:
  Decimals(const BallKrawczyk::Proof& proof, const Scene& scene, int digits, slong bits)
      : proof_(proof), exponent_(scene.unit_exponent()), digits_(digits), bits_(bits) {}

  /// An unknown that is a length, in the file's unit, or one without a unit.
  DecimalNumber unknown(int number, bool is_length) {
    Ball ball;
    acb_mul_2exp_si(ball, proof_.solution(number, 0), is_length ? exponent_ : 0);
    return decimal(ball);
  }

  DecimalNumber given(const ExactNumber& number) {
    Ball ball;
    enclose(ball, number, bits_);
    acb_mul_2exp_si(ball, ball, exponent_);
    return decimal(ball);
  }

  /// A form in the unknowns that is a length, or one without a unit.
  DecimalNumber form(const LinearForm& form, bool is_length) {
    Ball sum, coefficient;
    enclose(sum, form.constant, bits_);
    for (const ScaledUnknown& term : form.terms) {
      enclose(coefficient, term.coefficient, bits_);
      acb_addmul(sum, coefficient, proof_.solution(term.unknown, 0), bits_);
    }
    acb_mul_2exp_si(sum, sum, is_length ? exponent_ : 0);
    return decimal(sum);
  }

  DecimalVector vector(const VectorForm& forms, bool is_length) {
    return {form(forms[0], is_length), form(forms[1], is_length), form(forms[2], is_length)};
  }

  double error() const { return error_; }

 private:
  DecimalNumber decimal(const Ball& ball) {
    const acb_srcptr number = ball;
    return {part(acb_realref(number)), part(acb_imagref(number))};
  }

  std::string part(arb_srcptr ball) {
    std::string text = "0";
    arb_t rounded;
    arb_init(rounded);
    if (!arb_contains_zero(ball)) {
      arb_get_mid_arb(rounded, ball);
      char* digits = arb_get_str(rounded, digits_, ARB_STR_NO_RADIUS);
      text = digits;
      flint_free(digits);
      arb_set_str(rounded, text.c_str(), bits_);
    }
    arb_sub(rounded, rounded, ball, bits_);
    Ball difference;
    acb_set_arb(difference, rounded);
    error_ = std::max(error_, magnitude(difference));
    arb_clear(rounded);
    return text;
  }

  const BallKrawczyk::Proof& proof_;
  int exponent_;
  int digits_;
  slong bits_;
  double error_ = 0;
};

/// Its sign as that of the direction of a line in doubles.
VectorForm directed(const VectorForm& form, const Eigen::Vector3cd& direction, const ComplexValues& x) {
  const Eigen::Vector3cd here = vector_at(form, x);
  return (here - direction).norm() <= (here + direction).norm() ? form : negated(form);
}

DecimalFigure general_decimals(Decimals& decimals, const SystemBuilder& forms, const Figure& near,
                               const ComplexValues& x) {
  const ProblemStatement& problem = forms.problem();
  const auto lines = static_cast<int>(problem.points.size());
  const auto planes = lines + static_cast<int>(problem.lines.size());
  const std::vector<ComplexLine> near_lines = complex_lines(near);
  DecimalFigure figure;
  for (int entity = 0; entity < lines; ++entity)
    figure.points.push_back(decimals.vector(forms.point(entity), true));
  for (int entity = lines; entity < planes; ++entity) {
    const LineForms& line = forms.line(entity);
    const Eigen::Vector3cd& direction = near_lines[static_cast<std::size_t>(entity - lines)].direction;
    figure.lines.push_back(
        {decimals.vector(line.foot, true), decimals.vector(directed(line.direction, direction, x), false)});
  }
  for (int entity = planes; entity < problem.entity_count(); ++entity) {
    const PlaneForms& plane = forms.plane(entity);
    figure.planes.push_back({decimals.vector(plane.normal, false), decimals.form(plane.offset, true)});
  }
  return figure;
}

DecimalFigure distance_decimals(Decimals& decimals, const SceneEquations& equations, const Scene& scene) {
  DecimalFigure figure;
  for (int point = 0; point < scene.point_count(); ++point) {
    DecimalVector& place = figure.points.emplace_back();
    for (int axis = 0; axis < scene.dimension(); ++axis) {
      const int unknown = equations.point_unknown(point, axis);
      place[static_cast<std::size_t>(axis)] = unknown >= 0
                                                  ? decimals.unknown(unknown, true)
                                                  : decimals.given(given_coordinate(scene, point, axis));
    }
  }
  for (int line = 0; line < static_cast<int>(scene.problem().lines.size()); ++line) {
    DecimalFigure::Line& place = figure.lines.emplace_back();
    place.direction[0].re = "1";
    for (int axis = 0; axis < 3 && equations.line_unknown(line, 0, 0) >= 0; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      place.point[i] = decimals.unknown(equations.line_unknown(line, 0, axis), true);
      place.direction[i] = decimals.unknown(equations.line_unknown(line, 1, axis), false);
    }
  }
  return figure;
}

DecimalFigure decimals_of(const BallKrawczyk::Proof& proof, const SceneEquations& equations,
                          const Scene& scene, const Figure& near, int digits, slong bits) {
  Decimals decimals(proof, scene, digits, bits);
  const SceneSystem* general = equations.general();
  DecimalFigure figure =
      general ? general_decimals(decimals, general->elements(), near, general->coordinates(near))
              : distance_decimals(decimals, equations, scene);
  figure.error = decimals.error();
  figure.unique = proof.unique;
  figure.bits = static_cast<int>(bits);
  return figure;
}

}  // namespace

std::optional<DecimalFigure> decimal_figure(const SceneEquations& equations, const Scene& scene,
                                            const Figure& near, int digits) {
  const Certifier certifier(equations.system());
  const double wanted = std::pow(10.0, 1 - digits) * std::ldexp(scene.size(), scene.unit_exponent());
  for (slong bits = 8L * digits; bits <= 32L * digits; bits *= 2) {
    const auto proof = certifier.prove(equations.coordinates(near), bits);
    if (!proof) continue;
    DecimalFigure figure = decimals_of(*proof, equations, scene, near, digits, bits);
    // Of coordinates far beyond the scene's size the last digit is larger.
    const double reach = std::max(1.0, extent(near) / scene.size());
    if (figure.error <= wanted * reach) return figure;
  }
  return std::nullopt;
}

std::vector<std::optional<DecimalFigure>> decimal_figures(const SceneEquations& equations, const Scene& scene,
                                                          const std::vector<Figure>& near, int digits,
                                                          int threads, const std::stop_token& stop) {
  std::vector<std::optional<DecimalFigure>> figures(near.size());
  share_on_threads(near.size(), threads, [&](std::size_t i) {
    const ThreadReserves reserves;
    if (!stop.stop_requested()) figures[i] = decimal_figure(equations, scene, near[i], digits);
  });
  return figures;
}

}  // namespace gcs
