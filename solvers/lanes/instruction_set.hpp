#pragma once
/// The instruction sets that lanes are compiled for.

#include <string_view>

namespace gcs {

enum class InstructionSet { portable, avx2, avx512 };

std::string_view name(InstructionSet set);
/// Whether this machine and this build have it.
bool is_available(InstructionSet set);
/// The widest that is available.
InstructionSet widest_instruction_set();

}  // namespace gcs
