#pragma once
/// Which figures are the same up to a rigid motion and a reflection.

#include <limits>
#include <span>
#include <vector>

#include "solvers/model/scene.hpp"

namespace gcs {

struct ReflectionClasses {
  std::vector<int> class_of;  ///< one per figure: 0, 1, … in order of first appearance
  std::vector<int> first;     ///< one per class: the first figure of the class
  int count() const { return static_cast<int>(first.size()); }
};

/// How far apart figures of one class may be, relative to scene.size().
struct ClassTolerance {
  double distances = 0;
  /// Of the points once they are placed alike; infinite: distances alone decide. Near a flat figure they feel
  /// a height z over its plane by z² only.
  double places = std::numeric_limits<double>::infinity();
};

/// Two figures are the same class when no distance between two of their entities differs by more than
/// `tolerance` · scene.size(). Distances decide first: two sets of points with equal distances are congruent
/// or mirror images, so no frame and no sign has to be chosen. A line takes part by the feet of the
/// perpendiculars from all points (the distances of four points to a line leave twelve lines) and by its
/// angles to other lines; its direction is up to sign. With fixed positions the coordinates themselves are
/// compared and no reflection is divided out. Without them, of complex figures (with one line at most) the
/// squared distances are compared, to tolerance · scene.size()². No complex figure equals a real one. A
/// figure belongs to the first class whose first figure it equals; one that is not finite equals none. Time:
/// n log n for n figures.
ReflectionClasses reflection_classes(const Scene& scene, std::span<const Figure> figures, double tolerance,
                                     int threads = 1);
/// The same with tolerances for every figure, of two the larger ones; and where distances are equal, the
/// points must come to lie together (see may_be_congruent).
ReflectionClasses reflection_classes(const Scene& scene, std::span<const Figure* const> figures,
                                     std::span<const ClassTolerance> tolerances, int threads = 1);

}  // namespace gcs
