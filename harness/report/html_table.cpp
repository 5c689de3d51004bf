#include "harness/report/html_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/drawings/html_text.hpp"

namespace gcs {
namespace {

std::string note_marks(const std::vector<int>& notes, const std::string& anchor) {
  std::string marks;
  for (const int note : notes)
    marks += fmt::format("<a href=\"#{}-note-{}\" aria-label=\"note {}\">[{}]</a>", anchor, note + 1,
                         note + 1, note + 1);
  return marks.empty() ? "" : "<sup>" + marks + "</sup>";
}

bool has_column_titles(const Table& table) {
  return std::any_of(table.groups.begin(), table.groups.end(), [](const ColumnGroup& group) {
    return group.columns.size() > 1 || !group.columns.front().empty();
  });
}

bool has_group_titles(const Table& table) {
  return std::any_of(table.groups.begin(), table.groups.end(),
                     [](const ColumnGroup& group) { return !group.title.empty(); });
}

/// Two rows where both groups and columns have titles, otherwise the titles that there are.
std::string header(const Table& table) {
  const bool has_two_rows = has_group_titles(table) && has_column_titles(table);
  std::string columns, groups;
  for (const ColumnGroup& group : table.groups) {
    groups += fmt::format("<th class=\"group\" scope=\"colgroup\" colspan=\"{}\"><span>{}</span></th>",
                          group.columns.size(), html_escaped(group.title));
    for (const std::string& column : group.columns)
      columns += fmt::format("<th scope=\"col\">{}</th>",
                             html_escaped(has_column_titles(table) ? column : group.title));
  }
  const std::string stub = fmt::format("<th class=\"stub\" scope=\"col\"{}>{}</th>",
                                       has_two_rows ? " rowspan=\"2\"" : "", html_escaped(table.stub));
  return "<tr>" + stub + (has_two_rows ? groups + "</tr>\n<tr>" : "") + columns + "</tr>\n";
}

std::string row_html(const Table& table, const TableRow& row, const std::string& anchor) {
  const std::string label = html_escaped(row.label) + note_marks(row.notes, anchor);
  if (row.is_heading())
    return fmt::format("<tr class=\"heading\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                       table.column_count() + 1, label);
  std::string text = fmt::format("<tr><th scope=\"row\">{}</th>", label);
  for (const TableCell& cell : row.cells)
    text += fmt::format("<td>{}{}</td>", html_escaped(cell.text), note_marks(cell.notes, anchor));
  return text + "</tr>\n";
}

std::string notes(const Table& table, const std::string& anchor) {
  std::string text;
  for (std::size_t i = 0; i < table.footnotes.size(); ++i)
    text += fmt::format("<li id=\"{}-note-{}\">{}</li>\n", anchor, i + 1, html_escaped(table.footnotes[i]));
  return text.empty() ? "" : "<ol class=\"notes\">\n" + text + "</ol>\n";
}

std::string remarks(const Table& table) {
  std::string text;
  for (const std::string& remark : table.remarks) text += "<li>" + html_escaped(remark) + "</li>\n";
  return text.empty() ? "" : "<ul class=\"remarks\">\n" + text + "</ul>\n";
}

}  // namespace

std::string to_html(const Table& table, const std::string& prefix) {
  const std::string anchor = prefix + html_anchor(table.name);
  std::string text = fmt::format(
      "<section class=\"table\" id=\"{0}\" aria-labelledby=\"{0}-caption\">\n<div class=\"scroll\" "
      "tabindex=\"0\" "
      "role=\"region\" aria-labelledby=\"{0}-caption\"><table>\n<caption "
      "id=\"{0}-caption\">{1}</caption>\n<thead>\n",
      anchor, html_escaped(table.caption));
  text += header(table) + "</thead>\n<tbody>\n";
  for (const TableRow& row : table.rows) text += row_html(table, row, anchor);
  return text + "</tbody>\n</table></div>\n" + notes(table, anchor) + remarks(table) + "</section>\n";
}

}  // namespace gcs
