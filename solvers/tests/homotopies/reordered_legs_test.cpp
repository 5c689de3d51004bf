/// Paths on which a pivot of the elimination that all paths share vanishes, though no Jacobian is singular.

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/homotopies/leg_tracking.hpp"

using namespace gcs;

namespace {

template <class System>
LegResult followed(const System& system, const Elimination& elimination, const ComplexVectorX& start,
                   const Route& route) {
  LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
  const std::vector<Leg> legs{{start.data(), &route}};
  WorkCounters work;
  return tracking
      .follow(
          legs, [] { return false; }, work)
      .front();
}

bool begins_with_the_first(const Elimination& elimination) {
  return elimination.equation.front() == 0 && elimination.unknown.front() == 0;
}

void check_end(const LegResult& result, const ComplexVectorX& end) {
  CHECK(result.state.end == LegEnd::arrived);
  REQUIRE(result.x.size() == end.size());
  for (std::size_t i = 0; i < end.size(); ++i) CHECK(std::abs(result.x[i] - end[i]) <= 1e-14);
}

}  // namespace

// u² + v² = (1 + s)², u + 2v = 2 + 2s
TEST_CASE("a path along which a coordinate is 0 arrives, though its derivative was to be a pivot") {
  SquareSystem system;
  system.unknowns = 2;
  system.add_equation({{0}, {1}}, {}, 0);
  system.add_equation({}, {{0, 1.0}, {1, 2.0}}, 0);
  const Elimination elimination = order_elimination_at(system, {}, {10, 0.1});
  REQUIRE(begins_with_the_first(elimination));
  const Route route{{{{1, 2}, {2, 2}, {1, 0}, {0, 0}}}, {4, 4}};
  check_end(followed(system, elimination, {0, 1}, route), {0, 2});
}

// a·x + y = p, x + y/2 = q, with a = 0
TEST_CASE("a path with a coefficient that is 0 arrives, though it was to be a pivot") {
  const MonomialSystem system{2, {{0, -1}, {1, -1}, {-1, -1}, {0, -1}, {1, -1}, {-1, -1}}, {0, 3, 6}};
  const Elimination elimination = order_elimination_at(system, {1, 0.5, 0, 0.5, 0.6, 0}, {1, 1});
  REQUIRE(begins_with_the_first(elimination));
  const ComplexVectorX rest(6, 0);
  const Route route{{{{0, 1, -3, 1, 0.5, -2}, {0, 0, -4, 0, 0, -1}, rest, rest}}, {0, 1, -7, 1, 0.5, -3}};
  check_end(followed(system, elimination, {0.5, 3}, route), {-0.5, 7});
}

TEST_CASE("a path through a singular point is lost for any pivots") {
  SquareSystem system;
  system.unknowns = 1;
  system.add_equation({{0}}, {}, 0);
  const Elimination elimination = order_elimination_at(system, {}, {1});
  const Route route{{{{1}, {-2}, {0}, {0}}}, {-1}};
  const LegResult result = followed(system, elimination, {1}, route);
  CHECK(result.state.end == LegEnd::too_small);
  CHECK(std::abs(result.state.s - 0.5) <= 1e-6);
}

TEST_CASE("the parameters on a way are those of its sum, or of its powers") {
  const Route sum{{{{1, 2}, {3, 0}, {5, 0}, {7, 0}}}, {16, 2}};
  CHECK(parameters_at(sum, 0.5) == ComplexVectorX{1 + 1.5 + 1.25 + 0.875, 2});
  const Route powers{{{{3}, {0}, {0}, {0}}}, {3}, {2}};
  CHECK(std::abs(parameters_at(powers, 0.25).front() - 3 * std::exp(-1.5)) <= 1e-15);
}
