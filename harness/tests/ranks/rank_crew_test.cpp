#include "harness/ranks/rank_crew.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace gcs;

namespace {

/// How many items the busiest of equally fast ranks does; the first one hands out when it has done one of its own.
int rounds(std::size_t members, std::size_t left) {
  std::vector<int> queued(members, 0);
  int round = 0;
  const auto is_busy = [&] {
    return left > 0 || std::any_of(queued.begin(), queued.end(), [](int n) { return n > 0; });
  };
  for (; is_busy(); ++round) {
    while (const auto rank = next_receiver(queued, left)) {
      ++queued[static_cast<std::size_t>(*rank)];
      --left;
    }
    if (left > 0) --left;
    for (int& number : queued) number = std::max(0, number - 1);
  }
  return round;
}

}  // namespace

TEST_CASE("equally fast ranks have equally much to do") {
  for (std::size_t members = 1; members <= 9; ++members)
    for (std::size_t items = 0; items <= 40; ++items)
      CHECK(rounds(members, items) == static_cast<int>((items + members - 1) / members));
}

TEST_CASE("a rank has an item in reserve while there are many, and never two") {
  CHECK(next_receiver({0, 1, 1}, 3) == 1);
  CHECK(next_receiver({0, 2, 1}, 3) == 2);
  CHECK(next_receiver({0, 2, 2}, 100) == std::nullopt);
  CHECK(next_receiver({0, 1, 1}, 2) == std::nullopt);
  CHECK(next_receiver({0, 1, 0}, 1) == 2);
}
