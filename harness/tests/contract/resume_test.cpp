/// Every strategy that keeps a journal: an interrupted solve goes on where it stopped, with the same result.

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tests/contract/report_difference.hpp"
#include "harness/tests/contract/strategy_contract.hpp"
#include "harness/tests/memory_journal.hpp"

using namespace gcs;
using namespace gcs::contract;

namespace {

SolveReport solve_with(const Subject& subject, const Scene& scene, Journal* journal, int threads = 1,
                       std::stop_token stop = {}) {
  return solve_anew(subject, {scene, {.threads = threads, .stop = std::move(stop), .journal = journal}});
}

void check_same(const SolveReport& a, const SolveReport& b) {
  const auto difference = first_difference(a, b);
  INFO(difference.value_or(""));
  CHECK_FALSE(difference);
}

/// Stops after `steps` of `all` steps and goes on.
void check_interrupted(const Subject& subject, const Scene& scene, const SolveReport& whole,
                       std::size_t steps, std::size_t all) {
  INFO("interrupted after step " << steps << " of " << all);
  MemoryJournal journal;
  std::stop_source stop;
  if (steps == 0) stop.request_stop();
  journal.stop_at(steps, stop);
  const SolveReport interrupted = solve_with(subject, scene, &journal, 1, stop.get_token());
  CHECK(interrupted.status == SolveStatus::stopped);
  REQUIRE(journal.records().size() == steps);
  MemoryJournal rest(journal.records());
  check_same(whole, solve_with(subject, scene, &rest, 2));
  CHECK(rest.computed() == all - steps);
}

void check_resuming(const Subject& subject, const Scene& scene) {
  MemoryJournal journal;
  const SolveReport whole = solve_with(subject, scene, nullptr);
  check_same(whole, solve_with(subject, scene, &journal));
  const std::size_t all = journal.records().size();
  REQUIRE(all > 0);
  for (const std::size_t steps : std::set<std::size_t>{0, all / 4, all / 2, all - 1})
    check_interrupted(subject, scene, whole, steps, all);
  MemoryJournal finished(journal.records());
  check_same(whole, solve_with(subject, scene, &finished));
  CHECK(finished.computed() == 0);
}

}  // namespace

TEST_CASE("an interrupted solve goes on where it stopped, with the same bits") {
  int checked = 0;
  for (const std::string id : {"k33", "octahedron", "g16a"}) {
    const Scene scene(load_instance(id).problem);
    for (const StrategyEntry& entry : all_strategies()) {
      const Subject subject{entry};
      if (!entry.keeps_journal || !supports(subject, scene)) continue;
      INFO(subject.label() << " on " << id);
      check_resuming(subject, scene);
      ++checked;
    }
  }
  CHECK(checked > 0);
}

TEST_CASE("a stop while steps are recalled asks for no other step") {
  const Scene scene(load_instance("octahedron").problem);
  for (const StrategyEntry& entry : all_strategies()) {
    const Subject subject{entry};
    if (!entry.keeps_journal || !supports(subject, scene)) continue;
    MemoryJournal journal;
    solve_with(subject, scene, &journal);
    std::stop_source stop;
    stop.request_stop();
    MemoryJournal replayed(journal.records());
    CHECK(solve_with(subject, scene, &replayed, 1, stop.get_token()).status == SolveStatus::stopped);
    CHECK(replayed.records() == journal.records());
  }
}
