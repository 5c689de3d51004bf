/// Legs that other processes follow: here by messages alone, within one.

#include <catch2/catch.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/homotopies/leg_member.hpp"
#include "solvers/homotopies/leg_message.hpp"
#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/tests/fake_crew.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

bool is_stopped() { return false; }

/// From zeros at random parameters to others.
template <class System>
struct Task {
  System system;
  std::vector<ComplexVectorX> starts;
  std::vector<Route> routes;

  std::vector<Leg> legs() const {
    std::vector<Leg> result;
    for (std::size_t i = 0; i < starts.size(); ++i) result.push_back({starts[i].data(), &routes[i]});
    return result;
  }
};

Route straight(const ComplexVectorX& from, const ComplexVectorX& to) {
  Route route;
  route.end = to;
  for (std::size_t i = 0; i < from.size(); ++i) {
    route.coefficients[0].push_back(from[i]);
    route.coefficients[1].push_back(to[i] - from[i]);
  }
  for (const int k : {2, 3}) route.coefficients[k].resize(from.size());
  return route;
}

Task<SquareSystem> square_task(int legs, std::mt19937_64& random) {
  const Scene scene(samples::octahedron());
  Task<SquareSystem> task{square_system(DistanceSystem(scene)), {}, {}};
  for (int i = 0; i < legs; ++i) {
    task.starts.push_back(random_complex_vector(task.system.unknowns, random));
    const ComplexVectorX target = random_complex_vector(task.system.equations(), random);
    task.routes.push_back(straight(squares_at(task.system, task.starts.back()), target));
  }
  return task;
}

/// Coefficients such that each start is a zero of x_u·x_v + c.
Task<MonomialSystem> monomial_task(int legs, std::mt19937_64& random) {
  Task<MonomialSystem> task;
  task.system.unknowns = 3;
  for (int e = 0; e < 3; ++e) {
    task.system.monomials.push_back({e, (e + 1) % 3});
    task.system.monomials.push_back({e, -1});
    task.system.monomials.push_back({-1, -1});
    task.system.first.push_back(3 * (e + 1));
  }
  const auto coefficients_at = [&](const ComplexVectorX& x) {
    ComplexVectorX c = random_complex_vector(9, random);
    for (int e = 0; e < 3; ++e) c[3 * e + 2] = -(c[3 * e] * x[e] * x[(e + 1) % 3] + c[3 * e + 1] * x[e]);
    return c;
  };
  for (int i = 0; i < legs; ++i) {
    task.starts.push_back(random_complex_vector(3, random));
    const ComplexVectorX from = coefficients_at(task.starts.back());
    task.routes.push_back(straight(from, random_complex_vector(9, random)));
  }
  return task;
}

void check_same(const LegResult& a, const LegResult& b) {
  CHECK(a.x == b.x);
  CHECK(a.state.end == b.state.end);
  CHECK(a.state.steps == b.state.steps);
  CHECK(a.state.last_correction == b.state.last_correction);
}

template <class System>
void check_crew(const Task<System>& task, const Elimination& elimination) {
  for (const bool all_wide : {false, true}) {
    TrackingSetup setup{{}, widest_instruction_set(), 1, nullptr, all_wide};
    WorkCounters work, work_of_crew;
    LegTracking alone(task.system, elimination, setup);
    FakeCrew crew(begin_legs);
    setup.crew = &crew;
    LegTracking together(task.system, elimination, setup);
    const std::vector<LegResult> expected = alone.follow(task.legs(), is_stopped, work);
    const std::vector<LegResult> results = together.follow(task.legs(), is_stopped, work_of_crew);
    CHECK(crew.handed_out > 0);
    REQUIRE(results.size() == expected.size());
    for (std::size_t i = 0; i < results.size(); ++i) check_same(results[i], expected[i]);
    CHECK(work.iterations == work_of_crew.iterations);
    CHECK(work.rejected_steps == work_of_crew.rejected_steps);
    CHECK(work.evaluations == work_of_crew.evaluations);
  }
}

}  // namespace

TEST_CASE("legs that a crew follows have the same bits and count the same work") {
  std::mt19937_64 random(31);
  const Task<SquareSystem> squares = square_task(200, random);
  check_crew(squares, order_elimination(squares.system, random));
  const Task<MonomialSystem> monomials = monomial_task(150, random);
  std::vector<ComplexVectorX> jacobians;
  for (int i = 0; i < 3; ++i)
    jacobians.push_back(jacobian_at(monomials.system, monomials.routes[i].end, monomials.starts[i]));
  check_crew(monomials, order_elimination(monomials.system, jacobians));
}

TEST_CASE("what a crew was stopped before is not followed") {
  std::mt19937_64 random(32);
  const Task<SquareSystem> task = square_task(200, random);
  const Elimination elimination = order_elimination(task.system, random);
  FakeCrew crew(begin_legs);
  TrackingSetup setup{{}, widest_instruction_set(), 1};
  setup.crew = &crew;
  LegTracking tracking(task.system, elimination, setup);
  WorkCounters work;
  const std::vector<LegResult> results = tracking.follow(
      task.legs(), [] { return true; }, work);
  REQUIRE(results.size() == 200);
  for (const LegResult& result : results) {
    CHECK(result.state.end == LegEnd::too_many);
    CHECK(result.state.s == 0);
  }
}

TEST_CASE("messages that end early are refused") {
  std::mt19937_64 random(33);
  const Task<SquareSystem> task = square_task(3, random);
  const Elimination elimination = order_elimination(task.system, random);
  const std::string whole =
      to_message(LegTask{task.system, elimination, {}, InstructionSet::portable, 1, false});
  const std::string legs = to_message(task.legs(), task.system.unknowns);
  const ItemWork member = begin_legs(whole);
  const std::string result = member(legs);
  for (const std::size_t part : {1, 3, 10}) {
    CHECK_THROWS_AS(begin_legs(whole.substr(0, whole.size() - part)), std::invalid_argument);
    CHECK_THROWS_AS(member(legs.substr(0, legs.size() - part)), std::invalid_argument);
    CHECK_THROWS_AS(read_followed(std::string_view(result).substr(0, result.size() - part)),
                    std::invalid_argument);
  }
}
