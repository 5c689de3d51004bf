#include "solvers/polyhedral/eliminated_equations.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/homotopies/general_family.hpp"
#include "solvers/polyhedral/mixed_cells.hpp"
#include "solvers/polyhedral/polyhedral_homotopies.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;

namespace {

Natural mixed_volume(const Supports& supports) {
  const MixedCells cells = mixed_cells(supports, {1, 1, {}});
  REQUIRE(cells.status == MixedCellStatus::complete);
  return cells.total_volume();
}

/// In how many equations the first monomial of one occurs.
int occurrences(const Supports& supports, const Exponents& monomial) {
  return static_cast<int>(std::count_if(supports.begin(), supports.end(), [&](const Support& support) {
    return std::find(support.begin(), support.end(), monomial) != support.end();
  }));
}

}  // namespace

TEST_CASE("two circles become one and the line through their common points") {
  // x² + y² = 1 and x² + y² − x = 3
  const MonomialSystem system{2, {{0, 0}, {1, 1}, {}, {0, 0}, {1, 1}, {0, -1}, {}}, {0, 3, 7}};
  const auto [supports, coefficients] = eliminated_equations(system, {1, 1, -1, 1, 1, -1, -3});
  CHECK(supports == Supports{{{2, 0}, {0, 2}, {0, 0}}, {{1, 0}, {0, 0}}});
  CHECK(coefficients == ComplexVectorX{1, 1, -1, 1, 2});
}

TEST_CASE("what rounding leaves of a coefficient is no coefficient") {
  // The second equation less three times the first has no y², but 3·0.3 is not 0.9 in doubles.
  const MonomialSystem system{2, {{0, 0}, {1, 1}, {}, {0, 0}, {1, 1}, {0, -1}}, {0, 3, 6}};
  const Supports supports = eliminated_equations(system, {0.1, 0.3, -1, 0.3, 0.9, -1}).supports;
  CHECK(occurrences(supports, {0, 2}) == 1);
  CHECK(occurrences(supports, {2, 0}) == 1);
}

TEST_CASE("with constant terms mixed cells count zeros on the axes") {
  // x y = 0 and x + y = 1: (1, 0) and (0, 1), both outside of (C*)².
  const EliminatedEquations equations{{{{1, 1}}, {{1, 0}, {0, 1}, {0, 0}}}, {1, 1, 1, -1}};
  CHECK(mixed_volume(equations.supports) == Natural(0));
  const auto [supports, coefficients] = with_constant_terms(equations);
  CHECK(mixed_volume(supports) == Natural(2));
  CHECK(supports == Supports{{{1, 1}, {0, 0}}, {{1, 0}, {0, 1}, {0, 0}}});
  CHECK(coefficients == ComplexVectorX{1, 0, 1, 1, -1});
}

TEST_CASE("eliminated equations of a general scene have its zeros, and no more paths lead to them") {
  samples::RandomNumbers numbers(41);
  std::mt19937_64 random(42);
  for (const int planes : {1, 2, 3}) {
    const Scene scene = Scene::unchecked(samples::random_octahedral(planes, numbers));
    const SceneSystem scene_system(scene);
    const GeneralEquations equations = general_equations(scene_system);
    const FamilyMember member = random_member(equations, random);
    const auto [supports, coefficients] = eliminated_equations(equations.system, member.parameters);
    const EquationValues at_member = values_at(monomial_system(supports), coefficients, member.x);
    for (std::size_t e = 0; e < at_member.value.size(); ++e)
      CHECK(std::abs(at_member.value[e]) <= 1e-10 * at_member.size[e]);
    for (const Support& support : supports) CHECK(occurrences(supports, support.front()) == 1);
    const Natural volume = mixed_volume(supports);
    CHECK(volume <= mixed_volume(supports_of(equations.system)));
    CHECK(Natural(8) * Natural::power_of_two(equations.signs.rank()) <= volume);  // Bernshtein's bound
  }
}
