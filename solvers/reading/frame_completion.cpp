#include "solvers/reading/frame_completion.hpp"

#include <algorithm>

#include "solvers/elements/body_motion.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/model/frame_choice.hpp"
#include "solvers/reading/element_position.hpp"
#include "solvers/reading/instance_bodies.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/instance_positions.hpp"

namespace gcs {
namespace {

int motions_of(const ProblemStatement& problem, const std::vector<BodyElement>& given) {
  std::vector<ElementPosition> positions;
  for (const BodyElement& element : given) positions.push_back(position_in_body(problem, element));
  return motions_left(positions, problem.dimension);
}

/// Whether all is at a point, on an axis through it or across that; or there is one line, or parallel planes, alone.
bool is_axial(const ProblemStatement& problem, const std::vector<int>& given) {
  const auto is_line = [&](int entity) { return problem.is_line(entity); };
  return problem.is_point(given.front()) || (given.size() == 1 && is_line(given.front())) ||
         std::ranges::none_of(given, is_line);
}

/// The frame of a body that has all given elements, in the file.
FramePose body_frame(const ProblemStatement& problem, const FramePose& in_file, const RigidBody& body) {
  const FramePose in_body = axial_frame(problem, body.elements);
  FramePose frame;
  frame.axes = in_body.axes.transpose() * in_file.axes;
  frame.origin = in_file.origin - frame.axes.transpose() * in_body.origin;
  return frame;
}

/// Planes alone are parallel where they leave three motions, as one of them does.
void require_axial(const JsonCursor& fixed, const ProblemStatement& problem, const std::vector<int>& given,
                   int motions) {
  const bool is_across = problem.is_plane(given.front()) && motions < 3;
  if (is_axial(problem, given) && !is_across) return;
  fixed.fail(
      "the fixed positions leave motions, and a frame is completed only beside a point and what is on an "
      "axis through it, one line, or parallel planes",
      "fix a point as well, or all but one of " + entity_names(problem, given) + " by constraints");
}

}  // namespace

void complete_frame(const JsonCursor& fixed, ProblemStatement& problem) {
  const std::vector<BodyElement> elements = given_elements(problem);
  const int motions = motions_of(problem, elements);
  if (elements.empty() || motions == 0 || seeks_line_from_given_points(problem)) return;
  refuse_coincident_fixed_points(fixed, problem);
  std::vector<int> given;
  for (const BodyElement& element : elements) given.push_back(element.entity);
  require_axial(fixed, problem, given, motions);
  const FramePose frame = axial_frame(problem, elements);
  problem.reference_body = common_body(problem, given);
  if (problem.reference_body >= 0) {
    problem.file_frame =
        body_frame(problem, frame, problem.bodies[static_cast<std::size_t>(problem.reference_body)]);
    return;
  }
  if (std::ranges::any_of(given, [&](int entity) { return !bodies_with(problem, entity).empty(); }))
    fixed.fail(entity_names(problem, given) + " leave motions, and one body has some of them, but not all",
               "fix elements of one body, or of none, or so many that they leave no motion");
  problem.reference = completing_reference(problem);
  if (!problem.reference)
    fixed.fail(
        "the fixed positions leave motions, and to use these up there are too few elements that are in no "
        "body",
        "fix elements of one body, or so many that they leave no motion");
  problem.file_frame = frame;
}

}  // namespace gcs
