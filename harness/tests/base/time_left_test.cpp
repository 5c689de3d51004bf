#include "harness/base/time_left.hpp"

#include <catch2/catch.hpp>

using namespace gcs;

TEST_CASE("at a steady pace the time left is exact") {
  TimeLeft left;
  CHECK_FALSE(left.estimate("paths", 0, 100));
  CHECK_FALSE(left.estimate("paths", 0.01, 101));  // too early to tell
  for (int second = 2; second <= 100; ++second)
    CHECK(left.estimate("paths", second / 100.0, 100 + second).value() == Approx(100 - second).margin(1e-9));
}

TEST_CASE("what was recalled from a journal is forgotten after a minute") {
  TimeLeft left;
  left.estimate("paths", 0, 0);
  left.estimate("paths", 0.5, 0.2);
  for (int second = 1; second <= 61; ++second) left.estimate("paths", 0.5 + second / 1000.0, second);
  CHECK(left.estimate("paths", 0.562, 62).value() == Approx(438));
}

TEST_CASE("seldom reports are judged by the last two") {
  TimeLeft left;
  left.estimate("paths", 0, 0);
  CHECK(left.estimate("paths", 0.1, 300).value() == Approx(2700));
  CHECK(left.estimate("paths", 0.3, 600).value() == Approx(1050));
}

TEST_CASE("what follows a colon makes no new stage") {
  TimeLeft left;
  left.estimate("answers: one", 0, 0);
  CHECK(left.estimate("answers: two: part", 0.5, 10).value() == Approx(10));
  CHECK_FALSE(left.estimate("repetitions", 0.6, 20));
}

TEST_CASE("nothing is said where nothing is known") {
  TimeLeft left;
  CHECK_FALSE(left.estimate("points", -1, 0));
  CHECK_FALSE(left.estimate("points", -1, 10));
  CHECK_FALSE(left.estimate("paths", 0.5, 10));
  CHECK_FALSE(left.estimate("paths", 0.5, 20));  // no progress
  CHECK_FALSE(left.estimate("other paths", 0.9, 30));
}

TEST_CASE("a rough time has a unit that suits it") {
  CHECK(rough_time(41.7) == "about 42 s");
  CHECK(rough_time(170) == "about 3 min");
  CHECK(rough_time(9000) == "about 2.5 h");
}
