#include "solvers/running/crew.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "solvers/tests/fake_crew.hpp"

using namespace gcs;

namespace {

std::string twice(const NumberedItem& item) { return item.bytes + item.bytes; }

FakeCrew doubling_crew() {
  return FakeCrew([](const std::string&) { return std::make_unique<OneByOne>(twice); });
}

}  // namespace

TEST_CASE("every item has its result, and few of many are there at once") {
  for (const std::size_t count : {0, 1, 7, 1000}) {
    FakeCrew crew = doubling_crew();
    OneByOne here(twice);
    std::size_t made = 0, most = 0;
    std::set<std::uint64_t> taken;
    crew.each_result(
        "task", count,
        [&](std::size_t i) {
          most = std::max(most, ++made - taken.size());
          return std::to_string(i);
        },
        here, [] { return false; },
        [&](const NumberedItem& result) {
          CHECK(result.bytes == std::to_string(result.number) + std::to_string(result.number));
          CHECK(taken.insert(result.number).second);
        });
    CHECK(taken.size() == count);
    CHECK(made == count);
    CHECK(most <= std::min<std::size_t>(count, 12));
  }
}

TEST_CASE("a crew that is stopped leaves items without results") {
  FakeCrew crew = doubling_crew();
  OneByOne here(twice);
  std::size_t taken = 0, made = 0;
  crew.each_result(
      "task", 1000,
      [&](std::size_t i) {
        ++made;
        return std::to_string(i);
      },
      here, [&] { return taken >= 10; }, [&](const NumberedItem&) { ++taken; });
  CHECK(taken == 10);
  CHECK(made < 100);
}
