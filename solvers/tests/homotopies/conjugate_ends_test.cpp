#include "solvers/homotopies/conjugate_ends.hpp"

#include <catch2/catch.hpp>
#include <complex>
#include <random>
#include <utility>
#include <vector>

#include "solvers/homotopies/distinct_ends.hpp"

using namespace gcs;

namespace {

PathEnd regular(ComplexVectorX x) { return {PathEnd::Kind::regular, std::move(x), 1, 0, true, ""}; }

/// Lost at a place that says nothing.
PathEnd failed() { return {PathEnd::Kind::failed, {5, 7}, 1, 0, false, "its steps became too small"}; }

std::vector<LostPath> complete(std::vector<PathEnd>& ends, const SignMasks& signs = {-1, -1},
                               bool is_isolated = true) {
  std::mt19937_64 random(1);
  return end_at_conjugates([=](const ComplexVectorX&) { return is_isolated; }, signs, random, ends);
}

const ComplexVectorX z{{1, 2}, {3, -1}}, w{{0.5, -4}, {2, 0.25}}, real{{1.5, 0}, {-2, 0}};

}  // namespace

TEST_CASE("a path that was lost ends at the conjugate at which no other one does") {
  std::vector<PathEnd> ends{regular(z), failed(), regular(real), regular(w), regular(conjugate(w))};
  complete(ends);
  CHECK(ends[1].kind == PathEnd::Kind::regular);
  CHECK(ends[1].x == conjugate(z));
  CHECK(ends[1].cause.empty());
  CHECK(ends[2].x == real);
}

TEST_CASE("paths that were lost where no conjugate is missing stay lost") {
  std::vector<PathEnd> ends{regular(z), failed(), regular(conjugate(z)), regular(real)};
  complete(ends);
  CHECK(ends[1].kind == PathEnd::Kind::failed);
}

TEST_CASE("of several paths that were lost as many end at conjugates as these are missing") {
  std::vector<PathEnd> ends{failed(), regular(z), failed()};
  complete(ends);
  CHECK(ends[0].kind == PathEnd::Kind::regular);
  CHECK(ends[0].x == conjugate(z));
  CHECK(ends[2].kind == PathEnd::Kind::failed);
}

TEST_CASE("paths that were given conjugates as their ends can be lost ones again") {
  std::vector<PathEnd> ends{failed(), regular(z), failed()};
  restore(complete(ends), ends);
  for (const std::size_t i : {0, 2}) {
    CHECK(ends[i].kind == PathEnd::Kind::failed);
    CHECK(ends[i].x == failed().x);
    CHECK(ends[i].cause == failed().cause);
  }
}

TEST_CASE("where more conjugates are missing than paths were lost, a step has jumped, and nothing is known") {
  std::vector<PathEnd> ends{failed(), regular(z), regular(w)};
  complete(ends);
  CHECK(ends[0].kind == PathEnd::Kind::failed);
}

TEST_CASE("a conjugate that is a mirror image is not missing") {
  const ComplexVectorX imaginary{{1, 0}, {0, 3}};
  std::vector<PathEnd> ends{failed(), regular(imaginary)};
  complete(ends, {-1, 0});
  CHECK(ends[0].kind == PathEnd::Kind::failed);
}

TEST_CASE("an end that is not known to be isolated tells nothing of its conjugate") {
  std::vector<PathEnd> ends{failed(), regular(z)};
  complete(ends, {-1, -1}, false);
  CHECK(ends[0].kind == PathEnd::Kind::failed);
  CHECK(keeps_rank({1, 0, 0, 1}));
  CHECK_FALSE(keeps_rank({1, 1, 1, 1}));
}
