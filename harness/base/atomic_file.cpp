#include "harness/base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

namespace gcs {

namespace fs = std::filesystem;

namespace {

/// Where a link leads: replacing the link itself would leave its target as it was.
fs::path through_links(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real;
}

/// The name of a new file ends in six characters that mkostemps makes up, and this.
constexpr std::string_view unfinished = ".unfinished";
constexpr std::size_t made_up = 6;

bool is_unfinished(std::string_view name) {
  if (!name.ends_with(unfinished)) return false;
  name.remove_suffix(unfinished.size());
  if (name.size() < made_up + 2 || name[name.size() - made_up - 1] != '.') return false;
  const std::string_view characters = name.substr(name.size() - made_up);
  return std::ranges::all_of(characters, [](unsigned char c) { return std::isalnum(c) != 0; });
}

/// Whether somebody else took the new file for a leftover before it was locked. A file system that knows no
/// locks goes without.
bool is_taken(int descriptor) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno == EWOULDBLOCK;
  struct stat status {};
  return fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

/// Locked, since what nobody holds is a leftover.
int create_beside(const fs::path& target, fs::path& created) {
  std::string name = target.string() + ".XXXXXX" + std::string(unfinished);
  const int descriptor = mkostemps(name.data(), static_cast<int>(unfinished.size()), O_CLOEXEC);
  created = name;
  if (descriptor < 0) return descriptor;
  if (is_taken(descriptor)) {
    close(descriptor);
    return create_beside(target, created);
  }
  // mkstemp makes the file private; a result has the permissions of any new file.
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor, 0666 & ~mask);
  return descriptor;
}

}  // namespace

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

AtomicFile::AtomicFile(const fs::path& target) : named_(target), target_(through_links(target)) {
  std::error_code ignored;
  if (fs::is_directory(target_, ignored)) fail(EISDIR);
  const bool is_special = fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored);
  if (is_special) {
    written_ = target_;
    descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    if (fs::exists(target_, ignored) && access(target_.c_str(), W_OK) != 0) fail(errno);
    descriptor_ = create_beside(target_, written_);
  }
  if (descriptor_ < 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  if (written_ != target_) unlink(written_.c_str());
}

void AtomicFile::write(std::string_view text) {
  constexpr std::size_t most_kept = 1 << 20;
  kept_ += text;
  if (kept_.size() >= most_kept) flush();
}

void AtomicFile::flush() {
  if (const int error = write_all(descriptor_, kept_)) fail(error);
  kept_.clear();
}

void AtomicFile::commit(std::string_view text) {
  write(text);
  commit();
}

void AtomicFile::commit() {
  flush();
  // Some file systems report a full disk only now.
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);
  if (written_ != target_ && rename(written_.c_str(), target_.c_str()) != 0) fail(errno);
  close(descriptor_);
  descriptor_ = -1;
}

Output::Output(const std::string& place) {
  if (place != "-") file_.emplace(place);
}

void Output::write(std::string_view text) {
  if (file_)
    file_->write(text);
  else
    std::cout << text;
}

void Output::commit() {
  if (file_) file_->commit();
}

void Output::commit(std::string_view text) {
  write(text);
  commit();
}

void remove_leftovers(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> leftovers;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (is_unfinished(entry.path().filename().string())) leftovers.push_back(entry.path());
  for (const fs::path& leftover : leftovers) {
    const int descriptor = open(leftover.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) continue;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) fs::remove(leftover, ignored);
    close(descriptor);
  }
}

void AtomicFile::fail(int error) const {
  throw OutputError(named_.string() + ": cannot be written: " + std::generic_category().message(error));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + ": cannot be created: " + error.message());
}

}  // namespace gcs
