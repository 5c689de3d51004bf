#include <Eigen/LU>
#include <algorithm>

#include "solvers/elements/body_joints.hpp"
#include "solvers/elements/body_placing.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/elements/exact_coordinates.hpp"
#include "solvers/elements/pose_features.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

/// The axes u, w and u × w from a point on the hinge.
class HingeBasis final : public BodyBasis {
 public:
  HingeBasis(RationalVector origin, const RationalVector& d, const RationalVector& e, int exponent)
      : origin_(std::move(origin)), basis_(d, e), exponent_(exponent) {}

  ExactNumber cosine() const { return basis_.cosine(); }
  std::vector<ExactNumber> arm(const BodyElement& element) const override {
    return basis_.coordinates(vector(element), false);
  }
  std::vector<ExactNumber> arm_parts(const BodyElement& element) const override {
    return exact_numbers(vector(element));
  }
  std::vector<ExactNumber> direction(const BodyElement& element, std::size_t first) const override {
    return basis_.coordinates(rational_vector(element, first, 3, 0), true);
  }
  std::vector<ExactNumber> direction(const BodyElement& from, const BodyElement& to) const override {
    return basis_.coordinates(vector(to) - vector(from), true);
  }
  ExactNumber distance(const BodyElement& from, const BodyElement& to) const override {
    return exact_norm(vector(to) - vector(from));
  }
  ExactNumber offset(const BodyElement& plane) const override {
    return offset_from(origin_, plane, exponent_);
  }

 private:
  RationalVector vector(const BodyElement& element) const {
    return rational_vector(element, 0, 3, exponent_) - origin_;
  }

  RationalVector origin_;
  ExactBasis basis_;
  int exponent_;
};

/// Writes the pose of one body.
class HingedBody {
 public:
  HingedBody(SystemBuilder& builder, const RigidBody& body, const HingedPose& pose,
             const std::vector<BodyDirection>& directions)
      : builder_(builder),
        body_(body),
        pose_(pose),
        directions_(directions),
        exponent_(-builder.scene().unit_exponent()),
        vectors_(body_vectors(builder.problem(), body, exponent_,
                              builder.problem().is_point(pose.origin) ? pose.origin : -1)),
        further_(farthest_from_hinge()),
        own_(own_direction()),
        basis_(position(pose.origin), along_hinge(), second_given(), exponent_) {}

  PlacedBody run() {
    const VectorForm w = second_axis();
    const BodyPlacing placing(builder_, basis_, pose_.at,
                              std::array{pose_.first.direction, w, third_axis(w)});
    PlacedBody placed = placing.run(body_);
    for (const BodyDirection& direction : directions_)
      placed.directions.push_back(&direction == own_ ? w : placing.direction(body_, direction));
    return placed;
  }

 private:
  RationalVector position(int entity) const {
    return rational_vector(element_of(body_, entity), 0, 3, exponent_);
  }
  RationalVector along(const BodyDirection& direction) const {
    if (direction.to >= 0) return position(direction.to) - position(direction.from);
    const std::size_t first = direction_numbers(builder_.problem(), direction.from);
    return rational_vector(element_of(body_, direction.from), first, 3, 0);
  }
  RationalVector along_hinge() const { return along(pose_.first.in_body); }

  /// Of the vectors that tell the pose the one of largest area with the hinge.
  BodyVector farthest_from_hinge() const {
    const Eigen::Vector3cd u = approximate(along_hinge());
    return *std::ranges::max_element(vectors_.vectors, {}, [&](const BodyVector& vector) {
      return cross_product(u, vector.given).norm();
    });
  }

  /// Null: none. Parallel to a line that two bodies share there may be others.
  const BodyDirection* own_direction() const {
    if (pose_.second) return nullptr;
    const auto found = std::ranges::find_if(directions_, [&](const BodyDirection& one) {
      return !are_parallel_in_body(builder_.problem(), body_, one, pose_.first.in_body);
    });
    return found == directions_.end() ? nullptr : &*found;
  }

  /// e, of which w is the direction.
  RationalVector second_given() const {
    if (pose_.second) return along(pose_.second->in_body);
    if (own_ != nullptr) return along(*own_);
    const BodyElement& element = element_of(body_, further_.entity);
    if (!builder_.problem().is_point(further_.entity)) return rational_vector(element, 0, 3, 0);
    return position(further_.entity) - position(vectors_.origin);
  }

  static Eigen::Vector3cd approximate(const RationalVector& v) {
    return {v[0].approximate(), v[1].approximate(), v[2].approximate()};
  }

  VectorForm second_axis() {
    const VectorForm& u = pose_.first.direction;
    if (pose_.second) {
      if (!pose_.is_turned)
        builder_.add(Equation().plus(u, pose_.second->direction).equals(basis_.cosine()), gap_value);
      return pose_.second->direction;
    }
    const VectorForm w = builder_.vector();
    builder_.name({body_.name + "_w", w});
    const Eigen::Matrix3cd given = triad(unit_vector(approximate(along_hinge())), further_.given);
    const Eigen::Vector3cd in_triad = given.inverse() * unit_vector(approximate(second_given()));
    builder_.define([u, in_triad, vector = further_, origin = vectors_.origin](const Placement& at,
                                                                               const ComplexValues& x) {
      return components(triad(vector_at(u, x), moved_vector(vector, origin, at)) * in_triad, 3);
    });
    builder_.add(Equation().plus(w, w).equals(exactly(1)));
    builder_.add(Equation().plus(u, w).equals(basis_.cosine()));
    return w;
  }

  /// u × w; 0 where the body lies in the plane of u and w.
  VectorForm third_axis(const VectorForm& w) {
    if (is_flat()) return {};
    const VectorForm& u = pose_.first.direction;
    const VectorForm n = builder_.pseudo_vector();
    builder_.name({body_.name + "_n", n});
    builder_.define([u, w](const Placement&, const ComplexValues& x) {
      return components(cross_product(vector_at(u, x), vector_at(w, x)), 3);
    });
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
      builder_.add(Equation().plus(u[next], w[last]).minus(u[last], w[next]).minus(n[i]).equals());
    }
    return n;
  }

  bool is_flat() const {
    const ProblemStatement& problem = builder_.problem();
    return std::ranges::all_of(body_.elements, [&](const BodyElement& element) {
      if (problem.is_plane(element.entity)) return basis_.direction(element, 0)[2].is_zero();
      return basis_.arm(element)[2].is_zero() &&
             (problem.is_point(element.entity) || basis_.direction(element, 3)[2].is_zero());
    });
  }

  SystemBuilder& builder_;
  const RigidBody& body_;
  const HingedPose& pose_;
  const std::vector<BodyDirection>& directions_;
  int exponent_;
  BodyVectors vectors_;
  BodyVector further_;
  const BodyDirection* own_;
  HingeBasis basis_;
};

}  // namespace

PlacedBody hinged_body(SystemBuilder& builder, const RigidBody& body, const HingedPose& pose,
                       const std::vector<BodyDirection>& directions) {
  return HingedBody(builder, body, pose, directions).run();
}

}  // namespace gcs
