#pragma once
/// Files of JSON as text: a member a line, and an element a line of long lists.

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/reading/json_build.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {

using TextSink = std::function<void(std::string_view)>;

/// One object on its way to a file. A list is written block by block: its text is never in memory as a whole.
class DocumentWriter {
 public:
  /// The first member is "format". `take` gets the text piece by piece. Lists are written on `threads` ≥ 1 threads, the
  /// text is the same for any number.
  DocumentWriter(std::string_view format, TextSink take, int threads = 1)
      : take_(std::move(take)), threads_(threads) {
    take_("{");
    member("format", json_text(std::string(format)));
  }

  void member(std::string_view name, const JsonValue& value) {
    begin(name);
    take_(to_text(value, -1));
  }

  /// The array of what `make` makes of each value; it is called from any thread.
  template <typename Values, typename Make>
  void list(std::string_view name, const Values& values, Make make) {
    constexpr std::size_t most_elements = 1024;
    begin(name);
    std::string_view before = "[\n  ";
    std::vector<std::string> block;
    for (std::size_t first = 0; first < std::size(values); first += most_elements) {
      block.resize(std::min(most_elements, std::size(values) - first));
      share_on_threads(block.size(), threads_,
                       [&](std::size_t i) { block[i] = to_text(make(values[first + i]), -1); });
      for (const std::string& text : block) {
        take_(before);
        take_(text);
        before = ",\n  ";
      }
    }
    take_(std::size(values) == 0 ? "[]" : "\n ]");
  }

  /// The document ends in a newline. Precondition: nothing follows.
  void end() { take_("\n}\n"); }

 private:
  void begin(std::string_view name) {
    take_(std::exchange(before_, ",\n "));
    take_(to_text(json_text(std::string(name)), -1));
    take_(": ");
  }

  TextSink take_;
  int threads_;
  std::string_view before_ = "\n ";
};

/// The document that `fill`, a function of a DocumentWriter, writes.
template <typename Fill>
std::string document_text(std::string_view format, Fill fill) {
  std::string text;
  DocumentWriter document(format, [&](std::string_view piece) { text += piece; });
  fill(document);
  document.end();
  return text;
}

}  // namespace gcs
