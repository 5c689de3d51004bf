#include "solvers/reading/cbor_document.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "solvers/reading/document_builder.hpp"
#include "solvers/reading/json_build.hpp"
#include "solvers/reading/json_document.hpp"
#include "solvers/reading/utf8_text.hpp"

namespace gcs {
namespace {

using Ordered = nlohmann::ordered_json;

// RFC 8949, section 3.
enum class MajorType : unsigned { byte_string = 2, text_string = 3, map = 5 };

MajorType major_type(char head) { return static_cast<MajorType>(static_cast<unsigned char>(head) >> 5U); }

/// What CBOR says otherwise than JSON.
class CborBuilder final : public DocumentBuilder {
 public:
  using DocumentBuilder::DocumentBuilder;

  /// Of a negative number below -2^63 nlohmann's reader makes one that is not negative.
  bool number_integer(number_integer_t value) override {
    if (value >= 0) fail("the integer is below -2^63", "write it as a float");
    return attach_number(static_cast<double>(value), std::to_string(value));
  }

  bool number_float(number_float_t value, const string_t&) override {
    if (!std::isfinite(value)) fail("NaN and infinity are no numbers here", "give a finite number, or null");
    return attach(json_number(value));
  }

  bool binary(binary_t& bytes) override { return attach(decimal(std::string(bytes.begin(), bytes.end()))); }

  bool string(string_t& value) override {
    require_utf8(value);
    return DocumentBuilder::string(value);
  }

  bool key(string_t& name) override {
    require_utf8(name);
    return DocumentBuilder::key(name);
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const std::string said = error.what();
    fail("byte " + std::to_string(position) + ": not CBOR: " + said.substr(said.find("syntax error")),
         "the file is damaged or cut off: write it anew");
  }

 private:
  JsonValue decimal(const std::string& text) const {
    try {
      if (JsonValue value = parse_json(text, file()); value.kind == JsonValue::Kind::number) return value;
    } catch (const InputError&) {
    }
    fail("the byte string is no number", "a byte string is a number as JSON writes it");
  }

  void require_utf8(const std::string& text) const {
    if (!is_utf8(text)) fail("a text string is no UTF-8", "write it as UTF-8");
  }
};

/// The bytes after the head of an item at `at` that belong to the item itself, and not to items in it.
struct ItemExtent {
  std::uint64_t argument_bytes = 0;
  std::uint64_t argument = 0;
};

ItemExtent extent(std::string_view bytes, std::size_t at) {
  const unsigned info = static_cast<unsigned char>(bytes[at]) & 0x1fU;
  if (info < 24 || info > 27) return {0, info < 24 ? info : 0};
  ItemExtent item{std::uint64_t{1} << (info - 24)};
  for (const char byte : bytes.substr(at + 1, item.argument_bytes))
    item.argument = item.argument << 8U | static_cast<unsigned char>(byte);
  return item;
}

/// nlohmann's reader calls itself for a string in chunks, and for one among its chunks, however deep. Heads follow each
/// other in the file whatever nests, so that this does not.
void refuse_strings_in_chunks(std::string_view bytes, const std::string& file) {
  constexpr unsigned indefinite = 31;
  for (std::size_t at = 0; at < bytes.size();) {
    const bool is_string =
        major_type(bytes[at]) == MajorType::byte_string || major_type(bytes[at]) == MajorType::text_string;
    if (is_string && (static_cast<unsigned char>(bytes[at]) & 0x1fU) == indefinite)
      throw InputError(file, "", "byte " + std::to_string(at + 1) + ": a string in chunks",
                       "give every string its length");
    const ItemExtent item = extent(bytes, at);
    at += 1 + item.argument_bytes;
    if (is_string && (at > bytes.size() || item.argument > bytes.size() - at)) return;  // cut off
    if (is_string) at += item.argument;
  }
}

/// The integer whose decimal text this is.
template <typename Integer>
std::optional<Integer> integer_of(const std::string& text) {
  Integer value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return std::to_string(value) == text ? std::optional(value) : std::nullopt;
}

Ordered encoded_double(double value) {
  constexpr double largest_exact_integer = 9007199254740992;  // 2^53
  const bool is_negative_zero = value == 0 && std::signbit(value);
  const bool is_integer =
      std::abs(value) <= largest_exact_integer && value == std::trunc(value) && !is_negative_zero;
  return is_integer ? Ordered(static_cast<std::int64_t>(value)) : Ordered(value);
}

Ordered encoded_number(const JsonValue& value) {
  if (value.text.empty()) return encoded_double(value.number);
  if (const auto count = integer_of<std::uint64_t>(value.text)) return *count;
  if (const auto integer = integer_of<std::int64_t>(value.text)) return *integer;
  if (number_text(json_number(value.number)) == value.text) return value.number;
  return Ordered::binary({value.text.begin(), value.text.end()});
}

Ordered encoded(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      return nullptr;
    case JsonValue::Kind::boolean:
      return value.boolean;
    case JsonValue::Kind::number:
      return encoded_number(value);
    case JsonValue::Kind::string:
      return utf8_text(value.text);
    case JsonValue::Kind::array: {
      Ordered::array_t elements;
      elements.reserve(value.elements.size());
      for (const JsonValue& element : value.elements) elements.push_back(encoded(element));
      return elements;
    }
    case JsonValue::Kind::object: {
      Ordered::object_t members;
      members.reserve(value.members.size());
      for (const auto& [name, member] : value.members) members.emplace_back(utf8_text(name), encoded(member));
      return members;
    }
  }
  return nullptr;
}

}  // namespace

bool is_cbor_map(std::string_view bytes) {
  return !bytes.empty() && major_type(bytes.front()) == MajorType::map;
}

JsonValue parse_cbor(std::string_view bytes, const std::string& file, const ElementTaker& taker) {
  refuse_strings_in_chunks(bytes, file);
  CborBuilder builder(file, taker);
  nlohmann::json::sax_parse(bytes.begin(), bytes.end(), &builder, nlohmann::json::input_format_t::cbor);
  return builder.take();
}

JsonValue parse_document(std::string_view bytes, const std::string& file, const ElementTaker& taker) {
  return is_cbor_map(bytes) ? parse_cbor(bytes, file, taker) : parse_json(bytes, file, taker);
}

std::string to_cbor(const JsonValue& value) {
  std::string bytes;
  Ordered::to_cbor(encoded(value), bytes);
  return bytes;
}

}  // namespace gcs
