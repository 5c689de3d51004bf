#pragma once
/// Puts the elements of a body where its pose does.

#include <array>
#include <optional>
#include <vector>

#include "solvers/elements/element_kinds.hpp"

namespace gcs {

/// How the vectors of a body are combined of its axes.
class BodyBasis {
 public:
  virtual ~BodyBasis() = default;
  /// From the body's origin to a point of it, or of a line.
  virtual std::vector<ExactNumber> arm(const BodyElement& element) const = 0;
  /// Numbers whose squares add up to the arm's.
  virtual std::vector<ExactNumber> arm_parts(const BodyElement& element) const = 0;
  /// Of length 1, from the numbers of the element that begin at `first`.
  virtual std::vector<ExactNumber> direction(const BodyElement& element, std::size_t first) const = 0;
  /// Of length 1, from one point to another; and the length between them.
  virtual std::vector<ExactNumber> direction(const BodyElement& from, const BodyElement& to) const = 0;
  virtual ExactNumber distance(const BodyElement& from, const BodyElement& to) const = 0;
  /// How far a plane is from the origin, along its normal.
  virtual ExactNumber offset(const BodyElement& plane) const = 0;
  /// Whether the point of each line is the one nearest to the origin.
  virtual bool has_feet() const { return false; }
};

/// Images of a body's axes; none: it rests in the frame.
using BodyAxes = std::optional<std::array<VectorForm, 3>>;

/// Σ number_k·axis_k. Precondition: coefficients of the axes are 1 or −1.
VectorForm combined(const std::vector<ExactNumber>& numbers, const BodyAxes& axes);

class BodyPlacing {
 public:
  BodyPlacing(SystemBuilder& builder, const BodyBasis& basis, VectorForm origin, BodyAxes axes)
      : builder_(builder), basis_(basis), origin_(std::move(origin)), axes_(std::move(axes)) {}

  PlacedBody run(const RigidBody& body) const;
  /// Of length 1: components that are not 0 are unknowns of their own.
  VectorForm direction(const RigidBody& body, const BodyDirection& direction) const;

 private:
  BodyPoint point(const BodyElement& element) const;
  LineForms line(const BodyElement& element) const;
  PlaneForms plane(const BodyElement& element) const;
  SegmentForms segment(const BodyElement& from, const BodyElement& to) const;

  SystemBuilder& builder_;
  const BodyBasis& basis_;
  VectorForm origin_;
  BodyAxes axes_;
};

/// The element of a body that is an entity. Precondition: there is one.
const BodyElement& element_of(const RigidBody& body, int entity);

/// Where the numbers of a line or a plane begin that give its direction or its normal.
std::size_t direction_numbers(const ProblemStatement& problem, int entity);

}  // namespace gcs
