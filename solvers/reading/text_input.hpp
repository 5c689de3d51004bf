#pragma once
/// Reads whole inputs, whose every failure is a message for the user.

#include <cstddef>
#include <istream>
#include <string>

namespace gcs {

/// All of `stream`; `file` is for messages. Throws InputError when it cannot be read or does not end within
/// that many MiB.
std::string read_all(std::istream& stream, const std::string& file, std::size_t most_mib = 64);

/// All of a file. Throws InputError also when there is none, or it is larger than 4 GiB; `remedy` says what
/// to give in its place.
std::string read_file(const std::string& file, const std::string& remedy);

}  // namespace gcs
