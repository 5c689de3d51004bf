#include "harness/base/record_json.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

namespace gcs {
namespace {

template <typename Whole>
void read_whole(const JsonCursor& cursor, Whole& value) {
  Natural count;
  read_json(cursor, count);
  const std::string text = count.decimal();
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc())
    cursor.fail("'" + text + "' is too large",
                fmt::format("give a whole number up to {}", std::numeric_limits<Whole>::max()));
}

}  // namespace

JsonValue json_of(bool value) { return json_boolean(value); }
JsonValue json_of(double value) { return json_number(value); }
JsonValue json_of(int value) { return json_number(value); }
JsonValue json_of(std::int64_t value) { return json_count(static_cast<std::uint64_t>(value)); }
JsonValue json_of(std::uint64_t value) { return json_count(value); }
JsonValue json_of(const Natural& value) { return json_count(value); }
JsonValue json_of(const std::string& value) { return json_text(value); }

void read_json(const JsonCursor& cursor, bool& value) { value = cursor.boolean(); }
void read_json(const JsonCursor& cursor, double& value) {
  value = cursor.is_null() ? std::numeric_limits<double>::infinity() : cursor.number_value();
}
void read_json(const JsonCursor& cursor, int& value) { read_whole(cursor, value); }
void read_json(const JsonCursor& cursor, std::int64_t& value) { read_whole(cursor, value); }
void read_json(const JsonCursor& cursor, std::uint64_t& value) { read_whole(cursor, value); }
void read_json(const JsonCursor& cursor, Natural& value) {
  const bool is_text = cursor.value().kind == JsonValue::Kind::string;
  const std::string text = is_text ? cursor.text() : cursor.number().text;
  const auto count = Natural::from_decimal(text);
  if (!count) cursor.fail("'" + text + "' is no count", "give a whole number that is not negative");
  value = *count;
}
void read_json(const JsonCursor& cursor, std::string& value) { value = cursor.text(); }

}  // namespace gcs
