#include "solvers/running/errors.hpp"

#include <utility>

namespace gcs {

InputError::InputError(std::string file, std::string pointer, std::string what, std::string remedy)
    : UserError(file + ": " + (pointer.empty() ? "" : pointer + ": ") + what +
                (remedy.empty() ? "" : "; " + remedy)),
      pointer_(std::move(pointer)) {}

}  // namespace gcs
