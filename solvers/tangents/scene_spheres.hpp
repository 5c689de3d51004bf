#pragma once
/// The spheres that a scene's line has to touch, and its tangents in the scene.

#include <optional>

#include "solvers/model/complex_lines.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/running/work.hpp"
#include "solvers/tangents/found_tangents.hpp"

namespace gcs {

/// In the scene's coordinates and the order of the constraints. Nothing unless there is one line, which is
/// free and whose distances are from four given points.
std::optional<FourSpheres> spheres_of(const Scene& scene);

/// Spheres moved near the origin, with lengths near 1.
struct LocalSpheres {
  explicit LocalSpheres(const FourSpheres& in_scene);

  FourSpheres spheres;
  Eigen::Vector3d origin;
  int exponent = 0;  ///< local length = scene length / 2^exponent

  ComplexTangent local(const ComplexLine& line) const;
  /// In the scene's coordinates, its point still the one nearest to the first centre.
  ComplexTangent moved(const ComplexTangent& line) const;
  ComplexLine in_scene(const ComplexTangent& line) const;
};

/// The given points and this line. Precondition: all points are given.
Figure beside_given_points(const Scene& scene, const ComplexLine& line, bool is_real);

/// A common tangent of the local spheres that was found to 1e-3 of its size, in the scene, as good as its coordinates in
/// doubles can be, and normalised (complex_lines.hpp). A simple one by Newton's method in the scene's coordinates, which are
/// those of the exact line to their last bit then, and where the centres are nearly collinear or the
/// direction is nearly isotropic in isotropic ones (strip_refinement.hpp); a multiple one settled
/// (tangent_refinement.hpp). Where that does not converge the line is as it was. Adds to `work`.
ComplexLine polished(const FourSpheres& in_scene, const LocalSpheres& local, const ComplexTangent& line,
                     bool is_real, int multiplicity, WorkCounters& work);

}  // namespace gcs
