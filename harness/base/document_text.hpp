#pragma once
/// Files of JSON as text: a member a line, and an element a line of long lists.

#include <string>
#include <string_view>
#include <utility>

#include "solvers/reading/json_build.hpp"

namespace gcs {

/// One object on its way to a file. A list is written element by element: its JSON is never in memory as a whole.
class DocumentText {
 public:
  /// The first member is "format".
  explicit DocumentText(std::string_view format) { member("format", json_text(std::string(format))); }

  void member(std::string_view name, const JsonValue& value) {
    begin(name);
    text_ += to_text(value, -1);
  }

  /// The array of what `make` makes of each value.
  template <typename Values, typename Make>
  void list(std::string_view name, const Values& values, Make make) {
    begin(name);
    std::string_view before = "[\n  ";
    for (const auto& value : values) {
      text_.append(before) += to_text(make(value), -1);
      before = ",\n  ";
    }
    text_ += before == "[\n  " ? "[]" : "\n ]";
  }

  /// The document, ending in a newline.
  std::string text() && { return std::move(text_) + "\n}\n"; }

 private:
  void begin(std::string_view name) {
    text_.append(text_.empty() ? "{\n " : ",\n ") += to_text(json_text(std::string(name)), -1) + ": ";
  }

  std::string text_;
};

}  // namespace gcs
