#pragma once
/// Long lists of complex vectors in JSON, read many times faster than as JSON values with their texts.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/lanes/square_system.hpp"

namespace gcs {

/// A JSON text without one of its arrays.
struct ComplexRows {
  std::string rest;  ///< the text with [] for the array: JSON if and only if the whole text was
  std::vector<ComplexVectorX> rows;
};

/// Takes out the first array that is the value of a member `name`, wherever that stands. Nothing where there
/// is none or where it is anything but rows of `size` pairs [re, im] of JSON numbers within the range of
/// doubles: then the text is to be parsed as it stands, which also says what is wrong with it.
std::optional<ComplexRows> take_complex_rows(std::string_view text, std::string_view name, int size);

}  // namespace gcs
