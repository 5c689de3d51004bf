#pragma once
/// The library in one header: a problem is stated or read, a strategy solves it, and the answer is assessed and, when
/// asked for, proven.
///
///     gcs::Problem p(2);
///     p.points("a", "b", "c").distance("a", "b", "3.1").distance("b", "c", 4).distance("c", "a", 5);
///     const gcs::Answer answer = gcs::solve(p, "monodromy");
///     for (const auto& solution : answer.solutions) std::cout << solution.point("c").transpose() << '\n';

#include "solvers/solving/answer.hpp"
#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
