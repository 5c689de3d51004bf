#pragma once
/// Figures that are followed, for Python.

#include <pybind11/pybind11.h>

namespace gcs {

/// Defines the class Followed and the function follow. Precondition: the class Answer is defined.
void bind_followed(pybind11::module_& module);

}  // namespace gcs
