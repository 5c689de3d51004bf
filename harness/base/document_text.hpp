#pragma once
/// Files of JSON as text: a member a line, and an element a line of long lists; or the same as CBOR.

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/reading/cbor_document.hpp"
#include "solvers/reading/json_build.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {

using TextSink = std::function<void(std::string_view)>;

/// How a document is encoded: what stands before, between and after its members and the elements of its lists.
struct DocumentForm {
  std::string (*encoded)(const JsonValue&);
  std::string_view begin, before_first_member, before_member, after_name, end;
  std::string_view begin_list, before_element, end_list, empty_list;
};

inline constexpr DocumentForm json_form{[](const JsonValue& value) { return to_text(value, -1); },
                                        "{",
                                        "\n ",
                                        ",\n ",
                                        ": ",
                                        "\n}\n",
                                        "[\n  ",
                                        ",\n  ",
                                        "\n ]",
                                        "[]"};

/// Maps and lists whose ends are marked, since they are written before all of them is known (RFC 8949, 3.2.2).
inline constexpr DocumentForm cbor_form{to_cbor, "\xbf", "", "", "", "\xff", "\x9f", "", "\xff", "\x80"};

/// CBOR where the file's name ends in .cbor.
constexpr const DocumentForm& form_of(std::string_view file) {
  return file.ends_with(".cbor") ? cbor_form : json_form;
}

/// One object on its way to a file. A list is written block by block: its text is never in memory as a whole.
class DocumentWriter {
 public:
  /// The first member is "format". `take` gets the text piece by piece. Lists are written on `threads` ≥ 1 threads, the
  /// text is the same for any number.
  DocumentWriter(std::string_view format, TextSink take, int threads = 1,
                 const DocumentForm& form = json_form)
      : take_(std::move(take)), threads_(threads), form_(form), before_(form.before_first_member) {
    take_(form_.begin);
    member("format", json_text(std::string(format)));
  }

  void member(std::string_view name, const JsonValue& value) {
    begin(name);
    take_(form_.encoded(value));
  }

  /// The array of what `make` makes of each value; it is called from any thread.
  template <typename Values, typename Make>
  void list(std::string_view name, const Values& values, Make make) {
    constexpr std::size_t most_elements = 1024;
    begin_list(name);
    std::vector<std::string> block;
    for (std::size_t first = 0; first < std::size(values); first += most_elements) {
      block.resize(std::min(most_elements, std::size(values) - first));
      share_on_threads(block.size(), threads_,
                       [&](std::size_t i) { block[i] = form_.encoded(make(values[first + i])); });
      for (const std::string& text : block) add_element(text);
    }
    end_list();
  }

  /// An array whose elements come one by one. Precondition: nothing but these until its end.
  void begin_list(std::string_view name) {
    begin(name);
    is_empty_ = true;
  }
  void element(const JsonValue& value) { add_element(form_.encoded(value)); }
  void end_list() { take_(is_empty_ ? form_.empty_list : form_.end_list); }

  /// As JSON the document ends in a newline. Precondition: nothing follows.
  void end() { take_(form_.end); }

 private:
  void begin(std::string_view name) {
    take_(std::exchange(before_, form_.before_member));
    take_(form_.encoded(json_text(std::string(name))));
    take_(form_.after_name);
  }

  void add_element(std::string_view encoded) {
    take_(std::exchange(is_empty_, false) ? form_.begin_list : form_.before_element);
    take_(encoded);
  }

  TextSink take_;
  int threads_;
  const DocumentForm& form_;
  std::string_view before_;
  bool is_empty_ = true;  ///< the list
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
