#pragma once
/// Text inside HTML and SVG.

#include <string>
#include <string_view>

namespace gcs {

/// For text and for the values of attributes in double quotes.
std::string html_escaped(std::string_view text);

/// JSON for a script element: the same values, but nothing that HTML would take for a tag or the element's
/// end.
std::string script_escaped(std::string_view json);

/// A name for `id` attributes and links: letters, digits and hyphens; "@" and the like become hyphens.
std::string html_anchor(std::string_view text);

}  // namespace gcs
