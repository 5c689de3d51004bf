#pragma once
/// A graph in space whose solutions are fewer than any bound says that is known.

#include <array>
#include <string>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// K4,4 and two bars more, all lengths nearly alike.
inline ProblemStatement braced_k44() {
  ProblemStatement problem;
  problem.dimension = 3;
  for (int point = 1; point <= 8; ++point) problem.points.push_back("p" + std::to_string(point));
  const auto add = [&](int a, int b) {
    constexpr std::array lengths{53, 67, 61, 50, 64, 57, 69};
    const int length = lengths[problem.constraints.size() % lengths.size()];
    problem.constraints.push_back({"", {a, b}, {static_cast<double>(length), std::to_string(length)}, false});
  };
  add(0, 1);
  add(2, 3);
  for (int a = 0; a < 4; ++a)
    for (int b = 4; b < 8; ++b) add(a, b);
  return problem;
}

}  // namespace gcs
