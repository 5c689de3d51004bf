#include "solvers/running/run_on_threads.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <vector>

using namespace gcs;

TEST_CASE("every number is called once, with more of them than cores too") {
  for (const int count : {0, 1, 2, 7, 500}) {
    std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
    run_on_threads(count, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
    for (const std::atomic<int>& number : calls) CHECK(number == 1);
  }
}

TEST_CASE("every item is taken once, by however many threads") {
  for (const std::size_t items : {0, 1, 5, 300})
    for (const int threads : {1, 2, 3, 50}) {
      std::vector<std::atomic<int>> calls(items);
      share_on_threads(items, threads, [&](std::size_t i) { ++calls[i]; });
      for (const std::atomic<int>& number : calls) CHECK(number == 1);
    }
}

TEST_CASE("parallel loops may be started within one another") {
  std::atomic<int> calls = 0;
  run_on_threads(3, [&](int) { run_on_threads(4, [&](int) { ++calls; }); });
  CHECK(calls == 12);
}
