#include "harness/tests/contract/known_counts.hpp"

#include <algorithm>
#include <array>

namespace gcs::contract {
namespace {

/// On S and real: table 1 of Imbach, Mathis, Schreck 2016 for octahedron, disulfide and dodecagon. The
/// disulfide's 18 real ones are those of Porta et al. 2007. Complex: bounds of Capco et al. 2018 in the plane
/// and of Bartzos, Emiris, Schicho 2020 in space, which are met; at the icosahedra's lengths some of the
/// generic solutions are at infinity. Lines: Hoffmann and Yuan 2000, section 4.1 (12 tangents) and table 2 (24
/// solutions, four by four mirror images). qK3,3, complex: four points, each at one of two intersections, and
/// mirror images are one. The rest: polyhedral and monodromy, which share nothing but their tracker, and
/// plan-scan, which proves the real ones (of seven points, as published, all are real: Bartzos et al. 2021); S of qK3,3, and the icosahedra's in place of the published 32: the
/// tubes of full-space mode=certified.
constexpr std::array<KnownCounts, 21> list{{
    {"octahedron", 4, 4, 8},
    {"disulfide", 8, 18, 32},
    {"dodecagon", 2, 2, 3090},
    {"k33", 2, 2, 8},
    {"qk33", 2, 4, 8},
    {"icosahedron", 174, 308, 25536},
    {"icosahedron-printed", 284, 324, 16480},
    {"octahedron-cyclohexane", {}, 8, 8},
    {"hoffmann-yuan", {}, 6, {}},
    {"tangents-durand", {}, 4, 12},
    {"tangents-12-real", {}, 12, 12},
    {"tangents-equal-radii", {}, 12, 12},
    {"tangents-fourfold", {}, 3, 3},
    {"prism", {}, 12, 12},
    {"g16a", {}, 8, 8},
    {"g16b", {}, 8, 8},
    {"g24", {}, 12, 12},
    {"g32a", {}, 16, 16},
    {"g32b", {}, 16, 16},
    {"g48", {}, 24, 24},
    {"g160", {}, 66, 80},
}};

}  // namespace

std::optional<KnownCounts> known_counts(std::string_view instance) {
  const auto found = std::find_if(list.begin(), list.end(), [instance](const KnownCounts& counts) {
    return counts.instance == instance;
  });
  return found == list.end() ? std::nullopt : std::optional(*found);
}

}  // namespace gcs::contract
