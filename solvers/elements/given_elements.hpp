#pragma once
/// Elements with given positions as what they are to the rest: a body that does not move.

#include <array>
#include <vector>

#include "solvers/model/frame_choice.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/exact_number.hpp"
#include "solvers/numeric/rational_vector.hpp"

namespace gcs {

/// Those that have given positions, with the numbers of the file.
std::vector<BodyElement> given_elements(const ProblemStatement& problem);

/// How many motions leave all of them where they are, and what tells of these. Precondition of the latter: there are some.
int motions_left_by_given(const ProblemStatement& problem);
GivenAxis given_axis(const ProblemStatement& problem);

/// A frame in the file's unit.
struct ExactFrame {
  std::array<std::vector<ExactNumber>, 3> axes;
  std::vector<ExactNumber> origin;
};

/// The frame that `given_axis` tells. `elements`: where given elements, or some more, are in the file or in a body.
ExactFrame exact_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements);
/// The same in doubles, each right to a few roundings.
FramePose axial_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements);

/// The same, its axes at right angles and of any length.
struct GivenFrame {
  RationalVector origin, x, y, z;
  bool leaves_shift = false;
};

/// Given elements that leave motions, in the frame and unit of the scene, exactly. Precondition: they rest in the frame, and
/// are in no body that does.
class GivenCoordinates {
 public:
  explicit GivenCoordinates(const Scene& scene);

  /// Of a point, or of a line's point nearest to the origin.
  std::vector<ExactNumber> place(const BodyElement& element) const;
  /// Of a line or a plane, or from a point to another one; of length 1.
  std::vector<ExactNumber> direction(const BodyElement& element) const;
  std::vector<ExactNumber> direction(const BodyElement& from, const BodyElement& to) const;
  ExactNumber distance(const BodyElement& from, const BodyElement& to) const;
  /// How far a plane is from the origin, along its normal.
  ExactNumber offset(const BodyElement& plane) const;
  /// Whether a half-turn that changes the signs of these coordinates leaves all elements where they are.
  bool are_kept(const std::array<bool, 3>& turned_over) const;

 private:
  Rational along(const BodyElement& from, const BodyElement& to) const;

  const ProblemStatement& problem_;
  int exponent_;
  GivenFrame frame_;
};

/// Whether given positions that leave motions say where elements are relative to each other, which no body does.
bool has_given_shape(const ProblemStatement& problem);

/// Whether given elements that are no body's rest in the frame.
bool rest_in_frame(const ProblemStatement& problem);

/// The problem with these as a further body, the last, which rests; a body that has no others is empty. Where there are
/// none, the problem.
ProblemStatement with_given_body(ProblemStatement problem);

/// Whether a scene is solved by the equations of all kinds of elements: those of squared lengths do not know given lines.
bool has_element_equations(const ProblemStatement& problem);

}  // namespace gcs
