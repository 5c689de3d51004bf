#pragma once
/// SVG to PDF, by the program rsvg-convert (Debian: librsvg2-bin).

#include <filesystem>
#include <string>
#include <string_view>

namespace gcs {

/// What to install where pdf_converter_is_there() is false.
inline constexpr std::string_view pdf_converter = "rsvg-convert (Debian package librsvg2-bin)";

/// Whether the program can be run.
bool pdf_converter_is_there();

/// Writes the drawing as one page of its own size. The same drawing gives the same file. Throws OutputError.
/// Precondition: pdf_converter_is_there().
void write_pdf(const std::string& svg, const std::filesystem::path& file);

}  // namespace gcs
