#include "solvers/running/run_on_threads.hpp"

#include <arb.h>

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

TEST_CASE("functions run in the background while the caller goes on, and again after that") {
  constexpr int most = 3;
  std::vector<std::atomic<int>> calls(most);
  {
    Background background(most);
    background.wait();
    for (int round = 1; round <= 20; ++round) {
      for (int i = 0; i < most; ++i) background.run(i, [&calls, i] { ++calls[static_cast<std::size_t>(i)]; });
      if (round % 2 == 0) continue;
      background.wait();
      for (const std::atomic<int>& number : calls) CHECK(number == round);
    }
  }
  for (const std::atomic<int>& number : calls) CHECK(number == 20);
}

TEST_CASE("what Arb keeps for a thread is freed before the thread ends, or the address sanitizer tells") {
  std::atomic<int> precise = 0;
  run_on_threads(4, [&](int) {
    constexpr slong bits = 1000;
    arb_t pi;
    arb_init(pi);
    arb_const_pi(pi, bits);
    if (arb_rel_accuracy_bits(pi) > bits - 10) ++precise;
    arb_clear(pi);
  });
  CHECK(precise == 4);
}
