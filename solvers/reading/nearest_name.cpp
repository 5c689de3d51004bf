#include "solvers/reading/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace gcs {
namespace {

/// Only the beginning of a name is compared, so that hostile input costs nothing.
constexpr std::size_t compared_length = 64;

std::string comparable(std::string_view name) {
  std::string result(name.substr(0, compared_length));
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// Levenshtein's distance.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view misspelt, std::span<const std::string> names) {
  const std::string wanted = comparable(misspelt);
  const auto farther = [&](const std::string& a, const std::string& b) {
    return edit_distance(wanted, comparable(a)) < edit_distance(wanted, comparable(b));
  };
  const auto nearest = std::min_element(names.begin(), names.end(), farther);
  return nearest == names.end() ? std::string() : *nearest;
}

std::string quoted_list(std::span<const std::string> names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) result += i + 1 == names.size() ? " and " : ", ";
    result += "'" + names[i] + "'";
  }
  return result;
}

}  // namespace gcs
