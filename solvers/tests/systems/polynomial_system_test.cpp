#include "solvers/systems/polynomial_system.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "solvers/systems/homogeneous_bound.hpp"
#include "solvers/systems/quadratic_lift.hpp"
#include "solvers/systems/system_paths.hpp"
#include "solvers/tests/polyhedral/sample_supports.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

const RationalPolynomial x = RationalPolynomial::variable(0), y = RationalPolynomial::variable(1);

int degree_in_group(const Support& support, const std::vector<int>& group_of, int group) {
  int highest = 0;
  for (const Exponents& monomial : support) {
    int degree = 0;
    for (std::size_t v = 0; v < monomial.size(); ++v) degree += group_of[v] == group ? monomial[v] : 0;
    highest = std::max(highest, degree);
  }
  return highest;
}

/// Every equation chooses a group, one choice after the other; a group is chosen as often as it has unknowns.
std::int64_t bound_by_choices(const Supports& supports, const std::vector<int>& group_of,
                              std::vector<int> left, std::size_t equation = 0) {
  if (equation == supports.size()) return 1;
  std::int64_t sum = 0;
  for (int group = 0; group < static_cast<int>(left.size()); ++group) {
    std::vector<int> next = left;
    if (--next[static_cast<std::size_t>(group)] < 0) continue;
    sum += degree_in_group(supports[equation], group_of, group) *
           bound_by_choices(supports, group_of, next, equation + 1);
  }
  return sum;
}

std::int64_t bound_by_choices(const Supports& supports, const std::vector<int>& group_of) {
  std::vector<int> sizes(static_cast<std::size_t>(*std::max_element(group_of.begin(), group_of.end()) + 1),
                         0);
  for (const int group : group_of) ++sizes[static_cast<std::size_t>(group)];
  return bound_by_choices(supports, group_of, sizes);
}

/// Calls visit for every way to put so many unknowns into groups.
void for_all_groups(std::size_t unknowns, std::vector<int>& group_of,
                    const std::function<void(const std::vector<int>&)>& visit) {
  if (group_of.size() == unknowns) return visit(group_of);
  const int groups = group_of.empty() ? 0 : *std::max_element(group_of.begin(), group_of.end()) + 1;
  for (int group = 0; group <= groups; ++group) {
    group_of.push_back(group);
    for_all_groups(unknowns, group_of, visit);
    group_of.pop_back();
  }
}

Natural volume(const Supports& supports) {
  const auto found = mixed_volume(supports, 1, 1, {});
  REQUIRE(found);
  return *found;
}

}  // namespace

TEST_CASE("elimination of monomials keeps the zeros and lowers the degrees") {
  const PolynomialSystem circles{
      2, {x * x + y * y - Rational(25), x * x + y * y - x * Rational(2) - Rational(15)}};
  const PolynomialSystem eliminated = echelon_form(circles);
  CHECK(circles.total_degree() == Natural(4));
  CHECK(eliminated.total_degree() == Natural(2));
  CHECK(circles.terms() == 7);
  REQUIRE(eliminated.equations.size() == 2);
  for (const RationalPolynomial& equation : eliminated.equations)
    CHECK(equation.value({Rational(5), Rational(0)}).is_zero());
  PolynomialSystem dependent = circles;
  dependent.equations[1] = circles.equations[0] * Rational(3);
  CHECK(echelon_form(dependent).equations.size() == 1);
}

TEST_CASE("the multihomogeneous number is what choosing a group for each equation gives") {
  RandomNumbers random(1);
  for (int i = 0; i < 20; ++i) {
    const Supports supports = samples::random_supports(4, 5, 0, 2, random);
    std::vector<int> start;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for_all_groups(4, start, [&](const std::vector<int>& group_of) {
      const std::int64_t bound = bound_by_choices(supports, group_of);
      least = std::min(least, bound);
      CHECK(homogeneous_bound(supports, group_of) == Natural(static_cast<std::uint64_t>(bound)));
    });
    const HomogeneousBound found = small_homogeneous_bound(supports);
    CHECK(found.bound >= Natural(static_cast<std::uint64_t>(least)));
    CHECK(found.bound == homogeneous_bound(supports, found.group_of));
    CHECK(volume(supports) <= found.bound);
  }
}

// A. Morgan, A. Sommese, Appl. Math. Comput. 24 (1987): of the eigenvalue problem n, not 2^(n − 1) · 1.
TEST_CASE("the eigenvalue problem has as many zeros as its multihomogeneous number says") {
  for (int n = 2; n <= 5; ++n) {
    const RationalPolynomial eigenvalue = RationalPolynomial::variable(n - 1);
    const auto component = [&](int i) { return i < n - 1 ? RationalPolynomial::variable(i) : Rational(1); };
    PolynomialSystem system{n, {}};
    for (int i = 0; i < n; ++i) {
      RationalPolynomial row = eigenvalue * component(i);
      for (int j = 0; j < n; ++j) row = row - component(j) * Rational(1 + i * j + i);
      system.equations.push_back(row);
    }
    CHECK(system.total_degree() == Natural::power_of_two(n - 1));
    CHECK(small_homogeneous_bound(supports_of(system)).bound == Natural(static_cast<std::uint64_t>(n)));
  }
}

TEST_CASE("a lift has two factors in each monomial, the same values and the same mixed volume") {
  RandomNumbers random(2);
  for (int i = 0; i < 10; ++i) {
    const Supports supports = samples::random_supports(3, 4, 0, 3, random);
    const QuadraticLift lift = quadratic_lift(supports);
    ComplexVectorX point;
    for (int v = 0; v < 3; ++v) point.emplace_back(random.uniform(0.5, 2), random.uniform(-1, 1));
    const ComplexVectorX all = lift.lifted(point);
    REQUIRE(all.size() == lift.supports.size());
    const auto value = [](const Exponents& exponents, const ComplexVectorX& at) {
      std::complex<double> product = 1;
      for (std::size_t v = 0; v < exponents.size(); ++v) product *= std::pow(at[v], exponents[v]);
      return product;
    };
    for (std::size_t e = 0; e < lift.supports.size(); ++e)
      for (std::size_t c = 0; c < lift.supports[e].size(); ++c) {
        const Exponents& monomial = lift.supports[e][c];
        CHECK(std::accumulate(monomial.begin(), monomial.end(), 0) <= 2);
        const std::complex<double> wanted =
            e < supports.size() ? value(supports[e][c], point) : value(lift.supports[e][1 - c], all);
        CHECK(std::abs(value(monomial, all) - wanted) <= 1e-12 * std::abs(wanted));
      }
    CHECK(volume(lift.supports) == volume(supports));
  }
}

TEST_CASE("paths of both kinds lead to the zeros that are known") {
  const PolynomialSystem simple{2, {(x - Rational(2)) * (y - Rational(3)), x * x * y + y - Rational(20)}};
  // x = 2: 5 y = 20; y = 3: 3 x² = 17.
  for (const PathStart start : {PathStart::mixed_cells, PathStart::total_degree}) {
    WorkCounters work;
    const FollowedSystem followed =
        follow_system_paths({simple, start, {}, 1, {}, [](std::string_view, double) {}}, work);
    CHECK(followed.ends.size() == (start == PathStart::mixed_cells ? 3U : 6U));
    CHECK(followed.jumps == 0);
    int regular = 0;
    for (const PathEnd& end : followed.ends) {
      if (end.kind != PathEnd::Kind::regular) continue;
      ++regular;
      const bool first = std::abs(end.x[0] - 2.0) < 1e-9 && std::abs(end.x[1] - 4.0) < 1e-9;
      const bool second = std::abs(end.x[1] - 3.0) < 1e-9 && std::abs(end.x[0] * end.x[0] - 17.0 / 3) < 1e-9;
      CHECK((first || second));
    }
    CHECK(regular == 3);
    CHECK(std::ranges::all_of(followed.ends, [](const PathEnd& end) {
      return end.kind == PathEnd::Kind::regular || end.kind == PathEnd::Kind::at_infinity;
    }));
  }
}
