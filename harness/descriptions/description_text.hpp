#pragma once
/// A description for a person.

#include <string>

#include "harness/descriptions/description.hpp"

namespace gcs {

std::string text_description(const Description& description);

}  // namespace gcs
