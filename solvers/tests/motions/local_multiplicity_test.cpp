#include "solvers/motions/local_multiplicity.hpp"

#include <catch2/catch.hpp>

using namespace gcs;

namespace {

LinearForm form(std::vector<ScaledUnknown> terms) { return {std::move(terms), {}}; }

const LinearForm one{{}, exactly(1)}, x = form({{0}}), y = form({{1}}), minus_y = form({{1, exactly(-1)}});

std::optional<int> at_origin(std::vector<FormProduct> f, std::vector<FormProduct> g, int most) {
  const QuadraticSystem system{2, {{std::move(f), {}}, {std::move(g), {}}}, {0, 0}};
  return local_multiplicity(system, {0, 0}, most);
}

}  // namespace

// Dimensions of C{x, y}/(f, g), by hand.
TEST_CASE("the multiplicity of a zero is the dimension of its local ring") {
  CHECK(at_origin({{x, one}}, {{y, one}}, 1) == 1);
  CHECK(at_origin({{x, x}}, {{y, one}}, 4) == 2);
  CHECK(at_origin({{x, x}, {minus_y, one}}, {{x, y}}, 4) == 3);
  CHECK(at_origin({{x, x}, {minus_y, one}}, {{y, y}}, 4) == 4);
  CHECK(at_origin({{x, x}}, {{y, y}}, 4) == 4);
  CHECK(at_origin({{x, x}}, {{y, y}}, 3) == 4);
}

// A line, also where the Jacobian loses more rank at the origin than on the rest of it.
TEST_CASE("a zero that is not isolated has a multiplicity above any") {
  CHECK(at_origin({{x, x}}, {{x, y}}, 2) == 3);
  CHECK(at_origin({{x, x}}, {{x, y}}, 7) == 8);
  CHECK(at_origin({{x, one}}, {{x, y}}, 5) == 6);
}
