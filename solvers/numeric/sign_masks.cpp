#include "solvers/numeric/sign_masks.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace gcs {

SignMasks::SignMasks(const std::vector<int>& groups) {
  for (const int group : groups) masks_.push_back(group < 0 ? 0 : SignMask{1} << group);
}

int SignMasks::rank() const {
  SignEquations equations;
  for (const SignMask mask : masks_) equations.add(mask, true);
  return equations.rank();
}

std::vector<SignMask> SignMasks::kinds() const {
  std::set<SignMask> kinds(masks_.begin(), masks_.end());
  kinds.insert(0);
  return {kinds.begin(), kinds.end()};
}

std::vector<std::size_t> SignMasks::kind_numbers() const {
  const std::vector<SignMask> all = kinds();
  std::vector<std::size_t> numbers;
  for (const SignMask mask : masks_)
    numbers.push_back(static_cast<std::size_t>(std::ranges::lower_bound(all, mask) - all.begin()));
  return numbers;
}

bool SignEquations::add(SignMask mask, bool changes) {
  const auto lowest = [](SignMask bits) { return bits & (~bits + 1); };
  for (const Row& row : rows_)
    if ((mask & lowest(row.mask)) != 0) {
      mask ^= row.mask;
      changes = changes != row.changes;
    }
  if (mask == 0) return !changes;
  for (Row& row : rows_)
    if ((row.mask & lowest(mask)) != 0) {
      row.mask ^= mask;
      row.changes = row.changes != changes;
    }
  rows_.push_back({mask, changes});
  return true;
}

}  // namespace gcs
