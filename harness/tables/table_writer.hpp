#pragma once
/// Prints a Table as Markdown, CSV or LaTeX.

#include <span>
#include <string>
#include <string_view>

#include "harness/tables/table.hpp"

namespace gcs {

/// A pipe table with columns aligned for reading as plain text. Group titles are the header, column titles
/// the first row (Markdown has one header row only). Footnote marks look like [1].
std::string to_markdown(const Table& table);

/// RFC 4180 with "\n" line ends: the columns section, row label, one per column ("group: column"), and notes,
/// which holds the text of the footnotes of the row's entries; the entries carry no marks.
/// Remarks are left out.
std::string to_csv(const Table& table);

/// For booktabs; a table environment or, with more rows than a page has, a longtable. Everything that LaTeX
/// would interpret is escaped, and the mathematical characters that tables use become commands, so that the
/// output is ASCII where the text allows it.
std::string to_latex(const Table& table);

/// One output format: how it is asked for, its file extension (without a dot), and its writer.
struct TableFormat {
  std::string_view name;
  std::string_view extension;
  std::string (*write)(const Table&);
};

/// All formats, Markdown first.
std::span<const TableFormat> table_formats();

}  // namespace gcs
