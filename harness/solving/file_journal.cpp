#include "harness/solving/file_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>

#include "harness/base/atomic_file.hpp"
#include "solvers/numeric/digest.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

namespace {

constexpr std::string_view format_name = "gcsbench-journal/1";
constexpr std::uint64_t word = sizeof(std::uint64_t);

std::string header_line(const JsonValue& identity) {
  JsonValue header = json_object({{"format", json_text(std::string(format_name))}});
  header.members.insert(header.members.end(), identity.members.begin(), identity.members.end());
  return to_text(header, -1) + "\n";
}

/// Numbers as they lie in memory; of none, nothing.
template <typename Numbers>
std::string_view bytes_of(const Numbers& numbers) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(numbers));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint64_t checksum(std::uint64_t fingerprint, std::span<const double> block) {
  Digest digest;
  digest.add(fingerprint);
  digest.add(block.size());
  digest.add(block);
  return digest.value();
}

/// The members of two objects that differ, in words.
std::string differences(const JsonValue& there, const JsonValue& here) {
  std::string names;
  for (const auto& [name, value] : here.members) {
    const JsonValue* other = there.find(name);
    if (!other || to_text(*other, -1) != to_text(value, -1)) names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace

struct FileJournal::Record {
  std::uint64_t fingerprint = 0;
  Block block;
};

FileJournal::FileJournal(const std::filesystem::path& file, const JsonValue& identity)
    : name_(file.string()), descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail_output(errno);
  try {
    start_or_check(header_line(identity));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

FileJournal::~FileJournal() { close(descriptor_); }

void FileJournal::start_or_check(const std::string& header) {
  // A file system that knows no locks goes without.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw OutputError(name_ + ": cannot be written: another run uses this journal");
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail_output(errno);
  if (!S_ISREG(status.st_mode)) throw OutputError(name_ + ": cannot be written: a journal is a regular file");
  size_ = static_cast<std::uint64_t>(status.st_size);
  const bool is_torn = size_ < header.size() && header.starts_with(read(0, size_));
  if (is_torn) {
    cut(0);
    write(header);
  } else {
    check_header(header);
  }
  position_ = header.size();
}

void FileJournal::check_header(const std::string& header) {
  const std::string begin = header.substr(0, header.find(','));  // the format
  if (read(0, begin.size()) != begin)
    throw InputError(name_, "", fmt::format("this is no journal of the format {}", format_name),
                     "give --resume a file that is not there yet, or the journal of the run to go on with");
  // The line of another run may be longer or shorter.
  if (read(0, header.size()) == header) return;
  const std::string text = read(0, size_);
  const std::string line = text.substr(0, text.find('\n'));
  refuse("this is the journal of another run; what differs: " +
         differences(parse_json(line, name_), parse_json(header, name_)));
}

std::optional<Journal::Block> FileJournal::result(std::uint64_t fingerprint,
                                                  const std::function<std::optional<Block>()>& compute) {
  if (std::optional<Record> record = read_record()) {
    if (record->fingerprint != fingerprint)
      refuse(fmt::format("step {} of this journal is another one than this run's", recalled_ + 1));
    position_ += (record->block.size() + 3) * word;
    ++recalled_;
    return std::move(record->block);
  }
  std::optional<Block> block = compute();
  if (block) append(fingerprint, *block);
  return block;
}

/// Nothing at the end of the file, or before a torn record.
std::optional<FileJournal::Record> FileJournal::read_record() {
  const std::uint64_t left = size_ - position_;
  if (left < 3 * word) return std::nullopt;
  std::array<std::uint64_t, 2> head{};
  read(position_, std::as_writable_bytes(std::span(head)));
  const auto [fingerprint, count] = head;
  if (count > left / word - 3) return std::nullopt;
  Record record{fingerprint, Block(count)};
  read(position_ + sizeof head, std::as_writable_bytes(std::span(record.block)));
  std::array<std::uint64_t, 1> sum{};
  read(position_ + sizeof head + count * word, std::as_writable_bytes(std::span(sum)));
  if (sum.front() == checksum(fingerprint, record.block)) return record;
  const bool is_last = left == (count + 3) * word;
  if (!is_last) refuse(fmt::format("the journal is damaged at byte {}", position_));
  return std::nullopt;
}

void FileJournal::append(std::uint64_t fingerprint, const Block& block) {
  cut(position_);
  const std::array<std::uint64_t, 2> head{fingerprint, block.size()};
  const std::array<std::uint64_t, 1> foot{checksum(fingerprint, block)};
  std::string bytes;
  bytes.append(bytes_of(head)).append(bytes_of(block)).append(bytes_of(foot));
  write(bytes);
  position_ = size_;
}

std::string FileJournal::read(std::uint64_t position, std::uint64_t count) const {
  std::string bytes(count, '\0');
  bytes.resize(read(position, std::as_writable_bytes(std::span(bytes))));
  return bytes;
}

std::size_t FileJournal::read(std::uint64_t position, std::span<std::byte> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t some =
        pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(position + done));
    if (some < 0 && errno == EINTR) continue;
    if (some < 0) throw InputError(name_, "", std::string("cannot be read: ") + std::strerror(errno), "");
    if (some == 0) break;
    done += static_cast<std::size_t>(some);
  }
  return done;
}

void FileJournal::cut(std::uint64_t size) {
  if (size_ > size && ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail_output(errno);
  size_ = size;
}

void FileJournal::write(std::string_view bytes) {
  if (const int error = write_all(descriptor_, bytes)) fail_output(error);
  size_ += bytes.size();
}

void FileJournal::fail_output(int error) const {
  throw OutputError(name_ + ": cannot be written: " + std::generic_category().message(error));
}

void FileJournal::refuse(const std::string& what) const {
  throw InputError(name_, "", what, "give --resume another file, or remove this one to start again");
}

}  // namespace gcs
