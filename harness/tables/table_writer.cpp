#include "harness/tables/table_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/base/text_width.hpp"

namespace gcs {
namespace {

using Lines = std::vector<std::vector<std::string>>;

/// What is replaced, and by what.
using Replacement = std::pair<std::string_view, std::string_view>;

std::string replace_all(std::string_view text, std::span<const Replacement> rules) {
  std::string result;
  while (!text.empty()) {
    const auto rule =
        std::find_if(rules.begin(), rules.end(), [&](const auto& r) { return text.starts_with(r.first); });
    if (rule == rules.end()) {
      result += text.front();
      text.remove_prefix(1);
    } else {
      result += rule->second;
      text.remove_prefix(rule->first.size());
    }
  }
  return result;
}

// ---- Markdown

std::string markdown_escaped(std::string_view text) {
  static constexpr auto rules = std::to_array<Replacement>({{"|", "\\|"}, {"\n", " "}});
  return replace_all(text, rules);
}

std::string with_marks(std::string text, const std::vector<int>& notes) {
  for (const int note : notes) text += fmt::format(" [{}]", note + 1);
  return text;
}

/// Group titles above the first column of each group.
std::vector<std::string> group_title_line(const Table& table) {
  std::vector<std::string> line{markdown_escaped(table.stub)};
  for (const ColumnGroup& group : table.groups) {
    line.push_back(markdown_escaped(group.title));
    line.insert(line.end(), group.columns.size() - 1, "");
  }
  return line;
}

std::vector<std::string> column_title_line(const Table& table) {
  std::vector<std::string> line{""};
  for (const ColumnGroup& group : table.groups) {
    std::transform(group.columns.begin(), group.columns.end(), std::back_inserter(line), markdown_escaped);
  }
  return line;
}

std::vector<std::string> row_line(const Table& table, const TableRow& row) {
  const std::string label = with_marks(markdown_escaped(row.label), row.notes);
  std::vector<std::string> line{row.is_heading() ? "**" + label + "**" : label};
  for (const TableCell& cell : row.cells) line.push_back(with_marks(markdown_escaped(cell.text), cell.notes));
  line.resize(static_cast<std::size_t>(table.column_count()) + 1);
  return line;
}

bool has_column_titles(const Table& table) {
  return std::any_of(table.groups.begin(), table.groups.end(), [](const ColumnGroup& group) {
    return group.columns.size() > 1 || !group.columns.front().empty();
  });
}

std::vector<std::size_t> column_widths(const Lines& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 3);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], display_width(line[c]));
  }
  return widths;
}

std::string pipe_line(const std::vector<std::string>& line, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t c = 0; c < line.size(); ++c) {
    const std::string padding(widths[c] - display_width(line[c]), ' ');
    text += c == 0 ? fmt::format(" {}{} |", line[c], padding) : fmt::format(" {}{} |", padding, line[c]);
  }
  return text + "\n";
}

/// Labels to the left, entries to the right.
std::string rule_line(const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const std::string dashes(widths[c] - 1, '-');
    text += c == 0 ? fmt::format(" :{} |", dashes) : fmt::format(" {}: |", dashes);
  }
  return text + "\n";
}

// ---- CSV

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  static constexpr auto rules = std::to_array<Replacement>({{"\"", "\"\""}});
  return '"' + replace_all(text, rules) + '"';
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) {
    line += csv_field(field);
    line += ',';
  }
  line.back() = '\n';
  return line;
}

std::vector<std::string> csv_header(const Table& table) {
  std::vector<std::string> header{"section", table.stub.empty() ? "row" : table.stub};
  for (const ColumnGroup& group : table.groups) {
    for (const std::string& column : group.columns) {
      header.push_back(column.empty() ? group.title : group.title + ": " + column);
    }
  }
  header.emplace_back("notes");
  return header;
}

std::string notes_of(const Table& table, const TableRow& row) {
  std::vector<int> notes = row.notes;
  for (const TableCell& cell : row.cells) notes.insert(notes.end(), cell.notes.begin(), cell.notes.end());
  std::sort(notes.begin(), notes.end());
  notes.erase(std::unique(notes.begin(), notes.end()), notes.end());
  std::string text;
  for (const int note : notes) text += (text.empty() ? "" : " ") + table.footnotes[note];
  return text;
}

// ---- LaTeX

/// A float of more would run off the page.
constexpr std::size_t latex_rows_on_a_page = 45;

std::string latex_escaped(std::string_view text) {
  static constexpr auto rules = std::to_array<Replacement>({
      {"\\", "\\textbackslash{}"},
      {"{", "\\{"},
      {"}", "\\}"},
      {"$", "\\$"},
      {"&", "\\&"},
      {"#", "\\#"},
      {"%", "\\%"},
      {"_", "\\_"},
      {"^", "\\textasciicircum{}"},
      {"~", "\\textasciitilde{}"},
      {"<", "\\textless{}"},
      {">", "\\textgreater{}"},
      {"|", "\\textbar{}"},
      {"\n", " "},
      {"δ", "$\\delta$"},
      {"α", "$\\alpha$"},
      {"β", "$\\beta$"},
      {"γ", "$\\gamma$"},
      {"θ", "$\\theta$"},
      {"ε", "$\\varepsilon$"},
      {"°", "$^\\circ$"},
      {"×", "$\\times$"},
      {"±", "$\\pm$"},
      {"≤", "$\\le$"},
      {"≥", "$\\ge$"},
      {"≠", "$\\ne$"},
      {"−", "$-$"},
      {"·", "$\\cdot$"},
      {"--", "-{}-"},
      {"–", "--"},
      {"—", "---"},
      {"…", "\\dots{}"},
      {"µ", "$\\mu$"},
      {"²", "$^2$"},
      {"∞", "$\\infty$"},
      {"’", "'"},
  });
  return replace_all(text, rules);
}

std::string latex_marked(const std::string& text, const std::vector<int>& notes) {
  if (notes.empty()) return latex_escaped(text);
  std::string marks;
  for (const int note : notes) marks += fmt::format("[{}]", note + 1);
  return fmt::format("{}\\textsuperscript{{{}}}", latex_escaped(text), marks);
}

std::string latex_header(const Table& table) {
  std::string titles = latex_escaped(table.stub);
  std::string rules;
  std::string columns;
  int first = 2;
  for (const ColumnGroup& group : table.groups) {
    const int last = first + static_cast<int>(group.columns.size()) - 1;
    titles +=
        fmt::format(" & \\multicolumn{{{}}}{{c}}{{{}}}", group.columns.size(), latex_escaped(group.title));
    rules += fmt::format("\\cmidrule(lr){{{}-{}}}", first, last);
    for (const std::string& column : group.columns) columns += " & " + latex_escaped(column);
    first = last + 1;
  }
  const std::string group_line = titles + " \\\\\n";
  return has_column_titles(table) ? group_line + rules + "\n" + columns + " \\\\\n" : group_line;
}

std::string latex_row(const Table& table, const TableRow& row) {
  const std::string label = latex_marked(row.label, row.notes);
  if (row.is_heading()) {
    return fmt::format("\\addlinespace\n\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\\n",
                       table.column_count() + 1, label);
  }
  std::string line = label;
  for (const TableCell& cell : row.cells) line += " & " + latex_marked(cell.text, cell.notes);
  return line + " \\\\\n";
}

std::string latex_title(const Table& table) {
  return fmt::format("\\caption{{{}}}\n\\label{{tab:{}}}", latex_escaped(table.caption), table.name);
}

std::string latex_rows(const Table& table) {
  std::string text;
  for (const TableRow& row : table.rows) text += latex_row(table, row);
  return text;
}

/// Up to its notes, which stand within it.
std::string latex_float(const Table& table) {
  return fmt::format(
      "\\begin{{table}}\n\\centering\n{}\n\\begin{{tabular}}{{l{}}}\n\\toprule\n{}\\midrule\n{}\\bottomrule\n"
      "\\end{{tabular}}\n",
      latex_title(table), std::string(table.column_count(), 'r'), latex_header(table), latex_rows(table));
}

/// The header stands on every page.
std::string latex_pages(const Table& table) {
  const std::string header = fmt::format("\\toprule\n{}\\midrule\n", latex_header(table));
  return fmt::format(
      "\\begin{{longtable}}{{l{}}}\n{} \\\\\n{}\\endfirsthead\n{}\\endhead\n\\bottomrule\n\\endfoot\n{}"
      "\\end{{longtable}}\n",
      std::string(table.column_count(), 'r'), latex_title(table), header, header, latex_rows(table));
}

std::string latex_notes(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.footnotes.size(); ++i)
    text += fmt::format("\n{{\\footnotesize\\textsuperscript{{[{}]}} {}\\par}}\n", i + 1,
                        latex_escaped(table.footnotes[i]));
  for (const std::string& remark : table.remarks)
    text += fmt::format("\n{{\\footnotesize {}\\par}}\n", latex_escaped(remark));
  return text;
}

}  // namespace

std::string to_markdown(const Table& table) {
  Lines lines{group_title_line(table)};
  if (has_column_titles(table)) lines.push_back(column_title_line(table));
  for (const TableRow& row : table.rows) lines.push_back(row_line(table, row));

  const std::vector<std::size_t> widths = column_widths(lines);
  std::string text =
      fmt::format("### {}\n\n{}{}", table.caption, pipe_line(lines.front(), widths), rule_line(widths));
  for (std::size_t i = 1; i < lines.size(); ++i) text += pipe_line(lines[i], widths);

  if (!table.footnotes.empty()) text += "\n";
  for (std::size_t i = 0; i < table.footnotes.size(); ++i)
    text += fmt::format("- [{}] {}\n", i + 1, table.footnotes[i]);
  if (!table.remarks.empty()) text += "\n";
  for (const std::string& remark : table.remarks) text += fmt::format("- {}\n", remark);
  return text;
}

std::string to_csv(const Table& table) {
  std::string text = csv_line(csv_header(table));
  std::string section;
  for (const TableRow& row : table.rows) {
    if (row.is_heading()) {
      section = row.label;
      continue;
    }
    std::vector<std::string> fields{section, row.label};
    for (const TableCell& cell : row.cells) fields.push_back(cell.text);
    fields.push_back(notes_of(table, row));
    text += csv_line(fields);
  }
  return text;
}

std::string to_latex(const Table& table) {
  const bool is_long = table.rows.size() > latex_rows_on_a_page;
  const std::string text = is_long ? latex_pages(table) : latex_float(table);
  return text + latex_notes(table) + (is_long ? "" : "\\end{table}\n");
}

std::span<const TableFormat> table_formats() {
  static constexpr std::array formats{TableFormat{"md", "md", to_markdown}, TableFormat{"csv", "csv", to_csv},
                                      TableFormat{"tex", "tex", to_latex}};
  return formats;
}

}  // namespace gcs
