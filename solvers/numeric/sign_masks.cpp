#include "solvers/numeric/sign_masks.hpp"

#include <algorithm>
#include <bit>
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

SignMask generators_of(const SignMasks& masks) {
  SignMask generators = 0;
  for (const SignMask mask : masks) generators |= mask;
  return generators;
}

Eigen::VectorXd signs_by(const SignMasks& masks, SignMask element) {
  Eigen::VectorXd signs(static_cast<Eigen::Index>(masks.size()));
  for (std::size_t i = 0; i < masks.size(); ++i)
    signs[static_cast<Eigen::Index>(i)] = std::popcount(masks[i] & element) % 2 == 1 ? -1.0 : 1.0;
  return signs;
}

Eigen::VectorXd signs_towards(const SignMasks& masks, SignMask generators, const Eigen::VectorXd& y0,
                              const Eigen::VectorXd& y) {
  SignMask changed = 0;
  const auto sign = [&](std::size_t i) { return std::popcount(masks[i] & changed) % 2 == 1 ? -1.0 : 1.0; };
  for (SignMask rest = generators; rest != 0; rest &= rest - 1) {
    const SignMask generator = rest & (~rest + 1);
    double agreement = 0;
    for (std::size_t i = 0; i < masks.size(); ++i)
      if (std::bit_floor(masks[i] & generators) == generator)
        agreement += sign(i) * y0[static_cast<Eigen::Index>(i)] * y[static_cast<Eigen::Index>(i)];
    if (agreement < 0) changed |= generator;
  }
  Eigen::VectorXd signs = Eigen::VectorXd::Ones(y.size());
  for (std::size_t i = 0; i < masks.size(); ++i) signs[static_cast<Eigen::Index>(i)] = sign(i);
  return signs;
}

Eigen::VectorXd turned_towards(const SignMasks& masks, const Eigen::VectorXd& y0, const Eigen::VectorXd& y) {
  return y0.cwiseProduct(signs_towards(masks, generators_of(masks), y0, y));
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
