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

/// Points, and in space lines, with given distances between them. Calls may come in any order and be chained. What is
/// wrong is said when the problem is solved or made an instance: an InputError as for a file of the same content, with
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
  /// The distance of two points is `length` > 0, or that of a point and a line `length` ≥ 0.
  Problem& distance(const std::string& a, const std::string& b, const GivenNumber& length);
  /// Its square is.
  Problem& squared_distance(const std::string& a, const std::string& b, const GivenNumber& square);
  /// The point is where these coordinates say, two in the plane and three in space.
  Problem& fix(const std::string& point, std::initializer_list<GivenNumber> coordinates);
  /// The line goes through `point` in this direction.
  Problem& fix(const std::string& line, std::initializer_list<GivenNumber> point,
               std::initializer_list<GivenNumber> direction);
  /// Where the point is in the figure at which path strategies start; its distances there may be any.
  Problem& sketch(const std::string& point, std::initializer_list<GivenNumber> coordinates);
  /// Where the line is.
  Problem& sketch(const std::string& line, std::initializer_list<GivenNumber> point,
                  std::initializer_list<GivenNumber> direction);

  /// The problem as an instance with the id "problem". Throws InputError.
  Instance instance() const;
  /// The same, ready to be solved.
  operator Scene() const { return instance(); }

 private:
  using Placed = std::pair<std::string, JsonValue>;

  int dimension_;
  std::vector<std::string> points_;
  std::vector<std::string> lines_;
  std::vector<JsonValue> constraints_;
  std::vector<Placed> fixed_;
  std::vector<Placed> sketch_;
};

}  // namespace gcs
