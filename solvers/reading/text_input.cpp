#include "solvers/reading/text_input.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "solvers/reading/json_document.hpp"

namespace gcs {

namespace fs = std::filesystem;

namespace {

/// Instances have less than a megabyte, tens of thousands of solutions tens of them. Endless input must end;
/// a file ends by itself, and results may be asked for that are larger.
constexpr std::size_t most_of_file_mib = 4096;

}  // namespace

std::string read_all(std::istream& stream, const std::string& file, std::size_t most_mib) {
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most_mib << 20)
      throw InputError(file, "", "the input is larger than " + std::to_string(most_mib) + " MiB",
                       "this cannot be what is asked for");
  }
  if (stream.bad()) throw InputError(file, "", std::string("cannot be read: ") + std::strerror(errno), "");
  return text;
}

std::string read_file(const std::string& file, const std::string& remedy) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputError(file, "", "there is no such file", remedy);
  if (fs::is_directory(status)) throw InputError(file, "", "this is a directory", "name a file in it");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError(file, "", std::string("cannot be opened: ") + std::strerror(errno),
                     "give a readable file");
  }
  return fs::is_regular_file(status) ? read_all(stream, file, most_of_file_mib) : read_all(stream, file);
}

}  // namespace gcs
