#include "solvers/elements/given_elements.hpp"

#include <algorithm>
#include <cstdlib>

namespace gcs {
namespace {

/// The numbers of given positions, exactly as they are known.
class GivenNumbers {
 public:
  explicit GivenNumbers(const ProblemStatement& problem) : problem_(problem) {}

  std::vector<Decimal> of(int entity) const {
    const auto row = fixed_text_row(problem_, entity);
    std::vector<Decimal> numbers;
    if (problem_.is_point(entity)) {
      append(problem_.fixed_points[static_cast<std::size_t>(entity)]->head(problem_.dimension), row, numbers);
    } else if (problem_.is_line(entity)) {
      const LinePosition& line = *problem_.fixed_lines[static_cast<std::size_t>(problem_.line_of(entity))];
      append(line.point.head(problem_.dimension), row, numbers);
      append(line.direction.head(problem_.dimension), row + 1, numbers);
    } else {
      const PlanePosition& plane =
          *problem_.fixed_planes[static_cast<std::size_t>(problem_.plane_of(entity))];
      append(plane.normal, row, numbers);
      append(Eigen::Matrix<double, 1, 1>(plane.offset), row + 1, numbers);
    }
    return numbers;
  }

 private:
  void append(const Eigen::VectorXd& values, std::size_t row, std::vector<Decimal>& numbers) const {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const std::string text =
          row < problem_.fixed_texts.size() ? problem_.fixed_texts[row][static_cast<std::size_t>(i)] : "";
      numbers.push_back({text.empty() ? values[i] : std::strtod(text.c_str(), nullptr), text});
    }
  }

  const ProblemStatement& problem_;
};

}  // namespace

std::vector<BodyElement> given_elements(const ProblemStatement& problem) {
  const GivenNumbers numbers(problem);
  std::vector<BodyElement> elements;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity)) elements.push_back({entity, numbers.of(entity)});
  return elements;
}

ProblemStatement with_given_body(ProblemStatement problem) {
  if (!problem.is_anchored()) return problem;
  RigidBody given{"fixed", given_elements(problem)};
  for (RigidBody& body : problem.bodies)
    if (std::ranges::all_of(
            body.elements, [&](int entity) { return problem.is_fixed(entity); }, &BodyElement::entity))
      body.elements.clear();
  problem.reference_body = static_cast<int>(problem.bodies.size());
  problem.bodies.push_back(std::move(given));
  return problem;
}

bool has_element_equations(const ProblemStatement& problem) {
  return problem.is_general() ||
         std::ranges::any_of(problem.fixed_lines, [](const auto& line) { return line.has_value(); });
}

}  // namespace gcs
