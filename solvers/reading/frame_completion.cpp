#include "solvers/reading/frame_completion.hpp"

#include "solvers/elements/given_elements.hpp"
#include "solvers/model/frame_choice.hpp"
#include "solvers/reading/instance_bodies.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/instance_positions.hpp"

namespace gcs {
namespace {

/// The frame of a body that has all given elements, in the file.
FramePose body_frame(const ProblemStatement& problem, const FramePose& in_file, const RigidBody& body) {
  const FramePose in_body = axial_frame(problem, body.elements);
  FramePose frame;
  frame.axes = in_body.axes.transpose() * in_file.axes;
  frame.origin = in_file.origin - frame.axes.transpose() * in_body.origin;
  return frame;
}

}  // namespace

void complete_frame(const JsonCursor& fixed, ProblemStatement& problem) {
  const std::vector<BodyElement> elements = given_elements(problem);
  if (elements.empty() || motions_left_by_given(problem) == 0 || seeks_line_from_given_points(problem))
    return;
  refuse_coincident_fixed_points(fixed, problem);
  std::vector<int> given;
  for (const BodyElement& element : elements) given.push_back(element.entity);
  const FramePose frame = axial_frame(problem, elements);
  problem.reference_body = common_body(problem, given);
  if (problem.reference_body >= 0) {
    problem.file_frame =
        body_frame(problem, frame, problem.bodies[static_cast<std::size_t>(problem.reference_body)]);
    return;
  }
  problem.reference = completing_reference(problem, given_axis(problem));
  if (!problem.reference)
    fixed.fail(
        "the fixed positions leave motions, and to use these up there are too few elements that are in no "
        "body",
        "fix elements of one body, or so many that they leave no motion");
  problem.file_frame = frame;
}

}  // namespace gcs
