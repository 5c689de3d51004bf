#include "solvers/reading/instance_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/numeric/rational.hpp"

namespace gcs {
namespace {

using Form = Relation::Form;

/// One of two ways to give a value: the name of the member that is there.
const char* given_member(const JsonCursor& constraint, const char* first, const char* second,
                         const std::string& value) {
  if (constraint.has(first) == constraint.has(second)) {
    const std::string either = "'" + std::string(first) + "'", other = "'" + std::string(second) + "'";
    constraint.fail(
        constraint.has(first) ? "both " + either + " and " + other + " are given" : value + " is missing",
        "give either " + either + " or " + other);
  }
  return constraint.has(first) ? first : second;
}

class OperandKinds {
 public:
  OperandKinds(const ProblemStatement& problem, const Relation& relation) {
    for (const Operand& operand : relation.of) kinds_.push_back(kind_of(problem, operand));
  }

  bool has(OperandKind kind) const { return count(kind) > 0; }
  bool all(OperandKind kind) const { return count(kind) == static_cast<std::ptrdiff_t>(kinds_.size()); }

 private:
  std::ptrdiff_t count(OperandKind kind) const { return std::count(kinds_.begin(), kinds_.end(), kind); }

  std::vector<OperandKind> kinds_;
};

/// Of a plane from a point or a plane: it says on which side.
bool is_signed(const OperandKinds& kinds) {
  return kinds.has(OperandKind::plane) && !kinds.has(OperandKind::line);
}

/// What a distance of 0 is.
std::string name_of_zero(const OperandKinds& kinds, int dimension) {
  if (kinds.all(OperandKind::point)) return "a distance between two points is > 0";
  if (kinds.all(OperandKind::plane)) return "two planes in one place are one: name it once";
  if (!kinds.all(OperandKind::line)) return "that is the constraint 'on'";
  return dimension == 2 ? "two lines in one place are one: name it once" : "that is the constraint 'meet'";
}

void require_full_precision(const JsonCursor& cursor, const Decimal& given, bool with_sign) {
  const double size = with_sign ? std::abs(given.value) : given.value;
  if (size <= 0 || size >= std::numeric_limits<double>::min()) return;
  cursor.fail(given.text + " is too small for a double's full precision",
              "give lengths in a smaller unit, as numbers above 1e-300");
}

void refuse_length(const JsonCursor& cursor, const Decimal& given, const std::string& remedy) {
  cursor.fail("the length is " + given.text, remedy);
}

/// gcsbench-instance/1 lets a point have the distance 0 from a line.
void check_length_of_distances(const JsonCursor& cursor, const Decimal& given, const OperandKinds& kinds) {
  const bool with_line = kinds.has(OperandKind::line);
  if (given.value > 0 || (with_line && given.value == 0)) return;
  refuse_length(cursor, given,
                with_line ? "a distance to a line is ≥ 0" : "a distance between two points is > 0");
}

void check_length(const JsonCursor& cursor, const Decimal& given, const OperandKinds& kinds, int dimension) {
  if (given.value == 0) refuse_length(cursor, given, name_of_zero(kinds, dimension));
  if (given.value > 0 || is_signed(kinds)) return;
  refuse_length(cursor, given,
                kinds.all(OperandKind::point) ? "a distance between two points is > 0"
                                              : "this distance has no sign: give a number > 0");
}

void read_length(const JsonCursor& constraint, InstanceFormat format, const ProblemStatement& problem,
                 Relation& relation) {
  const OperandKinds kinds(problem, relation);
  const std::string member = given_member(constraint, "length", "squared", "the length");
  const JsonCursor cursor = constraint.required(member);
  relation.form = member == "squared" ? Form::squared : Form::length;
  if (relation.form == Form::squared && is_signed(kinds))
    cursor.fail("a distance from a plane has a sign, which its square does not say", "give 'length'");
  relation.given = cursor.number();
  require_full_precision(cursor, relation.given, is_signed(kinds));
  if (format == InstanceFormat::distances) {
    check_length_of_distances(cursor, relation.given, kinds);
  } else {
    check_length(cursor, relation.given, kinds, problem.dimension);
  }
}

/// The values that an angle can have, and how these are said.
struct AngleRange {
  long least_cosine;
  long most_degrees;
};

/// Directions without a sense have no obtuse angle.
AngleRange range_of(const OperandKinds& kinds) {
  const bool with_sense = kinds.all(OperandKind::plane) || kinds.all(OperandKind::segment);
  return with_sense ? AngleRange{-1, 180} : AngleRange{0, 90};
}

/// 0 where it is smaller than any double.
Rational exact(const Decimal& given) {
  return given.value == 0 ? Rational(0) : Rational::from_decimal(given.text);
}

bool is_below(const Rational& a, const Rational& b) { return (a - b).sign() < 0; }

/// Those that are no angle but another constraint. `of_parallel` and `of_right_angle`: in degrees, or the cosine.
void refuse_other_constraints(const JsonCursor& cursor, const std::string& said, const Rational& given,
                              std::array<long, 2> of_parallel, long of_right_angle) {
  if (given == Rational(of_right_angle)) cursor.fail(said, "that is the constraint 'perpendicular'");
  if (given == Rational(of_parallel[0]) || given == Rational(of_parallel[1]))
    cursor.fail(said, "that is the constraint 'parallel'");
}

void read_angle(const JsonCursor& constraint, const ProblemStatement& problem, Relation& relation) {
  const AngleRange range = range_of(OperandKinds(problem, relation));
  const std::string member = given_member(constraint, "degrees", "cosine", "the angle");
  const JsonCursor cursor = constraint.required(member);
  relation.given = cursor.number();
  const Rational given = exact(relation.given);
  if (member == "degrees") {
    relation.form = Form::degrees;
    const std::string said = "the angle is " + relation.given.text + " degrees";
    refuse_other_constraints(cursor, said, given, {0, 180}, 90);
    if (given.sign() > 0 && is_below(given, range.most_degrees)) return;
    cursor.fail(said, range.most_degrees == 90 ? "this angle is above 0 and below 90 degrees"
                                               : "this angle is above 0 and below 180 degrees");
  }
  relation.form = Form::cosine;
  const std::string said = "the cosine is " + relation.given.text;
  refuse_other_constraints(cursor, said, given, {1, -1}, 0);
  if (is_below(range.least_cosine, given) && is_below(given, 1)) return;
  cursor.fail(said, range.least_cosine == 0 ? "this cosine is above 0 and below 1"
                                            : "this cosine is above -1 and below 1");
}

void read_sign(const JsonCursor& constraint, Relation& relation) {
  const JsonCursor cursor = constraint.required("sign");
  const Decimal sign = cursor.number();
  if (std::abs(sign.value) != 1) cursor.fail("the sign is " + sign.text, "give 1 or -1");
  relation.sign = static_cast<int>(sign.value);
}

}  // namespace

void read_value(const JsonCursor& constraint, InstanceFormat format, const ProblemStatement& problem,
                Relation& relation) {
  using enum ConstraintType::Value;
  const ConstraintType::Value value = value_kind(relation);
  if (value == length) read_length(constraint, format, problem, relation);
  if (value == angle) read_angle(constraint, problem, relation);
  if (value == sign) read_sign(constraint, relation);
}

}  // namespace gcs
