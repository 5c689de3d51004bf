#include "solvers/reading/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace gcs {
namespace {

/// Appends the members or elements of a container, each by `append_item(i)`, one a line unless indent < 0.
template <typename AppendItem>
void append_items(std::string& out, std::string_view brackets, std::size_t count, int indent, int depth,
                  AppendItem append_item) {
  const auto new_line = [&](int levels) {
    if (indent >= 0) out += '\n' + std::string(static_cast<std::size_t>(indent * levels), ' ');
  };
  out += brackets[0];
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += indent < 0 ? ", " : ",";
    new_line(depth + 1);
    append_item(i);
  }
  if (count > 0) new_line(depth);
  out += brackets[1];
}

/// Whether nothing of a text is escaped in JSON.
bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

/// Bytes that are no text, as names of folders may have them, become U+FFFD.
void append_string(std::string& out, const std::string& text) {
  if (is_plain(text))
    out.append(1, '"').append(text).append(1, '"');
  else
    out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_number(std::string& out, const JsonValue& number) {
  if (number.text.empty()) {
    std::array<char, 32> digits;  // the shortest text of a double takes 24 at most
    out.append(digits.data(), fmt::format_to(digits.data(), "{}", number.number));
  } else {
    out += number.text;
  }
}

void append_text(std::string& out, const JsonValue& value, int indent, int depth) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      out += "null";
      return;
    case JsonValue::Kind::boolean:
      out += value.boolean ? "true" : "false";
      return;
    case JsonValue::Kind::number:
      append_number(out, value);
      return;
    case JsonValue::Kind::string:
      append_string(out, value.text);
      return;
    case JsonValue::Kind::array:
      append_items(out, "[]", value.elements.size(), indent, depth,
                   [&](std::size_t i) { append_text(out, value.elements[i], indent, depth + 1); });
      return;
    case JsonValue::Kind::object:
      append_items(out, "{}", value.members.size(), indent, depth, [&](std::size_t i) {
        append_string(out, value.members[i].first);
        out += ": ";
        append_text(out, value.members[i].second, indent, depth + 1);
      });
      return;
  }
}

}  // namespace

std::string escaped_for_pointer(std::string_view key) {
  std::string escaped;
  for (const char c : key) {
    if (c == '~') {
      escaped += "~0";
    } else if (c == '/') {
      escaped += "~1";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

JsonValue::JsonValue() = default;
JsonValue::JsonValue(const JsonValue&) = default;
JsonValue::JsonValue(JsonValue&&) noexcept = default;
JsonValue& JsonValue::operator=(const JsonValue&) = default;
JsonValue& JsonValue::operator=(JsonValue&&) noexcept = default;
JsonValue::~JsonValue() = default;

const JsonValue* JsonValue::find(std::string_view name) const {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == name; });
  return found == members.end() ? nullptr : &found->second;
}

std::string number_text(const JsonValue& number) { return to_text(number, -1); }

std::string to_text(const JsonValue& value, int indent) {
  std::string out;
  append_text(out, value, indent, 0);
  return out;
}

}  // namespace gcs
