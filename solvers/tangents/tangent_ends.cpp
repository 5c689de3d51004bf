#include "solvers/tangents/tangent_ends.hpp"

#include <numbers>

#include "solvers/tangents/tangent_refinement.hpp"

namespace gcs {

PathRecord TangentEnds::take_failed(const std::string& cause) {
  line_of_path_.emplace_back();
  return {PathRecord::End::failed, cause, 0, {}};
}

PathRecord TangentEnds::take_infinite(int winding_number) {
  line_of_path_.emplace_back();
  ++to_infinity_;
  return {PathRecord::End::at_infinity, "", 0, {}, winding_number, 0};
}

PathRecord TangentEnds::take(const ComplexTangent& line, int winding_number) {
  line_of_path_.emplace_back();
  if (winding_number == 1 && take_simple(line)) return {PathRecord::End::regular, "", 0, {}, 1, 0};
  if (take_multiple(line)) return {PathRecord::End::singular, "", 0, {}, winding_number, 0};
  return {PathRecord::End::failed, "the line where it ends is no common tangent to rounding", 0, {}};
}

FoundTangents TangentEnds::lines() const {
  FoundTangents result;
  for (std::size_t i = 0; i < found_.lines.size(); ++i) {
    FoundTangent line = found_.lines[i];
    line.multiplicity = singular_ends_[i] == 0 ? 1 : singular_ends_[i] / 2;
    if (line.multiplicity > 0) result.lines.push_back(line);
  }
  result.at_infinity = to_infinity_ / 2;
  return result;
}

template <class Scalar>
bool TangentEnds::refined(Tangent<Scalar>& line) {
  const TangentRefinement refinement = refine(spheres_, line);
  work_.newton_iterations += refinement.iterations;
  return refinement.is_regular;
}

/// In R where the line is real.
bool TangentEnds::take_simple(ComplexTangent line) {
  if (!refined(line)) return false;
  Tangent<double> real{line.point.real(), line.direction.real()};
  const bool is_real = is_nearly_real(line) && refined(real);
  if (is_real) line = {real.point.cast<std::complex<double>>(), real.direction.cast<std::complex<double>>()};
  if (!found_.find(line)) add({line, is_real, 1}, 0);
  line_of_path_.back() = line;
  return true;
}

bool TangentEnds::take_multiple(const ComplexTangent& line) {
  const auto found = multiple_tangent(spheres_, line, is_nearly_real(line), 1);
  if (!found) return false;
  if (const auto known = found_.find(found->line))
    ++singular_ends_[*known];
  else
    add(*found, 1);
  return true;
}

void TangentEnds::add(const FoundTangent& line, int singular_ends) {
  found_.lines.push_back(line);
  singular_ends_.push_back(singular_ends);
}

std::complex<double> random_phase(std::mt19937_64& random) {
  return std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(random() >> 11U) * 0x1p-53);
}

}  // namespace gcs
