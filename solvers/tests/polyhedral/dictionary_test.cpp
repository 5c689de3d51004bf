#include "solvers/polyhedral/dictionary.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;

namespace {

SparseForm form(double constant, double x, double y) { return {constant, {{0, x}, {1, y}}}; }

double value(const SparseForm& f, const Eigen::Vector2d& at) {
  return f.constant + f.terms[0].coefficient * at[0] + f.terms[1].coefficient * at[1];
}

Eigen::Vector2d intersection(const SparseForm& f, const SparseForm& g) {
  Eigen::Matrix2d gradients;
  gradients << f.terms[0].coefficient, f.terms[1].coefficient, g.terms[0].coefficient, g.terms[1].coefficient;
  return gradients.inverse() * -Eigen::Vector2d(f.constant, g.constant);
}

/// Whether an intersection of two of the first `count` lines is in all their half planes; of one line with
/// the others if `on` names it. What is bounded is empty unless it has a vertex.
bool has_vertex(const std::vector<SparseForm>& forms, std::size_t count, std::optional<std::size_t> on = {}) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (on && i != *on && j != *on) continue;
      const Eigen::Vector2d vertex = intersection(forms[i], forms[j]);
      bool inside = true;
      for (std::size_t k = 0; k < count; ++k)
        inside = inside && (k == i || k == j || value(forms[k], vertex) >= 0);
      if (inside) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("half planes have a point in common, and touch it, as their vertices say") {
  samples::RandomNumbers random(9);
  int empty = 0, touching = 0, apart = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<SparseForm> forms{form(2, 1, 0.01), form(2, -1, 0.02), form(2, 0.03, 1), form(2, 0.04, -1)};
    while (forms.size() < 9)
      forms.push_back(form(random.uniform(-0.3, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    Dictionary dictionary(2);
    SimplexWork work;
    bool nonempty = true;
    for (std::size_t k = 0; k < forms.size() && nonempty; ++k) {
      nonempty = dictionary.constrain(forms[k], static_cast<int>(k), work);
      if (k >= 3) CHECK(nonempty == has_vertex(forms, k + 1));
    }
    empty += !nonempty;
    for (std::size_t k = 0; k < forms.size() && nonempty; ++k) {
      const bool touches = dictionary.can_vanish(static_cast<int>(k), work);
      CHECK(touches == has_vertex(forms, forms.size(), k));
      touching += touches;
      apart += !touches;
    }
    CHECK(work.near_ties == 0);
  }
  CHECK(std::min({empty, touching, apart}) > 20);
}

TEST_CASE("a face has one dimension less and keeps the other constraints") {
  Dictionary triangle(2);
  SimplexWork work;
  REQUIRE(triangle.constrain(form(0, 1, 0), 0, work));
  REQUIRE(triangle.constrain(form(0, 0, 1), 1, work));
  REQUIRE(triangle.constrain(form(1, -1, -1), 2, work));
  REQUIRE(triangle.can_vanish(2, work));
  const Dictionary hypotenuse = triangle.face(2);
  CHECK(hypotenuse.dimension() == 1);
  Dictionary far(hypotenuse), near(hypotenuse);
  CHECK(near.constrain(form(-0.75, 1, 0), 3, work));
  CHECK_FALSE(near.constrain(form(-0.5, 0, 1), 4, work));
  CHECK_FALSE(far.constrain(form(-1.5, 1, 0), 3, work));
}

TEST_CASE("a decision that rounding could turn is counted") {
  Dictionary half(1);
  SimplexWork work;
  REQUIRE(half.constrain({0, {{0, 1}}}, 0, work));
  CHECK_FALSE(half.constrain({-1e-14, {{0, -1}}}, 1, work));
  CHECK(work.near_ties == 1);
}
