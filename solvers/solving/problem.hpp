#pragma once
/// A problem written in C++: the statements of an instance file, one call each, checked as a file is.

#include <array>
#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/reading/instance_parser.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

/// A given number. A text is the decimal number that it says, "3.1" exactly 31/10; a double is the binary number that
/// it is.
class GivenNumber {
 public:
  GivenNumber(double value);
  GivenNumber(int value) : GivenNumber(static_cast<double>(value)) {}
  GivenNumber(const char* text) : text_(text) {}
  GivenNumber(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The position of an element of a body: a point's coordinates, a point of a line and its direction, or a plane's normal
/// and offset, normal·x = offset for a normal of length 1 (which one of another length is brought to).
class Placed {
 public:
  Placed(std::string name, std::initializer_list<GivenNumber> coordinates);
  Placed(std::string name, std::initializer_list<GivenNumber> point,
         std::initializer_list<GivenNumber> direction);
  Placed(std::string name, std::initializer_list<GivenNumber> normal, const GivenNumber& offset);

  const std::string& name() const { return name_; }
  const JsonValue& position() const { return position_; }

 private:
  std::string name_;
  JsonValue position_;
};

/// A line or a plane by its name, or the segment from one point to another, {"p", "q"}.
class Side {
 public:
  Side(const char* name) : names_{name} {}
  Side(std::string name) : names_{std::move(name)} {}
  Side(std::string from, std::string to) : names_{std::move(from), std::move(to)} {}

  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Points, lines, planes and bodies, and what is to hold between them. Calls may come in any order and be chained. What
/// is wrong is said when the problem is solved or made an instance: an InputError as for a file of the same content, with
/// "problem" in the place of the file's name.
class Problem {
 public:
  /// `dimension`: 2 or 3.
  explicit Problem(int dimension) : dimension_(dimension) {}

  /// Names of points, different from all others.
  template <std::convertible_to<std::string>... Names>
  Problem& points(const Names&... names) {
    (points_.emplace_back(names), ...);
    return *this;
  }
  /// Names of lines.
  template <std::convertible_to<std::string>... Names>
  Problem& lines(const Names&... names) {
    (lines_.emplace_back(names), ...);
    return *this;
  }
  /// Names of planes, in space.
  template <std::convertible_to<std::string>... Names>
  Problem& planes(const Names&... names) {
    (planes_.emplace_back(names), ...);
    return *this;
  }
  /// Elements that are moved as one and never mirrored, in these positions relative to each other. They are points,
  /// lines and planes of the problem without being named elsewhere; one that two bodies have is a joint of theirs.
  Problem& body(const std::string& name, std::initializer_list<Placed> elements);
  /// The distance of two elements is `length` > 0. A point may have the distance 0 from a line where there are only
  /// points, lines in space and such distances. The distance of a plane from a point, or from a plane that a `parallel`
  /// joins with it, has a sign.
  Problem& distance(const std::string& a, const std::string& b, const GivenNumber& length);
  /// Its square is, where it has no sign.
  Problem& squared_distance(const std::string& a, const std::string& b, const GivenNumber& square);
  /// The angle of two lines, planes or segments is this, in degrees: between 0 and 90, of two planes or two segments
  /// between 0 and 180.
  Problem& angle(const Side& a, const Side& b, const GivenNumber& degrees);
  /// Its cosine is.
  Problem& angle_cosine(const Side& a, const Side& b, const GivenNumber& cosine);
  /// The point lies on the line or the plane, or the line on the plane.
  Problem& on(const std::string& a, const std::string& b);
  /// The two lines meet.
  Problem& meet(const std::string& a, const std::string& b);
  Problem& parallel(const Side& a, const Side& b);
  Problem& perpendicular(const Side& a, const Side& b);
  /// Three points or more lie on a line.
  template <std::convertible_to<std::string>... Names>
  Problem& collinear(const Names&... points) {
    return relate("collinear", {json_text(points)...});
  }
  /// Four points or more lie in a plane.
  template <std::convertible_to<std::string>... Names>
  Problem& coplanar(const Names&... points) {
    return relate("coplanar", {json_text(points)...});
  }
  /// Only those real solutions count in which the determinant of p2 − p1, p3 − p1, … has this sign, 1 or −1, for three
  /// points in the plane and four in space.
  Problem& orientation(std::initializer_list<std::string> points, int sign);
  /// The point is where these coordinates say, two in the plane and three in space.
  Problem& fix(const std::string& point, std::initializer_list<GivenNumber> coordinates);
  /// The line goes through `point` in this direction.
  Problem& fix(const std::string& line, std::initializer_list<GivenNumber> point,
               std::initializer_list<GivenNumber> direction);
  /// The plane has this normal and offset.
  Problem& fix(const std::string& plane, std::initializer_list<GivenNumber> normal,
               const GivenNumber& offset);
  /// Where the point is in the figure at which path strategies start; its distances there may be any.
  Problem& sketch(const std::string& point, std::initializer_list<GivenNumber> coordinates);
  /// Where the line is.
  Problem& sketch(const std::string& line, std::initializer_list<GivenNumber> point,
                  std::initializer_list<GivenNumber> direction);
  /// Where the plane is.
  Problem& sketch(const std::string& plane, std::initializer_list<GivenNumber> normal,
                  const GivenNumber& offset);

  /// The problem as an instance with the id "problem"; of general scenes the structure may be wrong. Throws InputError.
  Instance instance() const;
  /// The same, ready to be solved. Throws InputError for a wrong structure, too.
  operator Scene() const;

 private:
  Problem& distance_by(const std::string& a, const std::string& b, const char* form,
                       const GivenNumber& number);
  Problem& angle_by(const Side& a, const Side& b, const char* form, const GivenNumber& number);
  /// A constraint without a value.
  Problem& relate(const char* type, std::vector<JsonValue> between);
  /// Whether it takes gcsbench-instance/2 to say it.
  bool is_general() const;

  int dimension_;
  std::vector<std::string> points_;
  std::vector<std::string> lines_;
  std::vector<std::string> planes_;
  JsonMembers bodies_;
  std::vector<JsonValue> constraints_;
  JsonMembers fixed_;
  JsonMembers sketch_;
};

}  // namespace gcs
