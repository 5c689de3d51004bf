#pragma once
/// Where tables go: files in a folder, and the terminal.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "harness/tables/table_writer.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {

/// Writes every table as <name>.<extension> in every format, each file at once or not at all.
/// Throws OutputError.
void write_tables(const TableSet& set, const std::filesystem::path& folder,
                  std::span<const TableFormat> formats);

/// Writes tables alone, likewise. Throws OutputError.
void write_tables(std::span<const Table> tables, const std::filesystem::path& folder,
                  std::span<const TableFormat> formats = table_formats());

/// The tables as Markdown, then the lines.
std::string shown_on_terminal(std::span<const Table> tables, std::span<const std::string> lines);

/// Writes every drawing as <name>.svg into the folder, which is there, each file at once or not at all.
/// Throws OutputError.
void write_drawings(const std::vector<Drawing>& drawings, const std::filesystem::path& folder);

/// The tables and lines as Markdown; the list of measurements is left to the files.
std::string shown_on_terminal(const TableSet& set);

}  // namespace gcs
