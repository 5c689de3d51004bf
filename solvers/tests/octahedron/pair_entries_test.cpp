#include "solvers/octahedron/pair_entries.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "solvers/octahedron/exact_determinants.hpp"
#include "solvers/octahedron/exact_elimination.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

/// Points with integer coordinates, planes with normals in 25ths and integer offsets: all entries are short decimals.
class ExactFigure {
 public:
  /// Elements 0–3, 1–4, 2–5 are opposite; the last ones are planes.
  ExactFigure(int planes, RandomNumbers& random) : planes_(planes) {
    static constexpr std::array<std::array<long, 3>, 6> normals{
        {{9, 12, 20}, {15, 0, 20}, {12, 16, 15}, {0, 7, 24}, {16, 12, 15}, {20, 9, 12}}};
    for (int i = 0; i < 6; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto sign = random.uniform(-1, 1) < 0 ? -1 : 1;
        const auto coordinate = static_cast<long>(random.uniform(-9, 9));
        at(i)[axis] = is_plane(i) ? sign * normals[static_cast<std::size_t>(i)][axis] : coordinate;
        offset_[static_cast<std::size_t>(i)] = coordinate;
      }
  }

  bool is_plane(int i) const { return i >= 6 - planes_; }

  /// What is given, or would be, of a pair, times 625.
  long entry(int p, int q) const {
    long product = 0, square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      product += at(p)[axis] * at(q)[axis];
      square += (at(p)[axis] - at(q)[axis]) * (at(p)[axis] - at(q)[axis]);
    }
    if (is_plane(p)) return product;
    return is_plane(q) ? 25 * product - 625 * offset_[static_cast<std::size_t>(q)] : 625 * square;
  }

  ProblemStatement problem() const {
    ProblemStatement problem;
    for (int i = 0; i < 6; ++i) (is_plane(i) ? problem.planes : problem.points).push_back(std::to_string(i));
    problem.reference = Reference{0, 1, 2};
    for (int p = 0; p < 6; ++p)
      for (int q = p + 1; q < 6; ++q) {
        if (q == p + 3) continue;
        const std::string text = std::to_string(16 * entry(p, q)) + "e-4";
        const Decimal given{static_cast<double>(16 * entry(p, q)) / 1e4, text};
        const std::string id = std::to_string(6 * p + q);
        if (!is_plane(q))
          problem.constraints.push_back({id, {p, q}, given, true});
        else
          problem.relations.push_back({id,
                                       is_plane(p) ? "angle" : "distance",
                                       {{p}, {q}},
                                       is_plane(p) ? Relation::Form::cosine : Relation::Form::length,
                                       given});
      }
    return problem;
  }

  /// In the scene's unit.
  Rational diagonal(const Scene& scene, const std::array<int, 2>& pair) const {
    const int power = is_plane(pair[1]) ? 1 : 2;
    return (Rational(entry(pair[0], pair[1])) / Rational(625))
        .times_power_of_two(-power * scene.unit_exponent());
  }

 private:
  std::array<long, 3>& at(int i) { return vectors_[static_cast<std::size_t>(i)]; }
  const std::array<long, 3>& at(int i) const { return vectors_[static_cast<std::size_t>(i)]; }

  int planes_;
  std::array<std::array<long, 3>, 6> vectors_{};
  std::array<long, 6> offset_{};
};

}  // namespace

TEST_CASE(
    "the determinants of points and planes vanish, exactly, at the diagonals of a figure, and not beside") {
  RandomNumbers random(1);
  for (int i = 0; i < 12; ++i) {
    const int planes = i % 4;
    const ExactFigure figure(planes, random);
    const Scene scene = Scene::unchecked(figure.problem());
    Octahedron octahedron{{{{0, 3}, {1, 4}, {2, 5}}}};
    for (int third = 0; third < 3; ++third) {
      const auto [a, a2] = octahedron.pair[0];
      const auto [b, b2] = octahedron.pair[1];
      const SymbolicEntries entries(scene, octahedron);
      const Rational x = figure.diagonal(scene, {a, a2}), y = figure.diagonal(scene, {b, b2});
      for (const int c : octahedron.pair[2]) {
        const RationalPolynomial determinant = gram_determinant(entries, c, {a, a2, b, b2});
        CHECK(determinant.value({x, y}).is_zero());
        CHECK_FALSE(determinant.value({x, y + Rational(1)}).is_zero());
      }
      const OctahedronPolynomials polynomials = eliminated(scene, octahedron);
      CHECK(polynomials.diagonal.degree() == 8);
      CHECK(polynomials.diagonal.value(x).is_zero());
      CHECK(polynomials.height.degree() == 16);
      std::rotate(octahedron.pair.begin(), octahedron.pair.begin() + 1, octahedron.pair.end());
    }
  }
}
