#include "harness/ranks/rank_crew.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace gcs;

namespace {

/// How many items the busiest of equally fast ranks does.
int rounds(std::size_t members, std::size_t left, std::size_t reserve) {
  std::vector<int> queued(members, 0);
  int round = 0;
  const auto is_busy = [&] {
    return left > 0 || std::any_of(queued.begin(), queued.end(), [](int n) { return n > 0; });
  };
  for (; is_busy(); ++round) {
    while (const auto rank = next_receiver(queued, left, reserve)) {
      ++queued[static_cast<std::size_t>(*rank)];
      --left;
    }
    for (int& number : queued) number = std::max(0, number - 1);
  }
  return round;
}

}  // namespace

TEST_CASE("equally fast ranks have equally much to do") {
  for (std::size_t members = 1; members <= 9; ++members)
    for (std::size_t items = 0; items <= 40; ++items)
      for (std::size_t reserve = 0; reserve <= 3; ++reserve)
        CHECK(rounds(members, items, reserve) == static_cast<int>((items + members - 1) / members));
}

TEST_CASE("a rank has items in reserve while there are many, and never more than are wanted") {
  CHECK(next_receiver({1, 1, 1}, 3, 2) == 1);
  CHECK(next_receiver({1, 2, 1}, 3, 2) == 2);
  CHECK(next_receiver({2, 2, 2}, 6, 2) == 1);
  CHECK(next_receiver({2, 2, 2}, 6, 1) == std::nullopt);
  CHECK(next_receiver({2, 2, 2}, 5, 2) == std::nullopt);
  CHECK(next_receiver({3, 3, 3}, 100, 2) == std::nullopt);
  CHECK(next_receiver({1, 1, 1}, 2, 2) == std::nullopt);
  CHECK(next_receiver({0, 1, 0}, 1, 2) == 2);
}

TEST_CASE("the first rank is not left without items") {
  CHECK(next_receiver({0, 1, 1}, 1, 2) == 0);
  CHECK(next_receiver({0}, 1, 2) == 0);
  CHECK(next_receiver({0, 0, 0}, 1, 2) == 1);
}
