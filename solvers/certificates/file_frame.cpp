#include "solvers/certificates/file_frame.hpp"

#include "solvers/elements/given_elements.hpp"

namespace gcs {
namespace {

/// Rows are the axes, after them the origin.
BallMatrix balls_of(const ExactFrame& frame, slong bits) {
  BallMatrix result(4, 3);
  for (slong row = 0; row < 4; ++row)
    for (slong axis = 0; axis < 3; ++axis) {
      const auto& numbers = row < 3 ? frame.axes[static_cast<std::size_t>(row)] : frame.origin;
      enclose(result(row, axis), numbers[static_cast<std::size_t>(axis)], bits);
    }
  return result;
}

/// Σ a_k b_k
void inner_product(acb_ptr sum, const BallMatrix& a, const BallMatrix& b, slong bits) {
  acb_zero(sum);
  for (slong k = 0; k < 3; ++k) acb_addmul(sum, a(k, 0), b(k, 0), bits);
}

}  // namespace

// With the rows A, o of the frame in the file and B, p of the same in a body T = Aᵀ B and s = o − T p; without a body
// B = 1 and p = 0.
FileFrame::FileFrame(const Scene& scene, slong bits)
    : is_moved_(scene.problem().file_frame.has_value()), bits_(bits), turn_(3, 3), shift_(3, 1) {
  if (!is_moved_) return;
  const ProblemStatement& problem = scene.problem();
  const BallMatrix file = balls_of(exact_frame(problem, given_elements(problem)), bits);
  BallMatrix body(4, 3);
  for (slong i = 0; i < 3; ++i) acb_one(body(i, i));
  if (problem.reference_body >= 0)
    body = balls_of(
        exact_frame(problem, problem.bodies[static_cast<std::size_t>(problem.reference_body)].elements),
        bits);
  for (slong i = 0; i < 3; ++i) {
    for (slong j = 0; j < 3; ++j)
      for (slong k = 0; k < 3; ++k) acb_addmul(turn_(i, j), file(k, i), body(k, j), bits);
    acb_set(shift_(i, 0), file(3, i));
    for (slong j = 0; j < 3; ++j) acb_submul(shift_(i, 0), turn_(i, j), body(3, j), bits);
  }
}

void FileFrame::place(BallMatrix& point) const {
  turn(point);
  for (slong i = 0; is_moved_ && i < 3; ++i) acb_add(point(i, 0), point(i, 0), shift_(i, 0), bits_);
}

void FileFrame::turn(BallMatrix& direction) const {
  if (!is_moved_) return;
  BallMatrix result(3, 1);
  acb_mat_mul(result.get(), turn_.get(), direction.get(), bits_);
  direction = result;
}

void FileFrame::move_to_foot(BallMatrix& point, const BallMatrix& direction) const {
  if (!is_moved_) return;
  Ball along;
  inner_product(along, point, direction, bits_);
  for (slong i = 0; i < 3; ++i) acb_submul(point(i, 0), along, direction(i, 0), bits_);
}

void FileFrame::shift(acb_ptr offset, const BallMatrix& normal) const {
  if (!is_moved_) return;
  Ball along;
  inner_product(along, shift_, normal, bits_);
  acb_add(offset, offset, along, bits_);
}

}  // namespace gcs
