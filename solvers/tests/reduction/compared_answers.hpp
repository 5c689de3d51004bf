#pragma once
/// Scenes solved in parts, and the same ones in one piece.

#include <string>
#include <vector>

#include "solvers/solving/solve.hpp"

namespace gcs::samples {

Answer answer_to(const ProblemStatement& problem, const std::string& reduce = "on",
                 const std::string& strategy = "monodromy");

std::uint64_t real_ones(const Answer& answer);

/// As many solutions, all certified, one of them the figure that the values are of.
void check_count(const Answer& answer, std::size_t count);

/// In how many classes the solutions of both fall.
int classes_of(const Scene& scene, const Answer& a, const Answer& b);

/// As many in parts and in one piece, the same ones.
void check_same_in_one_piece(const ProblemStatement& problem, std::size_t count);

/// What is placed one by one, in its order, by names.
std::vector<std::string> placed_names(const ProblemStatement& problem);
/// How many parts are solved apart.
int cores_of(const ProblemStatement& problem);

}  // namespace gcs::samples
