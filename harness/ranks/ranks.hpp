#pragma once
/// The program as several ranks, when mpirun or srun starts it.

#include <string>

#include "harness/ranks/message_passing.hpp"

namespace gcs {

/// Null where the program was started alone. Throws UserError where it was not and this build has no message passing; of
/// the ranks one has a message in it then, the others have none.
const MessagePassing* start_ranks();

/// What ranks have to have in common so that their results are those of one process.
std::string build_of_program();

}  // namespace gcs
