#pragma once
/// Records as JSON by the lists of their fields: what is written reads back. An empty optional is null, and so is
/// an infinite number; a count above 2^53 is a text.
///
/// A list is a function visit_fields(record, visit) in namespace gcs, which calls for every member
/// visit(name, member), visit.later(name, member) where files of earlier versions have none,
/// visit.where_it_applies(name, member) for an optional one that is left out where it is empty, and
/// visit.named(name, member, all) for an enumeration, or an optional one, with a word for each of `all`.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/reading/json_build.hpp"
#include "solvers/reading/json_cursor.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace gcs {

/// `Record`, also where it is const: for lists that serve writing and reading.
template <typename T, typename Record>
concept RecordOf = std::is_same_v<std::remove_const_t<T>, Record>;

// ---- writing

JsonValue json_of(bool value);
JsonValue json_of(double value);
JsonValue json_of(int value);
JsonValue json_of(std::int64_t value);
JsonValue json_of(std::uint64_t value);
JsonValue json_of(const Natural& value);
JsonValue json_of(const std::string& value);
template <typename T>
JsonValue json_of(const std::optional<T>& value);
template <typename T>
JsonValue json_of(const std::vector<T>& values);
template <typename T, std::size_t count>
JsonValue json_of(const std::array<T, count>& values);
template <typename T, typename Order>
JsonValue json_of(const std::map<std::string, T, Order>& values);
template <typename Record>
JsonValue json_of(const Record& record);

/// Appends the members that a list visits.
class RecordWriter {
 public:
  explicit RecordWriter(JsonMembers& members) : members_(members) {}

  template <typename T>
  void operator()(const std::string& name, const T& value) const {
    members_.emplace_back(name, json_of(value));
  }
  template <typename T>
  void later(const std::string& name, const T& value) const {
    (*this)(name, value);
  }
  template <typename T>
  void where_it_applies(const std::string& name, const std::optional<T>& value) const {
    if (value) (*this)(name, value);
  }
  template <typename Named, typename All>
  void named(const std::string& name, const std::optional<Named>& value, const All&) const {
    members_.emplace_back(name,
                          json_or_null(value, [](Named one) { return json_text(std::string(word(one))); }));
  }
  template <typename Named, typename All>
  void named(const std::string& name, Named value, const All& all) const {
    named(name, std::optional(value), all);
  }

 private:
  JsonMembers& members_;
};

template <typename T>
JsonValue json_of(const std::optional<T>& value) {
  return json_or_null(value, [](const T& one) { return json_of(one); });
}

template <typename T>
JsonValue json_of(const std::vector<T>& values) {
  return json_array_of(values, [](const T& one) { return json_of(one); });
}

template <typename T, std::size_t count>
JsonValue json_of(const std::array<T, count>& values) {
  return json_array_of(values, [](const T& one) { return json_of(one); });
}

template <typename T, typename Order>
JsonValue json_of(const std::map<std::string, T, Order>& values) {
  JsonMembers members;
  for (const auto& [name, value] : values) members.emplace_back(name, json_of(value));
  return json_object(std::move(members));
}

template <typename Record>
JsonValue json_of(const Record& record) {
  JsonMembers members;
  visit_fields(record, RecordWriter(members));
  return json_object(std::move(members));
}

// ---- reading: each throws InputError where the value is none of its kind

void read_json(const JsonCursor& cursor, bool& value);
void read_json(const JsonCursor& cursor, double& value);
/// A whole number that is not negative.
void read_json(const JsonCursor& cursor, int& value);
void read_json(const JsonCursor& cursor, std::int64_t& value);
void read_json(const JsonCursor& cursor, std::uint64_t& value);
void read_json(const JsonCursor& cursor, Natural& value);
void read_json(const JsonCursor& cursor, std::string& value);
template <typename T>
void read_json(const JsonCursor& cursor, std::optional<T>& value);
template <typename T>
void read_json(const JsonCursor& cursor, std::vector<T>& values);
template <typename T, std::size_t count>
void read_json(const JsonCursor& cursor, std::array<T, count>& values);
template <typename T, typename Order>
void read_json(const JsonCursor& cursor, std::map<std::string, T, Order>& values);
template <typename Record>
void read_json(const JsonCursor& cursor, Record& record);

/// The one of `all` whose word the value is.
template <typename Named, std::size_t count>
Named read_word(const JsonCursor& cursor, const std::array<Named, count>& all) {
  const std::string text = cursor.text();
  const auto* const found =
      std::find_if(all.begin(), all.end(), [&](Named one) { return word(one) == text; });
  if (found != all.end()) return *found;
  std::vector<std::string> words;
  for (const Named one : all) words.emplace_back(word(one));
  cursor.fail("'" + text + "' is no known word",
              "did you mean '" + nearest_name(text, words) + "'? The words here are " + quoted_list(words));
}

/// Reads the members that a list visits.
class RecordReader {
 public:
  enum class Missing { refused, passed_over };

  explicit RecordReader(JsonCursor object, Missing missing = Missing::refused)
      : object_(std::move(object)), missing_(missing) {}

  template <typename T>
  void operator()(const std::string& name, T& value) const {
    if (missing_ == Missing::passed_over)
      later(name, value);
    else
      read_json(object_.required(name), value);
  }
  template <typename T>
  void later(const std::string& name, T& value) const {
    if (const auto member = object_.optional(name)) read_json(*member, value);
  }
  template <typename T>
  void where_it_applies(const std::string& name, std::optional<T>& value) const {
    later(name, value);
  }
  template <typename Named, typename All>
  void named(const std::string& name, Named& value, const All& all) const {
    value = read_word(object_.required(name), all);
  }
  /// Nothing where there is none, or null.
  template <typename Named, typename All>
  void named(const std::string& name, std::optional<Named>& value, const All& all) const {
    const auto member = object_.optional(name);
    value = member && !member->is_null() ? std::optional(read_word(*member, all)) : std::nullopt;
  }

 private:
  JsonCursor object_;
  Missing missing_;
};

template <typename T>
void read_json(const JsonCursor& cursor, std::optional<T>& value) {
  value.reset();
  if (!cursor.is_null()) read_json(cursor, value.emplace());
}

template <typename T>
void read_json(const JsonCursor& cursor, std::vector<T>& values) {
  values.clear();
  for (const JsonCursor& element : cursor.elements()) read_json(element, values.emplace_back());
}

template <typename T, std::size_t count>
void read_json(const JsonCursor& cursor, std::array<T, count>& values) {
  const std::vector<JsonCursor> elements = cursor.elements(count, "values");
  for (std::size_t i = 0; i < count; ++i) read_json(elements[i], values[i]);
}

template <typename T, typename Order>
void read_json(const JsonCursor& cursor, std::map<std::string, T, Order>& values) {
  values.clear();
  for (const auto& [name, member] : cursor.members()) read_json(member, values[name]);
}

template <typename Record>
void read_json(const JsonCursor& cursor, Record& record) {
  visit_fields(record, RecordReader(cursor));
}

}  // namespace gcs
