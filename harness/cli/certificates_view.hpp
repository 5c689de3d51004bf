#pragma once
/// What is proven, as text.

#include <string>

#include "solvers/answers/assess.hpp"

namespace gcs {

/// A row for the certified solutions among `solutions`, one for the completeness of a list that claims to
/// hold all complex ones, and one for the generic lengths, where they are spoken of.
std::string certificates_text(const Proofs& proofs, std::size_t solutions, bool lists_all_complex);

}  // namespace gcs
