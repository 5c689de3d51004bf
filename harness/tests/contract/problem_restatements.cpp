#include "harness/tests/contract/problem_restatements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gcs::contract {
namespace {

std::vector<int> identity(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<int> random_order(std::size_t count, std::mt19937_64& random) {
  std::vector<int> order = identity(count);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

Restatement unchanged(std::string name, const ProblemStatement& problem) {
  return {std::move(name), problem, identity(problem.points.size())};
}

/// Entities that are points get new numbers; lines and absent entities (−1) keep theirs.
struct Renumbering {
  const std::vector<int>& now;

  void apply(int& entity) const {
    if (entity >= 0 && entity < static_cast<int>(now.size())) entity = now[entity];
  }
};

template <class Value>
std::vector<Value> reordered(const std::vector<Value>& values, const std::vector<int>& now) {
  std::vector<Value> result = values;
  for (std::size_t i = 0; i < std::min(values.size(), now.size()); ++i) result[now[i]] = values[i];
  return result;
}

Figure reordered(const Figure& figure, const std::vector<int>& now) {
  Figure result = figure;
  for (std::size_t i = 0; i < now.size(); ++i) result.points.col(now[i]) = figure.points.col(i);
  return result;
}

void renumber(Reference& reference, const Renumbering& renumbering) {
  for (int* entity : {&reference.origin, &reference.axis, &reference.plane, &reference.height})
    renumbering.apply(*entity);
}

void renumber(PlanStep& step, const Renumbering& renumbering) {
  renumbering.apply(step.place);
  for (PlanStep::Radius& radius : step.from) renumbering.apply(radius.from);
}

void mirror(Eigen::Vector3d& point) { point.x() = -point.x(); }

void mirror(LinePosition& line) {
  mirror(line.point);
  mirror(line.direction);
}

void mirror(Figure& figure) {
  figure.points.row(0) *= -1;
  if (!figure.is_real()) figure.imaginary.row(0) *= -1;
  for (auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (LinePosition& line : *lines) mirror(line);
  for (auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (PlanePosition& plane : *planes) mirror(plane.normal);
}

void negate(Decimal& number) {
  number.value = -number.value;
  if (!number.text.empty())
    number.text = number.text.starts_with('-') ? number.text.substr(1) : "-" + number.text;
}

void scale(Decimal& number, int exponent) {
  number.value = std::ldexp(number.value, exponent);
  if (!number.text.empty()) number.text = times_power_of_two(number.text, exponent);
}

/// Of a body's element the numbers that are along x, and those that are lengths.
std::vector<std::size_t> along_x(const ProblemStatement& problem, const BodyElement& element) {
  if (problem.is_line(element.entity)) return {0, static_cast<std::size_t>(problem.dimension)};
  return {0};
}
std::vector<std::size_t> lengths(const ProblemStatement& problem, const BodyElement& element) {
  if (problem.is_plane(element.entity)) return {element.numbers.size() - 1};
  std::vector<std::size_t> numbers(static_cast<std::size_t>(problem.dimension));
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// Changes the chosen numbers of all elements of bodies.
template <class Choose, class Change>
void change_bodies(ProblemStatement& problem, const Choose& choose, const Change& change) {
  const ProblemStatement& kinds = problem;
  for (RigidBody& body : problem.bodies)
    for (BodyElement& element : body.elements)
      for (const std::size_t i : choose(kinds, element)) change(element.numbers[i]);
}

void scale(Eigen::Vector3d& point, double factor) { point *= factor; }

void scale(LinePosition& line, double factor) { line.point *= factor; }

void scale(Figure& figure, double factor) {
  figure.points *= factor;
  for (LinePosition& line : figure.lines) scale(line, factor);
  for (PlanePosition& plane : figure.planes) plane.offset *= factor;
}

/// digits · factor for digits in base ten, least significant first.
void multiply(std::vector<int>& digits, int factor) {
  int carry = 0;
  for (int& digit : digits) {
    carry += digit * factor;
    digit = carry % 10;
    carry /= 10;
  }
  if (carry > 0) digits.push_back(carry);
}

Decimal decimal(double value) { return {value, fmt::format("{}", value)}; }

}  // namespace

Figure Restatement::original(const Figure& figure) const {
  Figure result = figure;
  for (std::size_t i = 0; i < point_now.size(); ++i) {
    result.points.col(i) = figure.points.col(point_now[i]);
    if (!figure.is_real()) result.imaginary.col(i) = figure.imaginary.col(point_now[i]);
  }
  if (is_mirrored) mirror(result);
  return result;
}

Restatement relabelled(const ProblemStatement& problem, std::mt19937_64& random) {
  Restatement result = unchanged("relabelled", problem);
  result.point_now = random_order(problem.points.size(), random);
  const Renumbering renumbering{result.point_now};
  ProblemStatement& restated = result.problem;
  for (std::size_t i = 0; i < restated.points.size(); ++i) restated.points[i] = fmt::format("node {}", i);
  for (DistanceConstraint& constraint : restated.constraints)
    for (int& end : constraint.between) renumbering.apply(end);
  for (Relation& relation : restated.relations)
    for (Operand& operand : relation.of) {
      renumbering.apply(operand.entity);
      renumbering.apply(operand.end);
    }
  for (RigidBody& body : restated.bodies)
    for (BodyElement& element : body.elements) renumbering.apply(element.entity);
  if (!problem.fixed_points.empty())
    restated.fixed_points = reordered(problem.fixed_points, result.point_now);
  restated.fixed_texts = reordered(problem.fixed_texts, result.point_now);
  if (restated.reference) renumber(*restated.reference, renumbering);
  if (restated.sketch) restated.sketch = reordered(*problem.sketch, result.point_now);
  for (PlanStep& step : restated.construction) renumber(step, renumbering);
  return result;
}

Restatement constraints_permuted(const ProblemStatement& problem, std::mt19937_64& random) {
  Restatement result = unchanged("constraints permuted", problem);
  const std::vector<int> now = random_order(problem.constraints.size(), random);
  const Renumbering renumbering{now};
  ProblemStatement& restated = result.problem;
  restated.constraints = reordered(problem.constraints, now);
  int& bent = restated.interpolation.bent;
  if (bent < 0) bent = static_cast<int>(now.size()) - 1;
  renumbering.apply(bent);
  if (restated.interpolation.bends)
    for (BentLength& length : *restated.interpolation.bends) renumbering.apply(length.constraint);
  for (PlanStep& step : restated.construction)
    for (PlanStep::Radius& radius : step.from) renumbering.apply(radius.constraint);
  return result;
}

Restatement mirrored(const ProblemStatement& problem) {
  Restatement result = unchanged("mirrored", problem);
  result.is_mirrored = true;
  if (result.problem.sketch) mirror(*result.problem.sketch);
  for (auto& point : result.problem.fixed_points)
    if (point) mirror(*point);
  for (auto& texts : result.problem.fixed_texts)
    if (!texts[0].empty()) texts[0] = texts[0].starts_with('-') ? texts[0].substr(1) : "-" + texts[0];
  for (auto& line : result.problem.fixed_lines)
    if (line) mirror(*line);
  change_bodies(result.problem, along_x, negate);
  for (Relation& relation : result.problem.relations) relation.sign = -relation.sign;
  return result;
}

Restatement ends_swapped(const ProblemStatement& problem) {
  Restatement result = unchanged("ends swapped", problem);
  for (DistanceConstraint& constraint : result.problem.constraints)
    std::swap(constraint.between[0], constraint.between[1]);
  return result;
}

/// Whether a row of fixed_texts has lengths, and not a direction or a normal.
bool is_length(const ProblemStatement& problem, std::size_t row) {
  if (row < problem.points.size()) return true;
  const std::size_t place = row - problem.points.size();
  return (place % 2 == 0) == (place < 2 * problem.lines.size());
}

Restatement scaled(const ProblemStatement& problem, int exponent) {
  Restatement result = unchanged("scaled", problem);
  result.is_exact = true;
  result.unit_exponent = exponent;
  const double factor = std::ldexp(1.0, exponent);
  ProblemStatement& restated = result.problem;
  for (DistanceConstraint& constraint : restated.constraints) {
    const int power = constraint.is_squared ? 2 * exponent : exponent;
    scale(constraint.given, power);
  }
  for (Relation& relation : restated.relations) {
    if (relation.form == Relation::Form::length) scale(relation.given, exponent);
    if (relation.form == Relation::Form::squared) scale(relation.given, 2 * exponent);
  }
  change_bodies(restated, lengths, [exponent](Decimal& number) { scale(number, exponent); });
  if (restated.sketch) scale(*restated.sketch, factor);
  for (auto& point : restated.fixed_points)
    if (point) scale(*point, factor);
  for (std::size_t row = 0; row < restated.fixed_texts.size(); ++row)
    for (std::string& text : restated.fixed_texts[row])
      if (!text.empty() && is_length(restated, row)) text = times_power_of_two(text, exponent);
  for (auto& line : restated.fixed_lines)
    if (line) scale(*line, factor);
  restated.interpolation.bend *= factor;
  if (restated.interpolation.bends)
    for (BentLength& length : *restated.interpolation.bends)
      for (double& coefficient : length.coefficients) coefficient *= factor;
  return result;
}

ProblemStatement with_random_targets(ProblemStatement problem, std::mt19937_64& random) {
  double longest = 0;
  for (const DistanceConstraint& constraint : problem.constraints)
    longest = std::max(longest, constraint.length());
  std::uniform_real_distribution<double> offset(-longest / 6, longest / 6);
  Eigen::Matrix3Xd points = problem.sketch->points;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    for (int axis = 0; axis < problem.dimension; ++axis) points(axis, i) += offset(random);
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    const double distance = (points.col(a) - points.col(b)).norm();
    constraint.given = decimal(constraint.is_squared ? distance * distance : distance);
  }
  std::uniform_real_distribution<double> bend(longest / 20, longest / 4);
  std::uniform_int_distribution<int> bent(0, static_cast<int>(problem.constraints.size()) - 1);
  problem.interpolation = {bent(random), bend(random)};
  return problem;
}

std::string times_power_of_two(const std::string& decimal, int exponent) {
  if (decimal.starts_with('-')) return "-" + times_power_of_two(decimal.substr(1), exponent);
  std::vector<int> digits;
  std::size_t places = 0;
  for (std::size_t i = 0; i < decimal.size(); ++i) {
    if (decimal[i] == '.')
      places = decimal.size() - 1 - i;
    else
      digits.insert(digits.begin(), decimal[i] - '0');
  }
  for (int i = 0; i < std::abs(exponent); ++i) multiply(digits, exponent > 0 ? 2 : 5);
  if (exponent < 0) places += static_cast<std::size_t>(-exponent);  // half of x is five tenths of x
  digits.resize(std::max(digits.size(), places + 1), 0);
  std::string result;
  for (std::size_t i = digits.size(); i-- > 0;) {
    result += static_cast<char>('0' + digits[i]);
    if (i == places && places > 0) result += '.';
  }
  return result;
}

}  // namespace gcs::contract
