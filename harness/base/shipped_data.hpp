#pragma once
/// Where the data that ship with the program are: instances, published figures, reference solutions.

#include <filesystem>
#include <optional>
#include <vector>

namespace gcs {

/// Folders laid out like the source folder, in the order in which they are searched: the working directory,
/// share/gcsbench of the prefix that the program was installed in, the source folder that it was built from.
std::vector<std::filesystem::path> data_folders();

/// The first regular file of that path below a data folder.
std::optional<std::filesystem::path> shipped_file(const std::filesystem::path& below);

}  // namespace gcs
