#pragma once
/// Figures and answers as numpy arrays. Of k solutions the first axis has k entries, in the order of the answer; positions are in the
/// unit of the file or problem.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

/// Where the solutions are.
std::vector<Figure> placements(const Answer& answer);

/// Of k figures: k × n × d coordinates of the points, doubles where all figures are real, complex numbers otherwise.
pybind11::array point_array(const ProblemStatement& problem, const std::vector<Figure>& figures);

/// {"point": k × m × d, the one nearest to the origin, "direction": k × m × d, of length 1}.
pybind11::dict line_arrays(const ProblemStatement& problem, const std::vector<Figure>& figures);

/// {"normal": k × m × 3, of length 1, "offset": k × m}: normal·x = offset.
pybind11::dict plane_arrays(const ProblemStatement& problem, const std::vector<Figure>& figures);

/// One number for each solution, by `make(solution)`.
template <typename Number, typename Make>
pybind11::array_t<Number> number_array(const Answer& answer, Make make) {
  pybind11::array_t<Number> result(static_cast<pybind11::ssize_t>(answer.solutions.size()));
  auto entries = result.template mutable_unchecked<1>();
  pybind11::ssize_t i = 0;
  for (const AssessedSolution& solution : answer.solutions)
    entries(i++) = static_cast<Number>(make(solution));
  return result;
}

}  // namespace gcs
