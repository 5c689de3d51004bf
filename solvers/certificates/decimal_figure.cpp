#include "solvers/certificates/decimal_figure.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <cmath>

#include "solvers/certificates/enclosed_point.hpp"
#include "solvers/certificates/file_frame.hpp"
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
  void enclose_form(acb_ptr sum, const LinearForm& form, bool is_length) const {
    enclose(sum, form, proof_.solution, bits_);
    acb_mul_2exp_si(sum, sum, is_length ? exponent_ : 0);
  }
  BallMatrix vector(const VectorForm& forms, bool is_length) const {
    BallMatrix result(3, 1);
    for (slong axis = 0; axis < 3; ++axis)
      enclose_form(result(axis, 0), forms[static_cast<std::size_t>(axis)], is_length);
    return result;
  }

  DecimalNumber decimal(acb_srcptr number) { return {part(acb_realref(number)), part(acb_imagref(number))}; }
  DecimalVector decimal(const BallMatrix& vector) {
    return {decimal(vector(0, 0)), decimal(vector(1, 0)), decimal(vector(2, 0))};
  }

  double error() const { return error_; }

 private:
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
void direct(BallMatrix& vector, const Eigen::Vector3cd& direction) {
  Eigen::Vector3cd here;
  for (slong axis = 0; axis < 3; ++axis) here[axis] = rounded_midpoint(vector(axis, 0));
  if ((here - direction).norm() > (here + direction).norm()) acb_mat_neg(vector.get(), vector.get());
}

/// `near`: in the file's frame.
DecimalFigure general_decimals(Decimals& decimals, const SystemBuilder& forms, const FileFrame& frame,
                               const Figure& near) {
  const ProblemStatement& problem = forms.problem();
  const auto lines = static_cast<int>(problem.points.size());
  const auto planes = lines + static_cast<int>(problem.lines.size());
  const std::vector<ComplexLine> near_lines = complex_lines(near);
  DecimalFigure figure;
  for (int entity = 0; entity < lines; ++entity) {
    BallMatrix point = decimals.vector(forms.point(entity), true);
    frame.place(point);
    figure.points.push_back(decimals.decimal(point));
  }
  for (int entity = lines; entity < planes; ++entity) {
    const LineForms& line = forms.line(entity);
    BallMatrix foot = decimals.vector(line.foot, true), direction = decimals.vector(line.direction, false);
    frame.place(foot);
    frame.turn(direction);
    frame.move_to_foot(foot, direction);
    direct(direction, near_lines[static_cast<std::size_t>(entity - lines)].direction);
    figure.lines.push_back({decimals.decimal(foot), decimals.decimal(direction)});
  }
  for (int entity = planes; entity < problem.entity_count(); ++entity) {
    const PlaneForms& plane = forms.plane(entity);
    BallMatrix normal = decimals.vector(plane.normal, false);
    Ball offset;
    decimals.enclose_form(offset, plane.offset, true);
    frame.turn(normal);
    frame.shift(offset, normal);
    figure.planes.push_back({decimals.decimal(normal), decimals.decimal(offset)});
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
    place.direction[0].re.push_back('1');
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
  DecimalFigure figure = general ? general_decimals(decimals, general->elements(), FileFrame(scene, bits),
                                                    scene.in_file_unit(near))
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

int digits_that_hold(const Scene& scene, const Figure& figure) {
  constexpr int of_doubles = 17;
  double shortest = scene.size();
  if (!scene.problem().is_general())
    for (const double length : scene.target_lengths())
      if (length > 0) shortest = std::min(shortest, length);
  // A squared length ℓ² is the difference of squares of coordinates X: it takes (X/ℓ)² as fine ones.
  const double reach = std::max(0.0, std::log10(extent(figure)) - std::log10(shortest));
  return of_doubles + static_cast<int>(std::ceil(2 * reach));
}

std::vector<std::optional<DecimalFigure>> decimal_figures(const SceneEquations& equations, const Scene& scene,
                                                          const std::vector<Figure>& near, int digits,
                                                          int threads, const std::stop_token& stop) {
  std::vector<std::optional<DecimalFigure>> figures(near.size());
  share_on_threads(near.size(), threads, [&](std::size_t i) {
    if (!stop.stop_requested()) figures[i] = decimal_figure(equations, scene, near[i], digits);
  });
  return figures;
}

}  // namespace gcs
