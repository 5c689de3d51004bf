#include "solvers/reading/document_builder.hpp"

#include <utility>

#include "solvers/running/errors.hpp"

namespace gcs {
namespace {

/// No instance or result nests deeper than ten; the limit keeps hostile input from exhausting the stack.
constexpr std::size_t depth_limit = 64;

/// Longest piece of input that a message repeats.
constexpr std::size_t quote_limit = 40;

}  // namespace

std::string shortened_quote(const std::string& token) {
  if (token.size() <= quote_limit) return "'" + token + "'";
  std::size_t end = quote_limit;
  const auto splits_a_character = [&] { return (static_cast<unsigned char>(token[end]) & 0xC0U) == 0x80U; };
  while (end > 0 && splits_a_character()) --end;
  return "'" + token.substr(0, end) + "…'";
}

bool DocumentBuilder::boolean(bool value) {
  JsonValue result;
  result.kind = JsonValue::Kind::boolean;
  result.boolean = value;
  return attach(std::move(result));
}

bool DocumentBuilder::number_unsigned(number_unsigned_t value) {
  return attach_number(static_cast<double>(value), std::to_string(value));
}

bool DocumentBuilder::string(string_t& value) {
  JsonValue result;
  result.kind = JsonValue::Kind::string;
  result.text = std::move(value);
  return attach(std::move(result));
}

bool DocumentBuilder::key(string_t& name) {
  Level& level = open_.back();
  level.key = name;
  if (!level.keys.insert(name).second)
    fail("the key " + shortened_quote(name) + " is given twice", "give every key once");
  return true;
}

void DocumentBuilder::fail(const std::string& what, const std::string& remedy) const {
  throw InputError(file_, pointer(), what, remedy);
}

std::string DocumentBuilder::pointer() const {
  std::string result;
  for (const Level& level : open_) {
    const bool in_array = level.value.kind == JsonValue::Kind::array;
    if (!in_array && level.keys.empty()) continue;
    result += '/';
    result +=
        in_array ? std::to_string(level.value.elements.size() + level.taken) : escaped_for_pointer(level.key);
  }
  return result;
}

bool DocumentBuilder::open(JsonValue::Kind kind) {
  if (open_.size() == depth_limit) {
    throw InputError(file_, "",
                     "the values are nested deeper than " + std::to_string(depth_limit) + " levels",
                     "no file of this program needs more than ten");
  }
  open_.emplace_back();
  open_.back().value.kind = kind;
  return true;
}

bool DocumentBuilder::close() {
  JsonValue value = std::move(open_.back().value);
  open_.pop_back();
  return attach(std::move(value));
}

bool DocumentBuilder::attach_number(double value, std::string text) {
  JsonValue result;
  result.kind = JsonValue::Kind::number;
  result.number = value;
  result.text = std::move(text);
  return attach(std::move(result));
}

void DocumentBuilder::attach_element(Level& list, JsonValue element) {
  const bool may_be_taken = taker_.take && open_.size() == 2 && open_.front().key == taker_.list;
  if (may_be_taken && taker_.take(open_.front().value, element, list.value.elements.size() + list.taken))
    ++list.taken;
  else
    list.value.elements.push_back(std::move(element));
}

bool DocumentBuilder::attach(JsonValue value) {
  if (open_.empty()) {
    root_ = std::move(value);
  } else if (Level& parent = open_.back(); parent.value.kind == JsonValue::Kind::array) {
    attach_element(parent, std::move(value));
  } else {
    parent.value.members.emplace_back(parent.key, std::move(value));
  }
  return true;
}

}  // namespace gcs
