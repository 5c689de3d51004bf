#pragma once
/// Who takes the elements of a long list one by one, so that a document need not hold them.

#include <cstddef>
#include <functional>
#include <string_view>

#include "solvers/reading/json_value.hpp"

namespace gcs {

struct ElementTaker {
  std::string_view list = {};  ///< the member of the document that is the list
  /// The document as far as it is read, an element, and its number in the list. Returns whether it is taken; otherwise it
  /// stays in the document. None: all stay.
  std::function<bool(const JsonValue& document, const JsonValue& element, std::size_t number)> take = {};
};

}  // namespace gcs
