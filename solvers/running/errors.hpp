#pragma once
/// What a caller has to hear of, and can mend: an input, an option or a place for a file that is not right.

#include <stdexcept>
#include <string>

namespace gcs {

/// what() is one message for a person: where, what is wrong, and what would be right.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is wrong with an input, where, and what would be right. what() is "FILE: /json/pointer: what; remedy".
class InputError : public UserError {
 public:
  InputError(std::string file, std::string pointer, std::string what, std::string remedy);
  const std::string& pointer() const { return pointer_; }

 private:
  std::string pointer_;
};

}  // namespace gcs
