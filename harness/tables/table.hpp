#pragma once
/// A table as data: what is shown, not how. Builders make it, writers print it.

#include <string>
#include <vector>

namespace gcs {

/// One entry. `text` is complete, unit and spread included.
struct TableCell {
  std::string text;
  std::vector<int> notes;  ///< footnotes of this entry: indices into Table::footnotes
};

/// Neighbouring columns under one heading.
struct ColumnGroup {
  std::string title;
  std::vector<std::string> columns;
};

/// A row, or a heading between rows when `cells` is empty.
struct TableRow {
  std::string label;
  std::vector<TableCell> cells;  ///< as many as there are columns in all groups, or none
  std::vector<int> notes;        ///< footnotes of the label

  bool is_heading() const { return cells.empty(); }
};

struct Table {
  std::string name;  ///< file stem
  std::string caption;
  std::string stub;  ///< heading of the column of labels
  std::vector<ColumnGroup> groups;
  std::vector<TableRow> rows;
  std::vector<std::string> footnotes;  ///< numbered from 1 where they are shown
  std::vector<std::string> remarks;    ///< conventions and units, shown below the table

  int column_count() const {
    int count = 0;
    for (const ColumnGroup& group : groups) count += static_cast<int>(group.columns.size());
    return count;
  }
  /// Index of `text` among the footnotes, added when it is new.
  int footnote(const std::string& text) {
    for (int i = 0; i < static_cast<int>(footnotes.size()); ++i) {
      if (footnotes[i] == text) return i;
    }
    footnotes.push_back(text);
    return static_cast<int>(footnotes.size()) - 1;
  }
};

}  // namespace gcs
