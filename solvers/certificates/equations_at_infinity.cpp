#include "solvers/certificates/equations_at_infinity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// Of the form that is given of directions: any numbers that axes and diagonals of scenes are not likely to be orthogonal
/// to.
constexpr std::array<double, 3> weights{1, 0.6875, -0.4375};

LinearForm unknown_form(int unknown) { return unknown < 0 ? LinearForm() : LinearForm{{{unknown}}, {}}; }

LinearForm scaled(LinearForm form, double factor) {
  for (ScaledUnknown& term : form.terms)
    term.coefficient = exactly(factor * rounded_to_double(term.coefficient));
  form.constant = exactly(factor * rounded_to_double(form.constant));
  return form;
}

LinearForm weighted(const VectorForm& forms) {
  LinearForm sum;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const ScaledUnknown& term : forms[axis].terms)
      sum.terms.push_back({term.unknown, exactly(weights[axis])});
  return sum;
}

Complex weighted(const Eigen::Vector3cd& v) {
  return weights[0] * v[0] + weights[1] * v[1] + weights[2] * v[2];
}

bool contains(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// An edge that is in no other walk.
std::optional<int> own_edge(const std::vector<Escape>& escapes, const ClosedWalk& walk) {
  for (const int edge : walk.edges) {
    if (edge < 0) continue;
    const auto has_it = [&](const Escape& escape) { return contains(escape.walk.edges, edge); };
    if (std::count_if(escapes.begin(), escapes.end(), has_it) == 1) return edge;
  }
  return std::nullopt;
}

const std::array<int, 2>& ends(const Scene& scene, int edge) {
  return scene.problem().constraints[static_cast<std::size_t>(edge)].between;
}

/// The isotropic vector orthogonal to d, of the two the one along v, on which the form is 1.
Eigen::Vector3cd isotropic_beside(const Eigen::Vector3cd& v, const Eigen::Vector3cd& d) {
  const Complex square = bilinear_product(d, d);
  const Eigen::Vector3cd one = v - (bilinear_product(v, d) / square) * d;
  const Eigen::Vector3cd other = cross_product(d, one) / std::sqrt(square);
  const Eigen::Vector3cd plus = one + Complex(0, 1) * other, minus = one - Complex(0, 1) * other;
  const Eigen::Vector3cd n = plus.norm() > minus.norm() ? plus : minus;
  return n / weighted(n);
}

}  // namespace

bool EquationsAtInfinity::know(const Scene& scene, const Reference& frame,
                               const std::vector<Escape>& escapes) {
  std::vector<int> escape_of(static_cast<std::size_t>(scene.point_count()), -1);
  for (std::size_t e = 0; e < escapes.size(); ++e) {
    const int across = escapes[e].walk.across;
    const bool crosses_another = std::ranges::none_of(
        escapes, [&](const Escape& other) { return across < 0 || other.number == across; });
    if (crosses_another || !own_edge(escapes, escapes[e].walk)) return false;
    for (const int point : escapes[e].points)
      if (std::exchange(escape_of[static_cast<std::size_t>(point)], static_cast<int>(e)) >= 0) return false;
  }
  const auto escape = [&](int point) { return escape_of[static_cast<std::size_t>(point)]; };
  for (int edge = 0; edge < scene.constraint_count(); ++edge) {
    const auto [a, b] = ends(scene, edge);
    if (escape(a) >= 0 && escape(b) >= 0 && escape(a) != escape(b)) return false;
  }
  return escape(frame.origin) < 0 && escape(frame.axis) < 0 && escape(frame.plane) < 0;
}

EquationsAtInfinity::EquationsAtInfinity(const Scene& scene, const Reference& frame,
                                         std::vector<Escape> escapes)
    : scene_(scene),
      frame_(scene, frame),
      joined_(neighbours_of(scene)),
      escapes_(std::move(escapes)),
      place_(3 * static_cast<std::size_t>(scene.point_count()), -1),
      escaping_(static_cast<std::size_t>(scene.point_count())) {
  for (std::size_t e = 0; e < escapes_.size(); ++e)
    for (const int point : escapes_[e].points)
      escaping_[static_cast<std::size_t>(point)].escape = static_cast<int>(e);
  std::vector<int> axes;
  for (int point = 0; point < scene.point_count(); ++point)
    for (int axis = 0; axis < 3; ++axis) {
      if (!stays(point) || frame_.unknown(point, axis) < 0) continue;
      place_[static_cast<std::size_t>(3 * point + axis)] = static_cast<int>(axes.size());
      axes.push_back(axis);
    }
  for (std::size_t e = 0; e < escapes_.size(); ++e) {
    sum_.push_back(static_cast<int>(axes.size()));
    axes.push_back(-1);
  }
  mirror_ = SignMasks(axes);
  unknowns_ = static_cast<int>(axes.size());
  for (std::size_t e = 0; e < escapes_.size(); ++e) {
    left_out_.push_back(*own_edge(escapes_, escapes_[e].walk));
    add_unknowns(static_cast<int>(e));
  }
}

void EquationsAtInfinity::add_unknowns(int escape) {
  const Escape& from = escapes_[static_cast<std::size_t>(escape)];
  direction_.push_back(unknowns_);
  unknowns_ += 3;
  std::vector<int>& across = across_.emplace_back(static_cast<std::size_t>(scene_.point_count()), -1);
  for (const int point : from.points) {
    Escaping& unknowns = escaping_[static_cast<std::size_t>(point)];
    unknowns.q = unknowns_;
    unknowns_ += 3;
    if (point != from.points.front()) unknowns.u = unknowns_++;
    across[static_cast<std::size_t>(point)] = unknowns_++;
  }
  for (std::size_t i = 2; i < from.walk.corners.size(); ++i)
    across[static_cast<std::size_t>(from.walk.corners[i])] = unknowns_++;
}

VectorForm EquationsAtInfinity::place(int point) const {
  const auto first = 3 * static_cast<std::size_t>(point);
  return {unknown_form(place_[first]), unknown_form(place_[first + 1]), unknown_form(place_[first + 2])};
}

VectorForm EquationsAtInfinity::direction(int escape) const {
  const int first = direction_[static_cast<std::size_t>(escape)];
  return {unknown_form(first), unknown_form(first + 1), unknown_form(first + 2)};
}

/// q of a point that escapes, x − o of one that stays.
VectorForm EquationsAtInfinity::offset(int point, int escape) const {
  if (const int q = of(point).q; q >= 0) return {unknown_form(q), unknown_form(q + 1), unknown_form(q + 2)};
  const VectorForm x = place(point), o = place(origin(escape));
  if (point == origin(escape)) return {};
  return {difference(x[0], o[0]), difference(x[1], o[1]), difference(x[2], o[2])};
}

/// u, 0 of a point that stays.
LinearForm EquationsAtInfinity::along(int point) const {
  if (stays(point)) return {};
  return of(point).u < 0 ? constant_form(exactly(1)) : unknown_form(of(point).u);
}

int EquationsAtInfinity::across_unknown(int point, int escape) const {
  return across_[static_cast<std::size_t>(escape)][static_cast<std::size_t>(point)];
}

/// t
LinearForm EquationsAtInfinity::across(int point, int escape) const {
  return unknown_form(across_unknown(point, escape));
}

/// The squared distance, as far as it is free of 1/w.
Equation EquationsAtInfinity::distance(int a, int b) const {
  Equation square;
  if (stays(a) && stays(b)) return std::move(square.plus_square_of_difference(place(a), place(b)));
  const int escape = std::max(of(a).escape, of(b).escape);
  square.plus_square_of_difference(offset(a, escape), offset(b, escape));
  const LinearForm u = difference(along(a), along(b)), t = difference(across(a, escape), across(b, escape));
  return std::move(square.plus(u, t).plus(u, t));
}

/// n·n = 0, the form of n; the planes of all points that have a t, and the form of each q.
void EquationsAtInfinity::add_planes(int escape, bool is_around, QuadraticSystem& system) const {
  const Escape& from = escapes_[static_cast<std::size_t>(escape)];
  const VectorForm n = direction(escape);
  system.equations.push_back(Equation().plus(n, n).equals());
  system.equations.push_back(Equation().plus(weighted(n)).equals(exactly(1)));
  std::vector<int> in_plane(from.walk.corners.begin() + 1, from.walk.corners.end());
  in_plane.insert(in_plane.end(), from.points.begin(), from.points.end());
  for (const int point : in_plane) {
    Equation plane;
    plane.plus(n, offset(point, escape));
    if (is_around && across_unknown(point, escape) >= 0)
      plane.minus(unknown_form(inverse_size(escape)), across(point, escape));
    system.equations.push_back(plane.equals());
  }
  for (const int point : from.points)
    system.equations.push_back(Equation().plus(weighted(offset(point, escape))).equals());
}

/// Of pairs at no given distance, so many as rounding is bounded for, with weights that solutions are not likely to be in
/// step with.
QuadraticEquation EquationsAtInfinity::summed_distances(int escape) const {
  constexpr int most_pairs = 16;
  const Escape& from = escapes_[static_cast<std::size_t>(escape)];
  Equation sum;
  sum.minus(unknown_form(sum_[static_cast<std::size_t>(escape)]));
  std::vector<int> others = from.walk.corners;
  std::ranges::sort(others);
  int pairs = 0;
  for (const int point : from.points) {
    for (const int other : others) {
      if (is_given(point, other) || ++pairs > most_pairs) continue;
      const double weight = std::fmod(0.6180339887498949 * pairs, 1.0);
      const QuadraticEquation square = distance(point, other).equals();
      for (const auto& [left, right] : square.products) sum.plus(scaled(left, weight), right);
    }
    others.push_back(point);
  }
  return sum.equals();
}

bool EquationsAtInfinity::is_given(int a, int b) const {
  return joined_[static_cast<std::size_t>(a)].contains(b);
}

QuadraticSystem EquationsAtInfinity::system(bool is_around) const {
  QuadraticSystem system;
  const auto count = static_cast<int>(escapes_.size());
  system.unknowns = unknowns_ + (is_around ? count : 0);
  for (int edge = 0; edge < scene_.constraint_count(); ++edge)
    if (is_around || !contains(left_out_, edge)) {
      const auto [a, b] = ends(scene_, edge);
      system.equations.push_back(distance(a, b).equals(given_square(scene_, edge)));
    }
  for (int escape = 0; escape < count; ++escape) {
    add_planes(escape, is_around, system);
    system.equations.push_back(summed_distances(escape));
  }
  return system;
}

std::vector<Complex> EquationsAtInfinity::unknowns_near(const ComplexPoints& points) const {
  std::vector<Complex> x(static_cast<std::size_t>(unknowns_));
  const auto set = [&](int unknown, Complex value) {
    if (unknown >= 0) x[static_cast<std::size_t>(unknown)] = value;
  };
  const auto set_vector = [&](int first, const Eigen::Vector3cd& value) {
    for (int axis = 0; axis < 3; ++axis) set(first + axis, value[axis]);
  };
  for (Eigen::Index point = 0; point < points.cols(); ++point)
    for (int axis = 0; axis < 3; ++axis)
      set(place_[static_cast<std::size_t>(3 * point + axis)], points(axis, point));
  for (std::size_t e = 0; e < escapes_.size(); ++e) {
    const Escape& escape = escapes_[e];
    const Eigen::Vector3cd o = points.col(escape.walk.corners[0]);
    const Eigen::Vector3cd far = points.col(escape.points.front()) - o;
    const Eigen::Vector3cd n = isotropic_beside(far, points.col(escape.walk.corners[1]) - o);
    const Complex size = weighted(far);
    set_vector(direction_[e], n);
    for (const int corner : escape.walk.corners)
      set(across_[e][static_cast<std::size_t>(corner)],
          size * bilinear_product(n, Eigen::Vector3cd(points.col(corner) - o)));
    for (const int point : escape.points) {
      const Eigen::Vector3cd p = points.col(point) - o, q = p - weighted(p) * n;
      set_vector(of(point).q, q);
      set(of(point).u, weighted(p) / size);
      set(across_unknown(point, static_cast<int>(e)), size * bilinear_product(n, q));
    }
    const QuadraticEquation sum = summed_distances(static_cast<int>(e));
    Complex value = 0;
    for (const FormProduct& product : sum.products)
      value += value_at(product.left, x) * value_at(product.right, x);
    set(sum_[e], value);
  }
  return x;
}

/// The steps d_i of a walk in an isotropic plane are ±a_i in its coordinate ℓ, so that d_0·d_i = ±a_0 a_i: which, is read
/// from the enclosure. The step that was left out is minus the sum of the others, and has the right square if the signed
/// sum vanishes.
bool EquationsAtInfinity::holds_solution(const Enclosure& solution) const {
  struct Step {
    std::array<Complex, 3> mid{};
    std::array<double, 3> radius{};
  };
  const auto step = [&](int from, int to) {
    Step result;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const auto& [point, sign] : {std::pair(from, -1.0), std::pair(to, 1.0)}) {
        const int unknown = place_[3 * static_cast<std::size_t>(point) + axis];
        if (unknown < 0) continue;
        const auto i = static_cast<std::size_t>(unknown);
        result.mid[axis] += sign * solution.mid[i];
        result.radius[axis] += std::abs(solution.radius[i]) + 4 * epsilon * std::abs(solution.mid[i]);
      }
    return result;
  };
  const auto has_sign = [&](const Step& a, const Step& b, int sign) {
    double product = 0, error = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size_a = std::abs(a.mid[axis]), size_b = std::abs(b.mid[axis]);
      product += (a.mid[axis] * b.mid[axis]).real();
      error += size_a * b.radius[axis] + a.radius[axis] * (size_b + b.radius[axis]) +
               32 * epsilon * size_a * size_b;
    }
    return sign * product > 2 * error;
  };
  const auto closes = [&](const ClosedWalk& walk) {
    const Step first = step(walk.corners[0], walk.corners[1]);
    for (std::size_t i = 1; i < walk.corners.size(); ++i)
      if (!has_sign(first, step(walk.corners[i], walk.corners[(i + 1) % walk.corners.size()]), walk.signs[i]))
        return false;
    return true;
  };
  return std::ranges::all_of(escapes_, [&](const Escape& escape) { return closes(escape.walk); }) &&
         std::ranges::all_of(escaping_, [&](const Escaping& point) {
           if (point.u < 0) return true;
           const auto u = static_cast<std::size_t>(point.u);
           return std::abs(solution.mid[u]) > 2 * std::abs(solution.radius[u]);
         });
}

}  // namespace gcs
