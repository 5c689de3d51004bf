#pragma once
/// Bytes as text in UTF-8, which JSON and CBOR hold alone.

#include <string>

namespace gcs {

bool is_utf8(const std::string& bytes);

/// The bytes, with U+FFFD for those that are no text, as names of folders may have them.
std::string utf8_text(const std::string& bytes);

}  // namespace gcs
