/// Legs that other processes follow, here by messages alone, within one; and the stream of lists in which they do.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/homotopies/leg_member.hpp"
#include "solvers/homotopies/leg_message.hpp"
#include "solvers/homotopies/leg_stream.hpp"
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

/// Of triangles whose second point passes the first one, two of three times so near that doubles lose some of the third ones,
/// which are far away then.
Task<SquareSystem> losing_task(int legs) {
  const Scene scene(samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {2, std::sqrt(2), std::sqrt(1.5)}));
  Task<SquareSystem> task{square_system(DistanceSystem(scene)), {}, {}};
  for (int i = 0; i < legs; ++i) {
    const std::complex<double> beside(-4, i % 3 == 0 ? 0.3 : 1e-14 * (1 + i));
    task.starts.push_back({2, 1.125, std::sqrt(2 - 1.125 * 1.125)});
    task.routes.push_back(straight({4, 2, 1.5}, {beside, 2, 1.5}));
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

void check_same(const std::vector<LegResult>& a, const std::vector<LegResult>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) check_same(a[i], b[i]);
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
    check_same(results, expected);
    CHECK(work.iterations == work_of_crew.iterations);
    CHECK(work.rejected_steps == work_of_crew.rejected_steps);
    CHECK(work.evaluations == work_of_crew.evaluations);
  }
}

/// Of a stream that has one list.
FollowedLegs only_list(LegStream& stream) {
  while (true)
    for (FollowedList& list : stream.advance()) return std::move(list.legs);
}

/// The i-th list of legs has i of them.
std::vector<std::vector<Leg>> lists_of(const Task<SquareSystem>& task, std::size_t count) {
  std::vector<std::vector<Leg>> lists;
  const std::vector<Leg> legs = task.legs();
  for (std::size_t i = 1, first = 0; i <= count; first += i++)
    lists.emplace_back(legs.begin() + static_cast<std::ptrdiff_t>(first),
                       legs.begin() + static_cast<std::ptrdiff_t>(first + i));
  return lists;
}

void check_same(const FollowedLegs& a, const FollowedLegs& b) {
  check_same(a.results, b.results);
  CHECK(a.work.accepted == b.work.accepted);
  CHECK(a.work.rejected == b.work.rejected);
  CHECK(a.work.evaluations == b.work.evaluations);
}

/// One stream for `count` lists beside one for each alone, on several numbers of threads.
void check_lists(const Task<SquareSystem>& task, std::size_t count) {
  std::mt19937_64 random(38);
  const Elimination elimination = order_elimination(task.system, random);
  const std::vector<std::vector<Leg>> lists = lists_of(task, count);
  const auto alone = make_leg_stream(task.system, elimination, {{}, widest_instruction_set(), 1});
  std::vector<FollowedLegs> expected;
  for (std::size_t i = 0; i < count; ++i) {
    alone->add(i, lists[i]);
    expected.push_back(only_list(*alone));
    for (const LegResult& result : expected.back().results) CHECK(result.state.end == LegEnd::arrived);
  }
  for (const int threads : {1, 3}) {
    const auto stream = make_leg_stream(task.system, elimination, {{}, widest_instruction_set(), threads});
    std::size_t added = 0, done = 0;
    while (added < count || !stream->is_idle()) {
      if (added < count) stream->add(added, lists[added]);
      added = std::min(added + 1, count);
      for (const FollowedList& list : stream->advance()) {
        check_same(list.legs, expected[list.number]);
        ++done;
      }
    }
    CHECK(done == count);
  }
}

}  // namespace

TEST_CASE("lists of one stream have the bits of each alone, on any number of threads") {
  std::mt19937_64 random(34);
  constexpr int count = 12;
  check_lists(square_task(count * (count + 1) / 2, random), count);
}

TEST_CASE("lists with legs that doubles lose have the bits of each alone") {
  constexpr int count = 6, legs = count * (count + 1) / 2;
  const Task<SquareSystem> task = losing_task(legs);
  std::mt19937_64 random(39);
  WorkCounters work;
  const Elimination elimination = order_elimination(task.system, random);
  LegTracking tracking(task.system, elimination, {{}, widest_instruction_set(), 1});
  tracking.follow(task.legs(), is_stopped, work);
  // Each way in which a leg is followed has two evaluations more than steps.
  CHECK(work.evaluations > work.iterations + work.rejected_steps + 2 * legs);
  check_lists(task, count);
}

TEST_CASE("lists that are given up keep what is followed, and leave nothing behind") {
  std::mt19937_64 random(35);
  const Task<SquareSystem> task = square_task(64, random);
  const Elimination elimination = order_elimination(task.system, random);
  const auto stream = make_leg_stream(task.system, elimination, {{}, widest_instruction_set(), 1});
  stream->add(0, task.legs());
  const FollowedLegs whole = only_list(*stream);
  stream->add(1, task.legs());
  for (int i = 0; i < 2; ++i) CHECK(stream->advance().empty());
  const FollowedLegs part = stream->give_up().at(0).legs;
  CHECK(stream->is_idle());
  REQUIRE(part.results.size() == whole.results.size());
  int followed = 0;
  for (std::size_t i = 0; i < part.results.size(); ++i) {
    if (part.results[i].state.end == LegEnd::arrived) {
      check_same(part.results[i], whole.results[i]);
      ++followed;
    } else {
      CHECK(part.results[i].state.end == LegEnd::too_many);
      CHECK(part.results[i].state.s == 0);
    }
  }
  CHECK(followed > 0);
  CHECK(followed < static_cast<int>(part.results.size()));
  stream->add(2, task.legs());
  check_same(only_list(*stream), whole);
}

TEST_CASE("legs that a crew follows have the same bits and count the same work") {
  std::mt19937_64 random(31);
  const Task<SquareSystem> squares = square_task(200, random);
  check_crew(squares, order_elimination(squares.system, random));
  const Task<SquareSystem> losing = losing_task(100);
  check_crew(losing, order_elimination(losing.system, random));
  const Task<MonomialSystem> monomials = monomial_task(150, random);
  std::vector<ComplexVectorX> jacobians;
  for (int i = 0; i < 3; ++i)
    jacobians.push_back(jacobian_at(monomials.system, monomials.routes[i].end, monomials.starts[i]));
  check_crew(monomials, order_elimination(monomials.system, jacobians));
}

TEST_CASE("blocks that are followed side by side have the bits of each alone, in the order of their adding") {
  std::mt19937_64 random(36);
  constexpr std::size_t count = 9;
  const Task<SquareSystem> task = square_task(count * (count + 1) / 2, random);
  const Elimination elimination = order_elimination(task.system, random);
  const std::vector<std::vector<Leg>> blocks = lists_of(task, count);
  WorkCounters work;
  LegTracking alone(task.system, elimination, {{}, widest_instruction_set(), 1});
  FakeCrew crew(begin_legs);
  for (const bool has_crew : {false, true}) {
    for (const int threads : {1, 3}) {
      TrackingSetup setup{{}, widest_instruction_set(), threads};
      if (has_crew) setup.crew = &crew;
      LegTracking tracking(task.system, elimination, setup);
      for (std::size_t added = 0, taken = 0; taken < count; ++taken) {
        for (; added < std::min(taken + 3, count); ++added) {
          const Task<SquareSystem> brief = task;  // what legs refer to is copied
          tracking.add(std::span<const Leg>(lists_of(brief, count)[added]));
        }
        check_same(tracking.take(is_stopped, work), alone.follow(blocks[taken], is_stopped, work));
      }
    }
  }
}

TEST_CASE("blocks that are given up leave nothing to those that come after") {
  std::mt19937_64 random(37);
  const Task<SquareSystem> task = square_task(40, random);
  const Elimination elimination = order_elimination(task.system, random);
  WorkCounters work;
  LegTracking tracking(task.system, elimination, {{}, widest_instruction_set(), 2});
  const std::vector<LegResult> expected = tracking.follow(task.legs(), is_stopped, work);
  for (int i = 0; i < 3; ++i) tracking.add(task.legs());
  tracking.take(is_stopped, work);
  bool is_late = false;
  const auto stops = [&] { return std::exchange(is_late, true); };
  const std::vector<LegResult> part = tracking.take(stops, work);
  REQUIRE(part.size() == expected.size());
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i].state.end == LegEnd::arrived)
      check_same(part[i], expected[i]);
    else
      CHECK(part[i].state.s == 0);
  }
  tracking.give_up();
  check_same(tracking.follow(task.legs(), is_stopped, work), expected);
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
  const std::unique_ptr<ItemWork> member = begin_legs(whole);
  std::string result;
  for (member->add({0, legs}); !member->is_idle();)
    for (const NumberedItem& done : member->advance()) result = done.bytes;
  for (const std::size_t part : {1, 3, 10}) {
    CHECK_THROWS_AS(begin_legs(whole.substr(0, whole.size() - part)), std::invalid_argument);
    CHECK_THROWS_AS(member->add({0, legs.substr(0, legs.size() - part)}), std::invalid_argument);
    CHECK_THROWS_AS(read_followed(std::string_view(result).substr(0, result.size() - part)),
                    std::invalid_argument);
  }
}
