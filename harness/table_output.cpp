#include "harness/table_output.hpp"

#include <system_error>

#include "harness/atomic_file.hpp"

namespace gcs {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(folder.string() + ": cannot be created: " + error.message());
}

void write_tables(const TableSet& set, const std::filesystem::path& folder,
                  std::span<const TableFormat> formats) {
  make_folder(folder);
  for (const TableFormat& format : formats) {
    const auto write = [&](const Table& table) {
      AtomicFile(folder / (table.name + "." + std::string(format.extension))).commit(format.write(table));
    };
    for (const Table& table : set.tables) write(table);
    write(set.measurements);
  }
  for (const Drawing& drawing : set.drawings)
    AtomicFile(folder / (drawing.name + ".svg")).commit(drawing.svg);
}

std::string shown_on_terminal(const TableSet& set) {
  std::string text;
  for (const Table& table : set.tables) {
    text += to_markdown(table);
    text += '\n';
  }
  for (const std::string& line : set.lines) {
    text += line;
    text += '\n';
  }
  return text;
}

}  // namespace gcs
