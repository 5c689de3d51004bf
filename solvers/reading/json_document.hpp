#pragma once
/// Reads JSON.

#include <string>
#include <string_view>

#include "solvers/reading/json_value.hpp"
#include "solvers/running/errors.hpp"

namespace gcs {

struct ElementTaker;

/// Parses one JSON value. Refuses (InputError with the place): text that is not JSON, anything after the
/// value, duplicate keys, numbers that overflow a double or underflow to zero, nesting deeper than 64,
/// invalid UTF-8. `file` is only used in messages.
JsonValue parse_json(std::string_view text, const std::string& file);
/// The same, less what is taken.
JsonValue parse_json(std::string_view text, const std::string& file, const ElementTaker& taker);

}  // namespace gcs
