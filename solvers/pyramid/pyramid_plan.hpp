#pragma once
/// The scan plan of a pyramid: [H] section 4.3 as construction steps.

#include "solvers/pyramid/pyramid.hpp"
#include "solvers/scanning/scan_plan.hpp"

namespace gcs {

/// The line is the x-axis, the apex (0, 0, r_5). p1 goes around the line by the one angle θ, over the half
/// turn with y ≥ 0 and with x ≥ 0: the other quarters are mirror images. p2, p4 and p3 follow from the apex,
/// a neighbour and the line; the last side, d34, is checked.
ScanPlan pyramid_plan(const Scene& scene, const Pyramid& pyramid);

/// The same over the whole turn and with x of either sign, as [H] scans: all mirror images. d34 is checked when
/// p4 is placed, after p3.
ScanPlan pyramid_plan_with_images(const Scene& scene, const Pyramid& pyramid);

}  // namespace gcs
