#pragma once
/// Builds a document from what nlohmann's readers find in a file, whatever its encoding.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "solvers/reading/element_taker.hpp"
#include "solvers/reading/json_value.hpp"

namespace gcs {

/// Receives nlohmann's events; every refusal leaves as an InputError. What an encoding says otherwise than the others is
/// left to those that derive from it.
class DocumentBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// `file` is for messages. Both outlive this.
  DocumentBuilder(const std::string& file, const ElementTaker& taker) : file_(file), taker_(taker) {}

  JsonValue take() { return std::move(root_); }

  bool null() override { return attach({}); }
  bool boolean(bool value) override;
  /// A non-negative integer has one spelling.
  bool number_unsigned(number_unsigned_t value) override;
  bool string(string_t& value) override;
  bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override;

 protected:
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;
  bool attach_number(double value, std::string text);
  bool attach(JsonValue value);
  const std::string& file() const { return file_; }

 private:
  struct Level {
    JsonValue value;
    std::string key;                       ///< of the member being read
    std::unordered_set<std::string> keys;  ///< finding a duplicate must not take quadratic time
    std::size_t taken = 0;                 ///< elements that are not in `value`
  };

  std::string pointer() const;
  bool open(JsonValue::Kind kind);
  bool close();
  void attach_element(Level& list, JsonValue element);

  const std::string& file_;
  const ElementTaker& taker_;
  std::vector<Level> open_;
  JsonValue root_;
};

/// The token in quotes, at most its first characters: it may be megabytes.
std::string shortened_quote(const std::string& token);

}  // namespace gcs
