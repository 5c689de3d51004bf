#include "solvers/certificates/dyadic_figure.hpp"

#include <flint/flint.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>

#include "solvers/certificates/enclosed_point.hpp"
#include "solvers/certificates/multiple_solution.hpp"
#include "solvers/model/frame_choice.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// Each number is in its ball, and no other solution has all of them within `unique` of the middles.
struct Place {
  BallMatrix numbers;
  double unique = 0;
  int bits = bits_of_doubles;
};

Place place_of(const Enclosure& enclosure) { return {balls_of(enclosure), enclosure.unique}; }

Place place_of(const BallKrawczyk::Proof& proof, slong bits) {
  return {proof.solution, proof.unique, static_cast<int>(bits)};
}

/// At most so far are numbers from their middles.
double spread(const BallMatrix& numbers, slong bits) {
  BallMatrix rest = numbers;
  acb_mat_get_mid(rest.get(), rest.get());
  acb_mat_sub(rest.get(), numbers.get(), rest.get(), bits);
  double largest = 0;
  for (slong i = 0; i < rest.rows(); ++i) largest = std::max(largest, magnitude(rest(i, 0)));
  return largest;
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
  const double rounding = std::ldexp(size, -place.bits);
  const int exponent = std::ilogb(std::max(spread(place.numbers, place.bits), rounding));
  if (exponent > 0 || place.unique < std::ldexp(4 * DyadicBox::radius, exponent)) return std::nullopt;
  return exponent;
}

DecimalNumber whole_numbers(acb_srcptr value, int exponent) {
  return {whole_number(acb_realref(value), exponent), whole_number(acb_imagref(value), exponent)};
}

DyadicBox box_of(const BallMatrix& numbers, int exponent) {
  DyadicBox box{{}, exponent};
  for (slong i = 0; i < numbers.rows(); ++i) box.numbers.push_back(whole_numbers(numbers(i, 0), exponent));
  return box;
}

std::optional<DyadicBox> box_of(Place place, double unique_of_outer) {
  place.unique = std::min(place.unique, unique_of_outer);
  const std::optional<int> exponent = exponent_for(place, 1);
  return exponent ? std::optional(box_of(place.numbers, *exponent)) : std::nullopt;
}

bool is_real_within(const BallMatrix& numbers, double reach) {
  for (slong i = 0; i < numbers.rows(); ++i)
    if (std::abs(rounded_midpoint(numbers(i, 0)).imag()) > reach) return false;
  return true;
}

double largest_difference(const ComplexValues& x, const ComplexValues& y) {
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
  return largest;
}

/// What dyadic_figures lists of a scene.
class Listed {
 public:
  Listed(const SceneEquations& equations, const Scene& scene)
      : equations_(equations),
        general_(equations.general()),
        problem_(scene.problem()),
        dimension_(static_cast<std::size_t>(scene.dimension())) {
    for (int entity = 0; entity < problem_.entity_count(); ++entity)
      if (!rests(entity)) add_element(entity);
  }

  /// `unknowns`: of the scene's equations.
  BallMatrix numbers(const BallMatrix& unknowns, slong bits) const {
    BallMatrix result(static_cast<slong>(forms_.size()), 1);
    slong row = 0;
    for (const LinearForm& form : forms_) enclose(result(row++, 0), form, unknowns, bits);
    return result;
  }

 private:
  bool rests(int entity) const {
    return rests_in_frame(problem_, entity) ||
           std::ranges::count(bodies_with(problem_, entity), problem_.reference_body) > 0;
  }

  static LinearForm form_of(int unknown) { return unknown < 0 ? LinearForm{} : LinearForm{{{unknown}}, {}}; }

  VectorForm point(int point) const {
    if (general_) return general_->elements().point(point);
    VectorForm forms;
    for (std::size_t axis = 0; axis < dimension_; ++axis)
      forms[axis] = form_of(equations_.point_unknown(point, static_cast<int>(axis)));
    return forms;
  }

  /// The point nearest to the origin (part 0) or the direction (part 1), which is that of the x-axis where the frame says it.
  VectorForm line(int entity, int part) const {
    if (general_) {
      const LineForms& line = general_->elements().line(entity);
      return part == 0 ? line.foot : line.direction;
    }
    VectorForm forms;
    for (std::size_t axis = 0; axis < 3; ++axis)
      forms[axis] = form_of(equations_.line_unknown(problem_.line_of(entity), part, static_cast<int>(axis)));
    if (part == 1 && forms[0].terms.empty()) forms[0].constant = exactly(1);
    return forms;
  }

  void add(const VectorForm& forms) {
    forms_.insert(forms_.end(), forms.begin(), forms.begin() + static_cast<std::ptrdiff_t>(dimension_));
  }

  void add_element(int entity) {
    if (problem_.is_point(entity)) {
      add(point(entity));
    } else if (problem_.is_line(entity)) {
      add(line(entity, 0));
      add(line(entity, 1));
    } else {
      const PlaneForms& plane = general_->elements().plane(entity);
      add(plane.normal);
      forms_.push_back(plane.offset);
    }
  }

  const SceneEquations& equations_;
  const SceneSystem* general_;
  const ProblemStatement& problem_;
  std::size_t dimension_;
  std::vector<LinearForm> forms_;
};

class DyadicWriter {
 public:
  DyadicWriter(const SceneEquations& equations, const Scene& scene)
      : equations_(equations),
        listed_(equations, scene),
        size_(scene.size()),
        certifier_(equations.system()) {}

  std::optional<DyadicBox> box(const Figure& near) const {
    const ComplexValues x = equations_.coordinates(near);
    const Certificate certificate = certifier_.certify(x);
    if (certificate.is_multiple) return multiple_box(certificate);
    if (certificate.cluster > 0) return cluster_box(certificate);
    if (certificate.is_proven)
      if (auto result = box(place_of(certificate.enclosure), near.is_real())) return result;
    for (const slong bits : ball_precisions)
      if (const auto proof = certifier_.prove(x, bits))
        if (auto result = box(place_of(*proof, bits), near.is_real())) return result;
    return std::nullopt;
  }

 private:
  std::optional<DyadicBox> box(const Place& of_unknowns, bool is_real) const {
    const slong bits = std::max<slong>(of_unknowns.bits, ball_precisions.front());
    const Place place{listed_.numbers(of_unknowns.numbers, bits), of_unknowns.unique, of_unknowns.bits};
    const std::optional<int> exponent = exponent_for(place, size_);
    if (!exponent ||
        (!is_real && is_real_within(place.numbers, std::ldexp(2 * DyadicBox::radius, *exponent))))
      return std::nullopt;
    return box_of(place.numbers, *exponent);
  }

  /// Four times as large as the cluster: other coordinates take more room.
  static int exponent_about(const Certificate& certificate) {
    double reach = 0;
    for (const std::complex<double>& radius : certificate.enclosure.radius)
      reach = std::max(reach, std::abs(radius));
    return std::ilogb(8 * reach) - std::ilogb(double{DyadicBox::radius});
  }

  std::optional<DyadicBox> cluster_box(const Certificate& certificate) const {
    const int exponent = exponent_about(certificate);
    if (exponent > 0) return std::nullopt;
    Enclosure middle = certificate.enclosure;
    for (std::complex<double>& radius : middle.radius) radius = 0;
    DyadicBox result = box_of(listed_.numbers(balls_of(middle), ball_precisions.front()), exponent);
    result.solutions = certificate.cluster;
    return result;
  }

  /// Of as many digits that there are no simpler fractions within their last ones.
  std::optional<DyadicBox> multiple_box(const Certificate& certificate) const {
    constexpr slong bits = 256;
    constexpr int exponent = -120;
    const int widening = exponent_about(certificate) - exponent;
    if (widening < 0 || widening > -exponent) return std::nullopt;
    std::vector<double> radius;
    for (const std::complex<double>& one : certificate.enclosure.radius) radius.push_back(one.real());
    const auto fractions = simplest_fractions(certificate.enclosure.mid, radius);
    DyadicBox result = box_of(listed_.numbers(enclosed(*fractions, bits), bits), exponent);
    result.widening = widening;
    result.solutions = certificate.cluster;
    result.is_multiple = true;
    return result;
  }

  const SceneEquations& equations_;
  Listed listed_;
  double size_;
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

std::vector<std::optional<DyadicBox>> dyadic_figures(const SceneEquations& equations, const Scene& scene,
                                                     const std::vector<Figure>& near, int threads) {
  const DyadicWriter writer(equations, scene);
  std::vector<std::optional<DyadicBox>> boxes(near.size());
  share_on_threads(near.size(), threads, [&](std::size_t i) { boxes[i] = writer.box(near[i]); });
  std::vector<std::size_t> clusters;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i] || boxes[i]->solutions == 1) continue;
    const auto meets_this = [&](std::size_t other) {
      return largest_difference(equations.coordinates(near[i]), equations.coordinates(near[other])) <=
             boxes[i]->reach() + boxes[other]->reach();
    };
    if (std::ranges::any_of(clusters, meets_this))
      boxes[i].reset();
    else
      clusters.push_back(i);
  }
  return boxes;
}

}  // namespace gcs
