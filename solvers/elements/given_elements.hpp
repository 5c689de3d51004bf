#pragma once
/// Elements with given positions as what they are to the rest: a body that does not move.

#include <array>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/exact_number.hpp"

namespace gcs {

/// Those that have given positions, with the numbers of the file.
std::vector<BodyElement> given_elements(const ProblemStatement& problem);

/// A frame in the file's unit.
struct ExactFrame {
  std::array<std::vector<ExactNumber>, 3> axes;
  std::vector<ExactNumber> origin;
};

/// The frame that has the first given point at its origin and its first axis along what `given_axis` says. `elements`: where
/// given elements, or some more, are in the file or in a body.
ExactFrame exact_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements);
/// The same in doubles, each right to a few roundings.
FramePose axial_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements);

/// A given element on the first axis of a frame that is put in such, or across it.
struct AxialElement {
  int entity = -1;
  ExactNumber place{};       ///< where on the axis, in the scene's unit; of the axis itself 0
  bool is_opposite = false;  ///< whether a normal is against the axis
};

/// All of them, their places from exact numbers. Precondition: there is a frame to be completed, and in no body.
std::vector<AxialElement> axial_elements(const Scene& scene);

/// Whether given positions that leave motions say where elements are relative to each other, which no body does.
bool has_given_shape(const ProblemStatement& problem);

/// The problem with these as a further body, the last, which the frame is put in; a body that has no others is empty.
/// Where there are none, the problem.
ProblemStatement with_given_body(ProblemStatement problem);

/// Whether a scene is solved by the equations of all kinds of elements: those of squared lengths do not know given lines.
bool has_element_equations(const ProblemStatement& problem);

}  // namespace gcs
