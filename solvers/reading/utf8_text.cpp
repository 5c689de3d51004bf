#include "solvers/reading/utf8_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gcs {

bool is_utf8(const std::string& bytes) {
  if (std::ranges::all_of(bytes, [](unsigned char c) { return c < 0x80; })) return true;
  try {
    nlohmann::json(bytes).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

std::string utf8_text(const std::string& bytes) {
  if (is_utf8(bytes)) return bytes;
  using nlohmann::json;
  return json::parse(json(bytes).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

}  // namespace gcs
