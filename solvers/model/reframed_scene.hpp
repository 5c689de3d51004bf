#pragma once
/// A scene in another frame than its own.

#include "solvers/model/scene.hpp"

namespace gcs {

/// The same problem in that frame.
Scene with_reference(const Scene& scene, const Reference& reference);

/// Whether the frame is that of a line, which the equations of elements do not have.
bool is_in_frame_of_line(const Scene& scene);
/// Of such a scene the frame of its points, of others their own; and the scene in it.
Reference reference_of_elements(const Scene& scene);
Scene in_frame_of_elements(const Scene& scene);

}  // namespace gcs
