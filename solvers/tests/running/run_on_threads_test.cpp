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

TEST_CASE("parallel loops may be started within one another") {
  std::atomic<int> calls = 0;
  run_on_threads(3, [&](int) { run_on_threads(4, [&](int) { ++calls; }); });
  CHECK(calls == 12);
}
