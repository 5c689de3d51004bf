#pragma once
/// Elements anywhere, as starts for Newton's method.

#include <random>

#include "solvers/model/scene.hpp"

namespace gcs {

/// A real figure, in the scene's unit, that need not meet any constraint: points in a box of that half-width, directions
/// and rotations of bodies at random, lines and planes through points of the box.
Figure random_figure(const Scene& scene, double reach, std::mt19937_64& random);

}  // namespace gcs
