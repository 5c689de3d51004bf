#pragma once
/// Prints a Table as HTML.

#include <string>

#include "harness/tables/table.hpp"

namespace gcs {

/// A section with the table, its footnotes, to which the entries link, and its remarks. Anchors begin with
/// the table's name, after `prefix`, which tells apart tables of several runs.
std::string to_html(const Table& table, const std::string& prefix = "");

}  // namespace gcs
