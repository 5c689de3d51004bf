#pragma once
/// Small sound instances for the tests of reading, and what spoils them.

#include <nlohmann/json.hpp>
#include <string>

#include "harness/instances/instance_lookup.hpp"

namespace gcs::samples {

/// A triangle in the plane with every hint that a file can give.
nlohmann::json plane();
/// A tetrahedron and a line in space.
nlohmann::json space();
/// Five points in space without lines, the fifth held by three distances.
nlohmann::json bipyramid();
/// Four fixed points and a line.
nlohmann::json tangents();

/// The document with the value at `pointer` replaced; a null value removes it.
nlohmann::json with(nlohmann::json document, const std::string& pointer, const nlohmann::json& value);

/// The document as the instance small.json; the structure of general scenes may be wrong.
Instance parsed(const nlohmann::json& document);

/// Checks that the document is refused at that pointer with a message that begins with the file and holds the
/// word.
void check_refused(const nlohmann::json& document, const std::string& pointer, const std::string& word);

}  // namespace gcs::samples
