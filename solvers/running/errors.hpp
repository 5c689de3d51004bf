#pragma once
/// What a caller has to hear of, and can mend: an input, an option or a place for a file that is not right.

#include <stdexcept>

namespace gcs {

/// what() is one message for a person: where, what is wrong, and what would be right.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gcs
