#pragma once
/// Values as bytes for another process on a machine of the same kind (see Crew), and back.

#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gcs {

template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

class MessageWriter {
 public:
  template <Plain T>
  void operator()(const T& value) {
    append(&value, sizeof value);
  }
  template <Plain T>
  void operator()(const std::vector<T>& values) {
    (*this)(values.size());
    append(values.data(), values.size() * sizeof(T));
  }
  template <Plain T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    (*this)(value.value_or(T()));
  }
  void operator()(const std::string& text) {
    (*this)(text.size());
    message += text;
  }

  std::string message;

 private:
  void append(const void* bytes, std::size_t size) { message.append(static_cast<const char*>(bytes), size); }
};

/// Throws std::invalid_argument where the message ends early.
class MessageReader {
 public:
  explicit MessageReader(std::string_view message) : rest_(message) {}

  template <Plain T>
  void operator()(T& value) {
    take(&value, sizeof value);
  }
  template <Plain T>
  void operator()(std::vector<T>& values) {
    values.resize(size_of(sizeof(T)));
    take(values.data(), values.size() * sizeof(T));
  }
  template <Plain T>
  void operator()(std::optional<T>& value) {
    bool is_there = false;
    (*this)(is_there);
    T there{};
    (*this)(there);
    value = is_there ? std::optional(there) : std::nullopt;
  }
  void operator()(std::string& text) {
    text.resize(size_of(1));
    take(text.data(), text.size());
  }

 private:
  /// Of what comes next, in elements of so many bytes.
  std::size_t size_of(std::size_t element) {
    std::size_t size = 0;
    (*this)(size);
    if (size > rest_.size() / element) throw std::invalid_argument("a message ends early");
    return size;
  }

  void take(void* place, std::size_t size) {
    if (size > rest_.size()) throw std::invalid_argument("a message ends early");
    if (size > 0) std::memcpy(place, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
};

/// Calls `visit` with all members, to be written or read.
template <class Visit>
void visit_all(Visit& visit, auto&... members) {
  (visit(members), ...);
}

/// The same with the elements of a list that are not plain, each by `visit_element(visit, element)`.
template <class T>
void visit_each(MessageWriter& write, const std::vector<T>& list, const auto& visit_element) {
  write(list.size());
  for (const T& element : list) visit_element(write, element);
}
template <class T>
void visit_each(MessageReader& read, std::vector<T>& list, const auto& visit_element) {
  std::size_t size = 0;
  read(size);
  list.clear();
  while (list.size() < size) visit_element(read, list.emplace_back());
}

}  // namespace gcs
