#include "solvers/answers/assessed_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gcs {
namespace {

Eigen::Index index_of(const std::vector<std::string>& names, std::string_view name, std::string_view kind) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::out_of_range(fmt::format("there is no {} '{}'", kind, name));
  return found - names.begin();
}

void check_real(const AssessedSolution& solution) {
  if (!solution.is_real())
    throw std::domain_error("the solution is not real: ask is_real() first, or for complex_point()");
}

}  // namespace

std::shared_ptr<const FileTerms> file_terms(const Scene& scene) {
  return std::make_shared<const FileTerms>(FileTerms{scene.dimension(), scene.problem().points,
                                                     scene.problem().lines, scene.problem().planes,
                                                     scene.unit_exponent(), scene.problem().file_frame});
}

std::optional<double> AssessedSolution::error() const {
  if (!error_bound) return std::nullopt;
  const double scaled = std::ldexp(*error_bound, terms->unit_exponent);
  const bool is_rounded_down = std::ldexp(scaled, -terms->unit_exponent) < *error_bound;
  return is_rounded_down ? std::nextafter(scaled, std::numeric_limits<double>::max()) : scaled;
}

Eigen::VectorXcd AssessedSolution::complex_point(std::string_view name) const {
  const Eigen::Index i = index_of(terms->points, name, "point");
  const Figure placed = placement();
  Eigen::VectorXcd position = placed.points.col(i).head(terms->dimension).cast<std::complex<double>>();
  if (placed.imaginary.cols() > 0) position.imag() = placed.imaginary.col(i).head(terms->dimension);
  return position;
}

Eigen::VectorXd AssessedSolution::point(std::string_view name) const {
  const Eigen::VectorXcd position = complex_point(name);
  check_real(*this);
  return position.real();
}

LinePosition AssessedSolution::line(std::string_view name) const {
  const Eigen::Index i = index_of(terms->lines, name, "line");
  check_real(*this);
  return placement().lines[i];
}

PlanePosition AssessedSolution::plane(std::string_view name) const {
  const Eigen::Index i = index_of(terms->planes, name, "plane");
  check_real(*this);
  return placement().planes[i];
}

}  // namespace gcs
