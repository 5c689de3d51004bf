#pragma once
/// The kinds of constraints: a row for each pair of kinds that a type is between, which writes its equations.

#include <array>
#include <optional>
#include <span>

#include "solvers/elements/system_builder.hpp"

namespace gcs {

/// A relation of a problem with what its equations may need to know of it.
struct StatedRelation {
  const Relation& relation;
  int value = no_value;  ///< the number of its value; see value_of

  const Operand& of(std::size_t i) const { return relation.of[i]; }
  int entity(std::size_t i) const { return relation.of[i].entity; }
};

struct ConstraintKind {
  RelationType type = RelationType::on;
  /// The kinds of what it is between, in the order of OperandKind; nothing for any number of points.
  std::optional<std::array<OperandKind, 2>> between;
  /// Writes the equations; operands are in the order of `between`.
  void (*state)(SystemBuilder& builder, const StatedRelation& stated) = nullptr;
};

// The rows of each file.
std::span<const ConstraintKind> distance_kinds();
std::span<const ConstraintKind> angle_kinds();
std::span<const ConstraintKind> incidence_kinds();
std::span<const ConstraintKind> direction_kinds();

/// The row of a relation, or null. Turns its operands into the row's order.
const ConstraintKind* find_kind(const ProblemStatement& problem, Relation& relation);

/// |p − q|² = a² of a distance constraint of two points, or of a point and a line.
void state_distance(SystemBuilder& builder, int constraint);
/// The same of the point and the line numbered so.
void state_distance_to_line(SystemBuilder& builder, int point, int line, const ExactNumber& square,
                            int value);

/// An unknown that is the bilinear product of two vectors, its sign turned with each of them.
LinearForm product_unknown(SystemBuilder& builder, const VectorForm& left, const VectorForm& right,
                           SignMask turning);

/// The point is foot + λ·direction, with an unknown λ.
void state_on_line(SystemBuilder& builder, const VectorForm& point, const LineForms& line);
void state_on_plane(SystemBuilder& builder, const VectorForm& point, const PlaneForms& plane);

/// end − start is λ·direction, with an unknown λ.
void state_along(SystemBuilder& builder, const Operand& segment, const VectorForm& direction,
                 SignMask turning);

}  // namespace gcs
