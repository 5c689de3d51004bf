#include "solvers/numeric/sign_masks.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <vector>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;

namespace {

double sign_of(SignMask element, SignMask mask) { return std::popcount(element & mask) % 2 == 0 ? 1 : -1; }

/// By trying all elements.
bool some_element_fits(const std::vector<SignMask>& masks, int generators, const std::vector<int>& fits) {
  for (SignMask element = 0; element < SignMask{1} << generators; ++element) {
    bool all = true;
    for (std::size_t i = 0; i < masks.size(); ++i)
      all = all && (fits[i] & (sign_of(element, masks[i]) > 0 ? 1 : 2)) != 0;
    if (all) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("elimination modulo 2 finds an element that fits exactly where trying all does") {
  samples::RandomNumbers random(4);
  constexpr int generators = 5, unknowns = 7;
  int found = 0, tried = 3000;
  for (int i = 0; i < tried; ++i) {
    std::vector<SignMask> masks;
    std::vector<int> fits;  // bit 0: the sign may stay, bit 1: it may change
    for (int u = 0; u < unknowns; ++u) {
      masks.push_back(static_cast<SignMask>(random.index(1 << generators)));
      fits.push_back(1 + random.index(3));
    }
    const bool expected = some_element_fits(masks, generators, fits);
    found += expected ? 1 : 0;
    CHECK(some_signs_fit(SignMasks(masks), [&](std::size_t u, double sign) {
            return (fits[u] & (sign > 0 ? 1 : 2)) != 0;
          }) == expected);
  }
  CHECK(found > tried / 10);
  CHECK(found < tried - tried / 10);
}

TEST_CASE("the rank of masks counts sign patterns") {
  CHECK(SignMasks(std::vector<int>{0, 1, 2, 0, -1}).rank() == 3);
  CHECK(SignMasks(std::vector<SignMask>{1, 3, 2}).rank() == 2);
  CHECK(SignMasks(std::vector<SignMask>{0, 0}).rank() == 0);
}

TEST_CASE("signs are found that lead to the image of a vector under an element of the group") {
  samples::RandomNumbers random(5);
  constexpr int generators = 4, unknowns = 9;
  for (int i = 0; i < 200; ++i) {
    std::vector<SignMask> masks;
    for (int u = 0; u < unknowns;
         ++u)  // each generator has an unknown of its own, and a last one has no mask
      masks.push_back(u < generators ? SignMask{1} << u
                                     : static_cast<SignMask>(random.index(1 << generators)));
    const auto element = static_cast<SignMask>(random.index(1 << generators));
    Eigen::VectorXd y0(unknowns + 1), y(unknowns + 1);
    for (int u = 0; u <= unknowns; ++u) {
      y0[u] = random.uniform(0.1, 1);
      y[u] = u < unknowns ? sign_of(element, masks[static_cast<std::size_t>(u)]) * y0[u] : y0[u];
    }
    const Eigen::VectorXd signs = signs_towards(SignMasks(masks), (SignMask{1} << generators) - 1, y0, y);
    CHECK((signs.array() * y0.array()).matrix() == y);
  }
}
