#include "harness/base/complex_rows.hpp"

#include <array>
#include <charconv>

namespace gcs {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads on in a text; every function that finds something else than it is asked for says so and leaves the
/// place undefined.
class Reader {
 public:
  Reader(std::string_view text, std::size_t place)
      : at_(text.data() + place), begin_(text.data()), end_(text.data() + text.size()) {}

  std::size_t place() const { return static_cast<std::size_t>(at_ - begin_); }

  bool take(char wanted) {
    skip_space();
    if (at_ == end_ || *at_ != wanted) return false;
    ++at_;
    return true;
  }

  /// "[", `count` items or any number of them (−1), and "]", each by `take_item()`.
  template <class TakeItem>
  bool take_array(int count, const TakeItem& take_item) {
    if (!take('[')) return false;
    int taken = 0;
    if (!take(']')) {
      do {
        if (!take_item()) return false;
        ++taken;
      } while (take(','));
      if (!take(']')) return false;
    }
    return count < 0 || taken == count;
  }

  bool take_number(double& value) {
    skip_space();
    const char* first = at_;
    const auto [last, error] = std::from_chars(first, end_, value);
    at_ = last;
    return error == std::errc() && is_json_number(std::string_view(first, last));
  }

  bool take_complex(std::complex<double>& value) {
    std::array<double, 2> parts{};
    std::size_t part = 0;
    if (!take_array(2, [&] { return part < 2 && take_number(parts[part++]); })) return false;
    value = {parts[0], parts[1]};
    return true;
  }

 private:
  void skip_space() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r')) ++at_;
  }

  /// Of what from_chars takes for a number: JSON wants digits before a point and behind it, no zero before
  /// other digits, and neither infinity nor NaN.
  static bool is_json_number(std::string_view number) {
    if (number.starts_with('-')) number.remove_prefix(1);
    const std::size_t point = number.find('.');
    const bool is_padded = number.size() > 1 && number[0] == '0' && is_digit(number[1]);
    const bool ends_at_point =
        point != std::string_view::npos && (point + 1 == number.size() || !is_digit(number[point + 1]));
    return is_digit(number[0]) && !is_padded && !ends_at_point;
  }

  const char* at_;
  const char* begin_;
  const char* end_;
};

/// Behind the colon of the first member of that name whose value is an array.
std::optional<std::size_t> find_array(std::string_view text, std::string_view name) {
  const std::string key = '"' + std::string(name) + '"';
  for (std::size_t place = text.find(key); place != std::string_view::npos;
       place = text.find(key, place + 1)) {
    Reader reader(text, place + key.size());
    if (!reader.take(':')) continue;
    const std::size_t value = reader.place();
    if (reader.take('[')) return value;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ComplexRows> take_complex_rows(std::string_view text, std::string_view name, int size) {
  const std::optional<std::size_t> start = find_array(text, name);
  if (!start) return std::nullopt;
  Reader reader(text, *start);
  ComplexRows result;
  const auto take_row = [&] {
    ComplexVectorX& row = result.rows.emplace_back();
    row.reserve(static_cast<std::size_t>(size));
    return reader.take_array(size, [&] { return reader.take_complex(row.emplace_back()); });
  };
  if (!reader.take_array(-1, take_row)) return std::nullopt;
  result.rest = std::string(text.substr(0, *start)) + "[]" + std::string(text.substr(reader.place()));
  return result;
}

}  // namespace gcs
