#include "harness/tables/table_output.hpp"

#include <system_error>

#include "harness/base/atomic_file.hpp"

namespace gcs {

namespace {

void write_table(const Table& table, const std::filesystem::path& folder, const TableFormat& format) {
  AtomicFile(folder / (table.name + "." + std::string(format.extension))).commit(format.write(table));
}

}  // namespace

void write_tables(const TableSet& set, const std::filesystem::path& folder,
                  std::span<const TableFormat> formats) {
  write_tables(set.tables, folder, formats);
  write_tables(std::span(&set.measurements, 1), folder, formats);
}

void write_drawings(const std::vector<Drawing>& drawings, const std::filesystem::path& folder) {
  for (const Drawing& drawing : drawings) AtomicFile(folder / (drawing.name + ".svg")).commit(drawing.svg);
}

void write_tables(std::span<const Table> tables, const std::filesystem::path& folder,
                  std::span<const TableFormat> formats) {
  make_folder(folder);
  for (const TableFormat& format : formats)
    for (const Table& table : tables) write_table(table, folder, format);
}

std::string shown_on_terminal(std::span<const Table> tables, std::span<const std::string> lines) {
  std::string text;
  for (const Table& table : tables) {
    text += to_markdown(table);
    text += '\n';
  }
  for (const std::string& line : lines) {
    text += line;
    text += '\n';
  }
  return text;
}

std::string shown_on_terminal(const TableSet& set) { return shown_on_terminal(set.tables, set.lines); }

}  // namespace gcs
