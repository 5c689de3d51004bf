#include "solvers/reading/json_document.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "solvers/reading/document_builder.hpp"

namespace gcs {
namespace {

/// Where character number `position` (from 1) of `text` stands.
std::string line_and_column(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position == 0 ? 0 : position - 1);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The reason in nlohmann's message without its prefix and without the token,
/// which may be megabytes of binary.
std::string syntax_reason(std::string message) {
  if (const auto start = message.find(" - "); start != std::string::npos) message.erase(0, start + 3);
  const auto token = message.find("; last read: '");
  const auto end = message.rfind('\'');
  if (token != std::string::npos && end != std::string::npos) message.erase(token, end + 1 - token);
  return message;
}

/// True when the word around character number `position` is NaN or Infinity, whatever the case.
bool is_not_finite_word(std::string_view text, std::size_t position) {
  std::size_t start = std::min(position == 0 ? 0 : position - 1, text.size());
  while (start > 0 && std::isalpha(static_cast<unsigned char>(text[start - 1])) != 0) --start;
  std::string word(text.substr(start, 3));
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == "nan" || word == "inf";
}

bool has_nonzero_digit(const std::string& number) {
  const auto mantissa_end = number.find_first_of("eE");
  return number.substr(0, mantissa_end).find_first_of("123456789") != std::string::npos;
}

/// What a JSON text says beside nlohmann's events.
class JsonBuilder final : public DocumentBuilder {
 public:
  JsonBuilder(std::string_view text, const std::string& file, const ElementTaker& taker)
      : DocumentBuilder(file, taker), text_(text) {}

  /// Called for integers with a minus sign only, so that a zero was written "-0".
  bool number_integer(number_integer_t value) override {
    return value == 0 ? attach_number(-0.0, "-0")
                      : attach_number(static_cast<double>(value), std::to_string(value));
  }

  bool number_float(number_float_t value, const string_t& raw) override {
    if (value == 0 && has_nonzero_digit(raw)) {
      fail("the number " + shortened_quote(raw) + " is too small for a double and would become 0",
           "give numbers above 1e-300, in a smaller unit if need be");
    }
    return attach_number(value, raw);
  }

  bool binary(binary_t&) override { return false; }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      fail("the number " + shortened_quote(token) + " is too large for a double",
           "give numbers below 1e300, in a larger unit if need be");
    }
    std::string what = line_and_column(text_, position) + ": not JSON: ";
    if (is_not_finite_word(text_, position)) {
      fail(what + "NaN and Infinity are no JSON numbers", "give a finite number");
    }
    fail(what + syntax_reason(error.what()), "correct the text there");
  }

 private:
  std::string_view text_;
};

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& file) { return parse_json(text, file, {}); }

JsonValue parse_json(std::string_view text, const std::string& file, const ElementTaker& taker) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(file, "", "the input is empty", "give one JSON value");
  }
  // nlohmann takes a zero byte for the end of the input and would ignore what follows.
  if (const auto zero = text.find('\0'); zero != std::string_view::npos) {
    throw InputError(file, "", line_and_column(text, zero + 1) + ": not JSON: a zero byte",
                     "give text in UTF-8");
  }
  JsonBuilder builder(text, file, taker);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace gcs
