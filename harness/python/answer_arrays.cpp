#include "harness/python/answer_arrays.hpp"

#include <algorithm>
#include <complex>
#include <vector>

#include "solvers/model/complex_lines.hpp"

namespace py = pybind11;

namespace gcs {
namespace {

using Complex = std::complex<double>;

bool are_real(const std::vector<Figure>& figures) { return std::ranges::all_of(figures, &Figure::is_real); }

template <typename Number>
py::array array_of(const std::vector<py::ssize_t>& shape, const std::vector<Complex>& numbers) {
  py::array_t<Number> result(shape);
  Number* entry = result.mutable_data();
  for (const Complex& number : numbers) {
    const Complex shown = number + Complex();  // no negative zeros
    if constexpr (std::is_same_v<Number, double>)
      *entry++ = shown.real();
    else
      *entry++ = shown;
  }
  return result;
}

/// k × elements × axes numbers, of each figure what `append(figure, numbers)` appends.
template <typename Append>
py::array array_of(const std::vector<Figure>& figures, std::size_t elements, int axes, Append append) {
  std::vector<Complex> numbers;
  for (const Figure& figure : figures) append(figure, numbers);
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(figures.size()),
                                 static_cast<py::ssize_t>(elements)};
  if (axes > 0) shape.push_back(axes);
  return are_real(figures) ? array_of<double>(shape, numbers) : array_of<Complex>(shape, numbers);
}

Complex plane_offset(const Figure& figure, std::size_t plane) {
  return {figure.planes[plane].offset,
          figure.imaginary_planes.empty() ? 0.0 : figure.imaginary_planes[plane].offset};
}

Complex plane_normal(const Figure& figure, std::size_t plane, int axis) {
  return {figure.planes[plane].normal[axis],
          figure.imaginary_planes.empty() ? 0.0 : figure.imaginary_planes[plane].normal[axis]};
}

}  // namespace

std::vector<Figure> placements(const Answer& answer) {
  std::vector<Figure> figures;
  for (const AssessedSolution& solution : answer.solutions) figures.push_back(solution.placement());
  return figures;
}

py::array point_array(const ProblemStatement& problem, const std::vector<Figure>& figures) {
  return array_of(figures, problem.points.size(), problem.dimension,
                  [&](const Figure& figure, std::vector<Complex>& numbers) {
                    const ComplexPoints points = complex_points(figure);
                    for (Eigen::Index i = 0; i < points.cols(); ++i)
                      for (int axis = 0; axis < problem.dimension; ++axis) numbers.push_back(points(axis, i));
                  });
}

py::dict line_arrays(const ProblemStatement& problem, const std::vector<Figure>& figures) {
  const auto array = [&](Eigen::Vector3cd ComplexLine::*part) {
    return array_of(figures, problem.lines.size(), problem.dimension,
                    [&](const Figure& figure, std::vector<Complex>& numbers) {
                      for (const ComplexLine& line : complex_lines(figure))
                        for (int axis = 0; axis < problem.dimension; ++axis)
                          numbers.push_back((line.*part)[axis]);
                    });
  };
  py::dict result;
  result["point"] = array(&ComplexLine::point);
  result["direction"] = array(&ComplexLine::direction);
  return result;
}

py::dict plane_arrays(const ProblemStatement& problem, const std::vector<Figure>& figures) {
  const std::size_t planes = problem.planes.size();
  py::dict result;
  result["normal"] = array_of(figures, planes, 3, [&](const Figure& figure, std::vector<Complex>& numbers) {
    for (std::size_t plane = 0; plane < planes; ++plane)
      for (int axis = 0; axis < 3; ++axis) numbers.push_back(plane_normal(figure, plane, axis));
  });
  result["offset"] = array_of(figures, planes, 0, [&](const Figure& figure, std::vector<Complex>& numbers) {
    for (std::size_t plane = 0; plane < planes; ++plane) numbers.push_back(plane_offset(figure, plane));
  });
  return result;
}

}  // namespace gcs
