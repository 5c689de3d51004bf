#pragma once
/// Which constraints there are, between what, and what writes their equations. A type is one file and one line of the
/// room solvers/constraints, whose table this is.

#include <span>
#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

class SystemBuilder;

/// A relation of a problem with what its equations may need to know of it.
struct StatedRelation {
  const Relation& relation;
  int value = -1;  ///< the number of its value; see value_of

  const Operand& of(std::size_t i) const { return relation.of[i]; }
  int entity(std::size_t i) const { return relation.of[i].entity; }
};

/// A kind as polynomials between two elements, of which a point p has the numbers (p, p·p), a plane (n, h) and a line
/// (u, p × u), as they are counted in element_bound.hpp.
struct ElementPolynomials {
  int count = 0;   ///< in space, in the plane one; 0: it is none between two elements
  int degree = 0;  ///< in each of the two
  /// Linear between what is held and what it only shifts: its offset, or its place and the square of that.
  bool is_of_shifts = false;
  int sided = -1;  ///< which of the two is a plane of which a side is seen
};

/// What a type may be between, and its equations then.
struct ConstraintKind {
  /// Which of them need a `parallel` that joins what they are between.
  enum class Joined { never, in_the_plane, always };

  /// Two, in the order of OperandKind. Empty: points, any number of them.
  std::vector<OperandKind> between;
  /// Writes the equations; operands are in the order of `between`. Null: nobody has written it yet.
  void (*state)(SystemBuilder& builder, const StatedRelation& stated) = nullptr;
  ElementPolynomials polynomials{};
  Joined joined = Joined::never;
  /// Whether the first of the two has the direction of the second from the start; of bodies place_elements states it.
  bool shares_direction = false;
};

struct ConstraintType {
  /// What says more than the type and what it is between.
  enum class Value { none, length, angle, sign };

  std::string name;  ///< in files and messages
  Value value = Value::none;
  std::vector<ConstraintKind> kinds;
  bool only_in_space = false;
  int fewest_points = 0;  ///< of a type between points, any number of them

  bool is_of_points() const { return kinds.front().between.empty(); }
};

/// All types, in the order in which messages list them.
std::span<const ConstraintType> constraint_types();

/// Null: no type has that name.
const ConstraintType* find_constraint_type(const std::string& name);

/// What a relation's type has for a value; none where no type has its name.
ConstraintType::Value value_kind(const Relation& relation);

/// The kind of a relation, or null. Turns its operands into the kind's order.
const ConstraintKind* find_kind(const ProblemStatement& problem, Relation& relation);

/// A `state` without equations.
void state_nothing(SystemBuilder& builder, const StatedRelation& stated);

/// The equation of a distance constraint, of two points or of a point and a line, by its number.
void state_distance(SystemBuilder& builder, int constraint);

}  // namespace gcs
