#include "solvers/homotopies/leg_tracking.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <span>

#include "solvers/model/distance_system.hpp"
#include "solvers/tests/available_sets.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/sanitized.hpp"

using namespace gcs;

namespace {

const auto never = [] { return false; };

SquareSystem system_of(const ProblemStatement& problem) {
  const Scene scene(problem);
  return square_system(DistanceSystem(scene));
}

std::vector<SquareSystem> systems() {
  samples::RandomNumbers random(5);
  std::vector<SquareSystem> result{system_of(samples::k33()), system_of(samples::octahedron())};
  for (const int dimension : {2, 3})
    result.push_back(system_of(samples::random_problem(dimension, 7, random)));
  return result;
}

Eigen::VectorXcd value_at(const SquareSystem& system, const Eigen::VectorXcd& x,
                          const Eigen::VectorXcd& squares) {
  Eigen::VectorXcd value = -squares;
  for (int e = 0; e < system.equations(); ++e) {
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      const std::complex<double> difference = x[minuend] - (subtrahend < 0 ? constant : x[subtrahend]);
      value[e] += difference * difference;
    }
    value[e] += system.given[e];
  }
  return value;
}

Eigen::VectorXcd value_at(const MonomialSystem& system, const Eigen::VectorXcd& x,
                          const Eigen::VectorXcd& coefficients) {
  const ComplexVectorX value =
      values_at(system, {coefficients.begin(), coefficients.end()}, {x.begin(), x.end()}).value;
  return Eigen::Map<const Eigen::VectorXcd>(value.data(), system.unknowns);
}

Eigen::VectorXcd parameters_on(const Route& route, double s) {
  Eigen::VectorXcd parameters(static_cast<Eigen::Index>(route.end.size()));
  for (Eigen::Index e = 0; e < parameters.size(); ++e) {
    const auto& c = route.coefficients;
    parameters[e] = c[0][e] + s * (c[1][e] + s * (c[2][e] + s * c[3][e]));
  }
  return parameters;
}

/// Newton's method at every one of many small steps, with pivoting: slow and obviously right. Values are quadratic, so that
/// central differences are their derivatives but for rounding.
template <class System>
Eigen::VectorXcd follow_slowly(const System& system, const ComplexVectorX& start, const Route& route) {
  constexpr int steps = 4000;
  const int n = system.unknowns;
  Eigen::VectorXcd x = Eigen::Map<const Eigen::VectorXcd>(start.data(), n);
  for (int step = 1; step <= steps; ++step) {
    const Eigen::VectorXcd parameters = parameters_on(route, static_cast<double>(step) / steps);
    for (int i = 0; i < 3; ++i) {
      Eigen::MatrixXcd jacobian(n, n);
      for (int column = 0; column < n; ++column) {
        Eigen::VectorXcd ahead = x, behind = x;
        ahead[column] += 1;
        behind[column] -= 1;
        jacobian.col(column) =
            (value_at(system, ahead, parameters) - value_at(system, behind, parameters)) / 2;
      }
      x -= jacobian.partialPivLu().solve(value_at(system, x, parameters));
    }
  }
  return x;
}

/// From the lengths of `start` along a random cubic.
Route random_route(const SquareSystem& system, const ComplexVectorX& start, std::mt19937_64& random) {
  Route route;
  route.coefficients[0] = squares_at(system, start);
  route.end = route.coefficients[0];
  for (int k = 1; k <= Route::degree; ++k) {
    route.coefficients[k] = random_complex_vector(system.equations(), random);
    for (std::size_t e = 0; e < route.end.size(); ++e) route.end[e] += route.coefficients[k][e];
  }
  return route;
}

Route reversed(const Route& route) {
  Route back;
  for (std::size_t e = 0; e < route.end.size(); ++e) {
    const auto& c = route.coefficients;
    back.coefficients[0].push_back(c[0][e] + c[1][e] + c[2][e] + c[3][e]);
    back.coefficients[1].push_back(-c[1][e] - 2.0 * c[2][e] - 3.0 * c[3][e]);
    back.coefficients[2].push_back(c[2][e] + 3.0 * c[3][e]);
    back.coefficients[3].push_back(-c[3][e]);
  }
  back.end = route.coefficients[0];
  return back;
}

/// Random starts and a route for each.
struct Task {
  std::vector<ComplexVectorX> starts;
  std::vector<Route> routes;

  Task(const SquareSystem& system, int count, std::mt19937_64& random) {
    for (int i = 0; i < count; ++i) {
      starts.push_back(random_complex_vector(system.unknowns, random));
      routes.push_back(random_route(system, starts.back(), random));
    }
  }

  std::vector<Leg> legs() const {
    std::vector<Leg> result;
    for (std::size_t i = 0; i < starts.size(); ++i) result.push_back({starts[i].data(), &routes[i]});
    return result;
  }
};

/// Every equation is in all monomials of degree two at most.
MonomialSystem full_quadrics(int unknowns) {
  MonomialSystem system{unknowns, {}, {0}};
  for (int e = 0; e < unknowns; ++e) {
    for (int u = -1; u < unknowns; ++u)
      for (int v = -1; v <= u; ++v) system.monomials.push_back({u, v});
    system.first.push_back(static_cast<int>(system.monomials.size()));
  }
  return system;
}

/// From coefficients of which `start` is a zero; each `resting`-th one stays what it is.
Route random_route(const MonomialSystem& system, const ComplexVectorX& start, std::size_t resting,
                   std::mt19937_64& random) {
  Route route;
  const std::size_t count = system.monomials.size();
  for (auto& coefficients : route.coefficients)
    coefficients = random_complex_vector(static_cast<int>(count), random);
  const std::vector<std::complex<double>> missing = values_at(system, route.coefficients[0], start).value;
  for (int e = 0; e < system.equations(); ++e) route.coefficients[0][system.first[e]] -= missing[e];
  for (std::size_t j = 0; j < count; j += resting)
    for (int k = 1; k <= Route::degree; ++k) route.coefficients[k][j] = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const auto& c = route.coefficients;
    route.end.push_back(c[0][j] + c[1][j] + c[2][j] + c[3][j]);
  }
  return route;
}

/// p2 passes p1, `beside` it by so much; near it p3 goes far away, and its distance is lost between the squares of its
/// coordinates; before, p3 nearly meets its mirror image.
struct Passing {
  SquareSystem system =
      system_of(samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {2, std::sqrt(2), std::sqrt(1.5)}));
  ComplexVectorX start{2, 1.125, std::sqrt(2 - 1.125 * 1.125)};
  Route route;

  explicit Passing(double beside) {
    route.coefficients = {ComplexVectorX{4, 2, 1.5}, ComplexVectorX{{-8, beside}, 0, 0}, ComplexVectorX(3),
                          ComplexVectorX(3)};
    route.end = {{-4, beside}, 2, 1.5};
  }
  Leg leg() const { return {start.data(), &route}; }
};

/// By one lane of a tracker.
LegResult follow_alone(LaneTracker& tracker, const Leg& leg, int unknowns) {
  tracker.load(0, leg);
  while (tracker.is_busy(0)) tracker.step();
  LegResult result{tracker.state(0), ComplexVectorX(static_cast<std::size_t>(unknowns))};
  tracker.read(0, result.x.data());
  return result;
}

}  // namespace

TEST_CASE("legs of equations that share monomials end where many small steps end, though coefficients rest") {
  std::mt19937_64 random(13);
  const MonomialSystem system = full_quadrics(3);
  CHECK(monomial_sums(system).sums.size() == 10);
  // Those that rest along the first leg move along later ones, and rest again.
  std::vector<ComplexVectorX> starts, jacobians;
  std::vector<Route> routes;
  for (const std::size_t resting : {2U, 1000U, 3U, 2U}) {
    starts.push_back(random_complex_vector(3, random));
    routes.push_back(random_route(system, starts.back(), resting, random));
    jacobians.push_back(jacobian_at(system, routes.back().end, starts.back()));
  }
  const Elimination elimination = order_elimination(system, jacobians);
  LegTracking tracking(system, elimination, {{}, InstructionSet::portable, 1});
  for (std::size_t i = 0; i < starts.size(); ++i) {
    WorkCounters work;
    const std::vector<Leg> legs{{starts[i].data(), &routes[i]}};
    const LegResult result = tracking.follow(legs, never, work).front();
    REQUIRE(result.state.end == LegEnd::arrived);
    const Eigen::VectorXcd slow = follow_slowly(system, starts[i], routes[i]);
    const Eigen::Map<const Eigen::VectorXcd> fast(result.x.data(), 3);
    CHECK((fast - slow).cwiseAbs().maxCoeff() <= 1e-9 * (1 + slow.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("monomials that share a coefficient are followed as without saying so") {
  std::mt19937_64 random(14);
  MonomialSystem system = full_quadrics(3);
  const ComplexVectorX start = random_complex_vector(3, random);
  // Of ten monomials the first, 1, is alone; the others are three sums of three, which all equations have.
  for (const int first : system.first)
    for (int i = 0; i < 10 && first < std::ssize(system.monomials); ++i)
      system.shares.push_back(first + (i == 0 ? 0 : i - (i - 1) % 3));
  CHECK(monomial_sums(system).sums.size() == 4);
  Route route = random_route(system, start, 2, random);
  for (auto& coefficients : route.coefficients)
    for (std::size_t j = 0; j < coefficients.size(); ++j) coefficients[j] = coefficients[system.shares[j]];
  const ComplexVectorX missing = values_at(system, route.coefficients[0], start).value;
  for (int e = 0; e < system.equations(); ++e) route.coefficients[0][system.first[e]] -= missing[e];
  for (std::size_t j = 0; j < route.end.size(); ++j) {
    const auto& c = route.coefficients;
    route.end[j] = c[0][j] + c[1][j] + c[2][j] + c[3][j];
  }
  const Elimination elimination = order_elimination(system, {jacobian_at(system, route.end, start)});
  LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
  WorkCounters work;
  const std::vector<Leg> legs{{start.data(), &route}};
  const LegResult result = tracking.follow(legs, never, work).front();
  REQUIRE(result.state.end == LegEnd::arrived);
  const Eigen::VectorXcd slow = follow_slowly(system, start, route);
  const Eigen::Map<const Eigen::VectorXcd> fast(result.x.data(), 3);
  CHECK((fast - slow).cwiseAbs().maxCoeff() <= 1e-9 * (1 + slow.cwiseAbs().maxCoeff()));
}

TEST_CASE("where an unknown is 0 at all samples there is an entry for what it multiplies") {
  const MonomialSystem system{2, {{0, 1}, {0, -1}, {-1, -1}, {1, -1}, {-1, -1}}, {0, 3, 5}};
  const ComplexVectorX jacobian = jacobian_at(system, {1, 1, 0, 1, -1}, {0, 1});
  CHECK(jacobian[1] == 0.0);
  const Elimination elimination = order_elimination(system, {jacobian});
  CHECK(elimination.entry(0, 1) >= 0);
  CHECK(elimination.entry(1, 0) < 0);
}

TEST_CASE("a leg ends where many small steps with a pivoting solver end") {
  std::mt19937_64 random(11);
  const std::vector<SquareSystem> all = systems();
  for (const SquareSystem& system : std::span(all).first<repetitions(4)>()) {
    const Elimination elimination = order_elimination(system, random);
    const Task task(system, 1, random);
    WorkCounters work;
    LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
    const std::vector<LegResult> results = tracking.follow(task.legs(), never, work);
    for (std::size_t i = 0; i < results.size(); ++i) {
      REQUIRE(results[i].state.end == LegEnd::arrived);
      const Eigen::VectorXcd slow = follow_slowly(system, task.starts[i], task.routes[i]);
      const Eigen::Map<const Eigen::VectorXcd> fast(results[i].x.data(), system.unknowns);
      CHECK((fast - slow).cwiseAbs().maxCoeff() <= 1e-9 * (1 + slow.cwiseAbs().maxCoeff()));
    }
  }
}

TEST_CASE("a leg followed back ends where it began") {
  std::mt19937_64 random(12);
  for (const SquareSystem& system : systems()) {
    const Elimination elimination = order_elimination(system, random);
    const Task task(system, 40, random);
    WorkCounters work;
    LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
    const std::vector<LegResult> there = tracking.follow(task.legs(), never, work);
    std::vector<Route> routes;
    for (const Route& route : task.routes) routes.push_back(reversed(route));
    std::vector<Leg> legs;
    for (std::size_t i = 0; i < there.size(); ++i) {
      REQUIRE(there[i].state.end == LegEnd::arrived);
      legs.push_back({there[i].x.data(), &routes[i]});
    }
    const std::vector<LegResult> back = tracking.follow(legs, never, work);
    for (std::size_t i = 0; i < back.size(); ++i) {
      REQUIRE(back[i].state.end == LegEnd::arrived);
      CHECK(distance(back[i].x, task.starts[i]) <= 1e-9);
    }
  }
}

TEST_CASE("the bits of a leg depend on no instruction set, thread or neighbour") {
  std::mt19937_64 random(13);
  const SquareSystem system = system_of(samples::octahedron());
  const Elimination elimination = order_elimination(system, random);
  const Task task(system, 21, random);
  WorkCounters work;
  for (const bool all_wide : {false, true}) {
    LegTracking alone(system, elimination, {{}, InstructionSet::portable, 1, nullptr, all_wide});
    std::vector<ComplexVectorX> expected;
    for (const Leg& leg : task.legs())
      expected.push_back(alone.follow(std::span(&leg, 1), never, work).front().x);
    for (const InstructionSet set : samples::available_sets()) {
      for (const int threads : {1, 2, 3}) {
        LegTracking tracking(system, elimination, {{}, set, threads, nullptr, all_wide});
        const std::vector<LegResult> results = tracking.follow(task.legs(), never, work);
        for (std::size_t i = 0; i < results.size(); ++i) CHECK(results[i].x == expected[i]);
      }
    }
  }
}

TEST_CASE("a path that nearly meets another one ends where many small steps end") {
  // p3 comes to within 1e-7 of the line through p1 and p2, where the Jacobian is nearly singular, and leaves.
  const SquareSystem system = system_of(samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {2, 1, 1}));
  std::mt19937_64 random(14);
  const Elimination elimination = order_elimination(system, random);
  const ComplexVectorX start{2, 1, 1};
  Route route;
  route.coefficients = {ComplexVectorX{4, 2, 2}, ComplexVectorX{0, {-2, 1e-7}, {-2, 1e-7}}, ComplexVectorX(3),
                        ComplexVectorX(3)};
  route.end = {4, {0, 1e-7}, {0, 1e-7}};
  WorkCounters work;
  LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
  const Leg leg{start.data(), &route};
  const LegResult result = tracking.follow(std::span(&leg, 1), never, work).front();
  REQUIRE(result.state.end == LegEnd::arrived);
  const Eigen::VectorXcd slow = follow_slowly(system, start, route);
  CHECK(std::abs(result.x[2] - slow[2]) <= 1e-9);
}

TEST_CASE("a path is followed where its steps are hardly longer than the rounding of s") {
  std::mt19937_64 random(20);
  // No branch point lies between the routes, whose ends differ by 0.05.
  const Passing wide_berth(0.05);
  const Eigen::VectorXcd slow = follow_slowly(wide_berth.system, wide_berth.start, wide_berth.route);
  for (const double beside : {1e-9, 1e-11, 1e-13}) {
    const Passing near(beside);
    const Elimination elimination = order_elimination(near.system, random);
    const auto tracker = make_wide_tracker(InstructionSet::portable, near.system, elimination, wide({}));
    const LegResult result = follow_alone(*tracker, near.leg(), 3);
    REQUIRE(result.state.end == LegEnd::arrived);
    const Eigen::Map<const Eigen::VectorXcd> end(result.x.data(), 3);
    CHECK((end - slow).cwiseAbs().maxCoeff() <= 0.1);
  }
}

TEST_CASE("a path that doubles lose goes on from there in twice the precision") {
  const Passing passing(1e-13);
  std::mt19937_64 random(14);
  const Elimination elimination = order_elimination(passing.system, random);
  const Leg leg = passing.leg();
  WorkCounters work;
  LegTracking tracking(passing.system, elimination, {{}, widest_instruction_set(), 1});
  const LegResult result = tracking.follow(std::span(&leg, 1), never, work).front();
  REQUIRE(result.state.end == LegEnd::arrived);

  const auto doubles = make_lane_tracker(InstructionSet::portable, passing.system, elimination, {});
  const auto wider = make_wide_tracker(InstructionSet::portable, passing.system, elimination, wide({}));
  const LegResult lost = follow_alone(*doubles, leg, 3), whole = follow_alone(*wider, leg, 3);
  REQUIRE(lost.state.end == LegEnd::too_small);
  const LegResult rest = follow_alone(*wider, {lost.x.data(), leg.route, 0, lost.state.s}, 3);
  CHECK(rest.x == result.x);
  CHECK(distance(result.x, whole.x) <= 1e-12);
  CHECK(rest.state.steps < whole.state.steps / 2);
  CHECK(result.state.steps == lost.state.steps + rest.state.steps);
  CHECK(work.iterations + work.rejected_steps == result.state.steps);
}

TEST_CASE("a leg begins on its way where its start tells its path") {
  std::mt19937_64 random(18);
  const SquareSystem system = system_of(samples::k33());
  const Elimination elimination = order_elimination(system, random);
  const Task task(system, 10, random);
  const auto tracker = make_lane_tracker(InstructionSet::portable, system, elimination, {});
  for (std::size_t i = 0; i < task.starts.size(); ++i) {
    const Leg whole{task.starts[i].data(), &task.routes[i]};
    const LegResult end = follow_alone(*tracker, whole, system.unknowns);
    REQUIRE(end.state.end == LegEnd::arrived);
    // Backwards from its end to the half of its way.
    Route half = reversed(task.routes[i]);
    for (int k = 1; k <= Route::degree; ++k)
      for (std::complex<double>& coefficient : half.coefficients[k]) coefficient *= std::pow(0.5, k);
    for (std::size_t e = 0; e < half.end.size(); ++e) {
      half.end[e] = 0;
      for (const ComplexVectorX& coefficients : half.coefficients) half.end[e] += coefficients[e];
    }
    const LegResult middle = follow_alone(*tracker, {end.x.data(), &half}, system.unknowns);
    REQUIRE(middle.state.end == LegEnd::arrived);
    ComplexVectorX near = middle.x, astray = middle.x;
    near[0] += 1e-9;
    astray[0] += 0.1;
    const LegResult rest = follow_alone(*tracker, {near.data(), whole.route, 0, 0.5}, system.unknowns);
    REQUIRE(rest.state.end == LegEnd::arrived);
    CHECK(distance(rest.x, end.x) <= 1e-9);
    const LegResult refused = follow_alone(*tracker, {astray.data(), whole.route, 0, 0.5}, system.unknowns);
    CHECK(refused.state.end == LegEnd::too_small);
    CHECK(refused.state.s == 0.5);
    CHECK(refused.state.steps == 0);
  }
}

TEST_CASE("ends that Newton's method settles are settled in doubles") {
  std::mt19937_64 random(19);
  const SquareSystem system = system_of(samples::octahedron());
  const Elimination elimination = order_elimination(system, random);
  const Task task(system, 40, random);
  const auto tracker = make_lane_tracker(InstructionSet::portable, system, elimination, {});
  for (const Leg& leg : task.legs()) {
    const LegResult end = follow_alone(*tracker, leg, system.unknowns);
    REQUIRE(end.state.end == LegEnd::arrived);
    CHECK(end.state.is_settled());
  }
}

TEST_CASE("results of legs survive as a block of a journal") {
  std::mt19937_64 random(16);
  const SquareSystem system = system_of(samples::octahedron());
  const Elimination elimination = order_elimination(system, random);
  const Task task(system, 5, random);
  std::vector<Leg> legs = task.legs();
  legs[2].shortest_step = 0.9;
  WorkCounters work;
  LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
  const FollowedLegs followed{tracking.follow(legs, never, work), {7, 8, 9}};
  const FollowedLegs read = from_block(to_block(followed));
  CHECK(read.work.accepted == 7);
  CHECK(read.work.rejected == 8);
  CHECK(read.work.evaluations == 9);
  REQUIRE(read.results.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const LegState &ours = followed.results[i].state, &theirs = read.results[i].state;
    CHECK(theirs.end == (i == 2 ? LegEnd::short_steps : LegEnd::arrived));
    CHECK(theirs.s == ours.s);
    CHECK(theirs.steps == ours.steps);
    CHECK(theirs.rejected == ours.rejected);
    CHECK(theirs.last_correction == ours.last_correction);
    CHECK(read.results[i].x == followed.results[i].x);
  }
  Journal::Block cut = to_block(followed);
  cut.pop_back();
  CHECK_THROWS_AS(from_block(cut), std::invalid_argument);
  CHECK_THROWS_AS(from_block({}), std::invalid_argument);
}

TEST_CASE("legs are known by their starts, routes, limits and number") {
  std::mt19937_64 random(17);
  const SquareSystem system = system_of(samples::k33());
  const int n = system.unknowns;
  const Task task(system, 3, random);
  const std::uint64_t known = fingerprint(task.legs(), n);
  CHECK(fingerprint(task.legs(), n) == known);
  Task other = task;
  other.starts[2][1] = {other.starts[2][1].real(), std::nextafter(other.starts[2][1].imag(), 9.0)};
  CHECK(fingerprint(other.legs(), n) != known);
  other = task;
  other.routes[1].coefficients[3][0] += 1e-3;
  CHECK(fingerprint(other.legs(), n) != known);
  std::vector<Leg> legs = task.legs();
  legs[0].shortest_step = 1e-3;
  CHECK(fingerprint(legs, n) != known);
  legs = task.legs();
  std::swap(legs[0], legs[1]);
  CHECK(fingerprint(legs, n) != known);
  legs.pop_back();
  CHECK(fingerprint(legs, n) != known);
}

TEST_CASE("a leg is given up where its steps become too short for it") {
  std::mt19937_64 random(15);
  const SquareSystem system = system_of(samples::octahedron());
  const Elimination elimination = order_elimination(system, random);
  const Task task(system, 1, random);
  WorkCounters work;
  LegTracking tracking(system, elimination, {{}, widest_instruction_set(), 1});
  const Leg leg{task.starts[0].data(), &task.routes[0], 0.9};
  const LegResult result = tracking.follow(std::span(&leg, 1), never, work).front();
  CHECK(result.state.end == LegEnd::short_steps);
  CHECK(result.state.s < 1);
}
