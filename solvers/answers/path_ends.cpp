#include "solvers/answers/path_ends.hpp"

#include <array>
#include <map>
#include <numeric>
#include <tuple>

namespace gcs {

std::vector<PathEnds> ends_of(const std::vector<PathRecord>& paths) {
  std::map<std::tuple<PathRecord::End, int, int, bool, std::string>, std::uint64_t> counts;
  for (const PathRecord& path : paths)
    ++counts[{path.end, path.winding_number, path.pole_order, path.proven, path.cause}];
  std::vector<PathEnds> ends;
  for (const auto& [kind, count] : counts) {
    const auto& [end, winding_number, pole_order, proven, cause] = kind;
    ends.push_back({end, winding_number, pole_order, proven, cause, count});
  }
  return ends;
}

std::string_view word(PathRecord::End end) {
  constexpr std::array<std::string_view, 6> words{"closed",      "regular", "singular",
                                                  "at infinity", "failed",  "stopped"};
  return words[static_cast<std::size_t>(end)];
}

std::optional<Exponent> exponent(const PathEnds& ends) {
  if (ends.end != PathRecord::End::at_infinity || ends.winding_number <= 0 || ends.pole_order <= 0)
    return std::nullopt;
  const int divisor = std::gcd(ends.pole_order, ends.winding_number);
  return Exponent{ends.pole_order / divisor, ends.winding_number / divisor};
}

}  // namespace gcs
