#pragma once
/// Which unknowns the equations have whose mixed cells are sought; supports.hpp says more.

namespace gcs {

enum class Formulation { spheres, coordinates };

}  // namespace gcs
