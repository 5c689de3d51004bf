#include "solvers/systems/homogeneous_bound.hpp"

#include <algorithm>
#include <numeric>

namespace gcs {
namespace {

using Groups = std::vector<int>;

int count_of(const Groups& group_of) { return *std::max_element(group_of.begin(), group_of.end()) + 1; }

/// d_ij
std::vector<std::vector<int>> degrees_of(const Supports& supports, const Groups& group_of) {
  std::vector<std::vector<int>> degrees;
  const std::size_t groups = static_cast<std::size_t>(count_of(group_of));
  for (const Support& support : supports) {
    std::vector<int>& highest = degrees.emplace_back(groups, 0);
    for (const Exponents& monomial : support) {
      std::vector<int> degree(groups, 0);
      for (std::size_t v = 0; v < monomial.size(); ++v)
        degree[static_cast<std::size_t>(group_of[v])] += monomial[v];
      for (std::size_t j = 0; j < groups; ++j) highest[j] = std::max(highest[j], degree[j]);
    }
  }
  return degrees;
}

/// The coefficient, by the powers of the α_j that products of some of the factors have, none above k_j.
template <class Number>
Number coefficient(const Supports& supports, const Groups& group_of) {
  const std::size_t groups = static_cast<std::size_t>(count_of(group_of));
  std::vector<std::size_t> size(groups, 0), stride(groups, 1);
  for (const int group : group_of) ++size[static_cast<std::size_t>(group)];
  for (std::size_t j = 1; j < groups; ++j) stride[j] = stride[j - 1] * (size[j - 1] + 1);
  std::vector<Number> powers(stride.back() * (size.back() + 1));
  powers[0] = Number(1);
  for (const std::vector<int>& degrees : degrees_of(supports, group_of)) {
    std::vector<Number> next(powers.size());
    for (std::size_t state = 0; state < powers.size(); ++state) {
      if (powers[state] == Number(0)) continue;
      for (std::size_t j = 0; j < groups; ++j)
        if (degrees[j] > 0 && state / stride[j] % (size[j] + 1) < size[j])
          next[state + stride[j]] += powers[state] * Number(static_cast<std::uint64_t>(degrees[j]));
    }
    powers = std::move(next);
  }
  return powers.back();
}

/// With groups numbered in the order of their first unknowns.
Groups numbered(const Groups& group_of) {
  std::vector<int> number(group_of.size() + 1, -1);
  Groups result;
  int next = 0;
  for (const int group : group_of) {
    int& of_group = number[static_cast<std::size_t>(group)];
    if (of_group < 0) of_group = next++;
    result.push_back(of_group);
  }
  return result;
}

/// One unknown moved to another group or to one of its own, or two groups joined.
std::vector<Groups> neighbours(const Groups& group_of) {
  std::vector<Groups> all;
  const int groups = count_of(group_of);
  for (int one = 0; one < groups; ++one)
    for (int other = one + 1; other < groups; ++other) {
      Groups joined = group_of;
      std::replace(joined.begin(), joined.end(), other, one);
      all.push_back(numbered(joined));
    }
  for (std::size_t v = 0; v < group_of.size(); ++v)
    for (int group = 0; group <= groups; ++group) {
      Groups moved = group_of;
      moved[v] = group;
      if (group != group_of[v]) all.push_back(numbered(moved));
    }
  return all;
}

/// Downhill, to the smallest neighbour each time. In doubles, which hold what is compared here or are near it.
Groups improved(const Supports& supports, Groups group_of) {
  double least = coefficient<double>(supports, group_of);
  for (bool falls = true; falls;) {
    falls = false;
    for (const Groups& next : neighbours(Groups(group_of))) {
      const double bound = coefficient<double>(supports, next);
      if (bound >= least) continue;
      least = bound;
      group_of = next;
      falls = true;
    }
  }
  return group_of;
}

}  // namespace

Natural homogeneous_bound(const Supports& supports, const std::vector<int>& group_of) {
  return coefficient<Natural>(supports, group_of);
}

HomogeneousBound small_homogeneous_bound(const Supports& supports) {
  Groups together(supports.size(), 0), apart(supports.size());
  std::iota(apart.begin(), apart.end(), 0);
  HomogeneousBound best;
  for (const Groups& start : {together, apart}) {
    Groups groups = improved(supports, start);
    Natural bound = homogeneous_bound(supports, groups);
    if (best.group_of.empty() || bound < best.bound) best = {std::move(bound), std::move(groups)};
  }
  return best;
}

}  // namespace gcs
