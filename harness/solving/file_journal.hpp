#pragma once
/// The journal of a solve in a file.
///
/// The file is one line of JSON, which says whose journal it is, and then one record for every step:
/// fingerprint, number of doubles, the doubles, checksum, in 8 bytes each as this machine stores them. A
/// record is written as soon as its step is done, so that a run that is killed loses the step in hand alone;
/// the torn record that it may leave at the end is dropped and overwritten.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "solvers/reading/json_document.hpp"
#include "solvers/running/journal.hpp"

namespace gcs {

class FileJournal final : public Journal {
 public:
  /// Opens `file`, which is made when it is missing, for the run that `identity` describes: an object, equal
  /// for runs whose steps are equal. Throws, and leaves the file as it was: InputError when it is no journal,
  /// or that of another run (the message names what differs); OutputError when it cannot be written or
  /// another process uses it.
  FileJournal(const std::filesystem::path& file, const JsonValue& identity);
  ~FileJournal() override;
  FileJournal(const FileJournal&) = delete;
  FileJournal& operator=(const FileJournal&) = delete;

  /// Throws InputError when the next record is damaged or of another step, OutputError when the disk is full.
  std::optional<Block> result(std::uint64_t fingerprint,
                              const std::function<std::optional<Block>()>& compute) override;

  /// Steps whose results were in the file.
  std::int64_t recalled() const { return recalled_; }

 private:
  struct Record;

  void start_or_check(const std::string& header);
  void check_header(const std::string& header);
  std::optional<Record> read_record();
  void append(std::uint64_t fingerprint, const Block& block);
  std::string read(std::uint64_t position, std::uint64_t count) const;
  /// How many there were.
  std::size_t read(std::uint64_t position, std::span<std::byte> bytes) const;
  void cut(std::uint64_t size);
  void write(std::string_view bytes);
  [[noreturn]] void fail_output(int error) const;
  [[noreturn]] void refuse(const std::string& what) const;

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;      ///< of the file, in bytes
  std::uint64_t position_ = 0;  ///< of the next record
  std::int64_t recalled_ = 0;
};

}  // namespace gcs
