#pragma once
/// Writes a file all at once or not at all.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "harness/base/errors.hpp"

namespace gcs {

/// Writes all of `text`. Returns 0 or the error number.
int write_all(int descriptor, std::string_view text);

/// A file that will be written later. Creating one proves that the place can be written, before hours of
/// work; a file that is there already keeps its content until commit().
class AtomicFile {
 public:
  /// Throws OutputError when `target` cannot be written.
  explicit AtomicFile(const std::filesystem::path& target);
  /// Without commit(): leaves everything as it was.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends to what will be the content; of a target that is no regular file it is written before
  /// commit(). Throws OutputError when that fails.
  void write(std::string_view text);
  /// Replaces the target's content by what was written. Call once, last. Throws OutputError when that fails;
  /// then nothing has changed.
  void commit();
  /// The same, with `text` written first.
  void commit(std::string_view text);

 private:
  void flush();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path named_;   ///< as the user named it, for messages
  std::filesystem::path target_;  ///< with links followed
  /// A new file beside the target, or the target when that is no regular file.
  std::filesystem::path written_;
  int descriptor_ = -1;
  std::string kept_{};  ///< written, and not yet in the file
};

/// A file that will be written later, or standard output, which "-" stands for.
class Output {
 public:
  /// Throws OutputError when the file cannot be written.
  explicit Output(const std::string& place);

  /// As of AtomicFile.
  void write(std::string_view text);
  void commit();
  void commit(std::string_view text);

 private:
  std::optional<AtomicFile> file_;  ///< empty: standard output
};

/// Creates the folder with its parents unless it is there. Throws OutputError.
void make_folder(const std::filesystem::path& folder);

/// Removes the new files that killed processes left in the folder before they were renamed: those that no
/// process holds.
void remove_leftovers(const std::filesystem::path& folder);

}  // namespace gcs
