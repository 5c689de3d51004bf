/// Ends of paths that the rounding of lengths to doubles moves to infinity, and back.

#include "solvers/homotopies/precise_ends.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"

using namespace gcs;

namespace {

/// b and c are at heights ±h and ±2h over the middle of a segment of length 2, and p is 1 from b and 2 from c.
struct NearCentres {
  double h = 0;
  const char* square_of_b;  ///< 1 + h²
  const char* square_of_c;  ///< 1 + 4h²
};

/// `with_line`: one through c and q makes the scene a general one, of other equations.
Answer solved(const NearCentres& scene, const char* strategy, bool with_line) {
  Problem problem(2);
  problem.points("p", "c", "q", "b", "r")
      .squared_distance("c", "r", scene.square_of_c)
      .squared_distance("p", "b", "1")
      .squared_distance("q", "c", scene.square_of_c)
      .squared_distance("r", "q", "4")
      .squared_distance("b", "q", scene.square_of_b)
      .squared_distance("p", "c", "4")
      .squared_distance("b", "r", scene.square_of_b);
  if (with_line) problem.lines("l").on("c", "l").on("q", "l");
  return solve(problem, strategy, {{"reduce", "off"}});
}

/// The circles' radical axis is at the height y = (4h² − h² − 3)/(2(y_c − y_b)) where b and c are on the given sides, and p
/// there beside the middle by i·√((y − y_b)² − 1).
double size_beside(double h, int side_of_c) {
  const double base = 2 * side_of_c * h - h, y = (3 * h * h - 3) / (2 * base);
  return std::sqrt((y - h) * (y - h) - 1);
}

}  // namespace

TEST_CASE("solutions that rounded lengths send to infinity are found where the file's lengths put them") {
  const bool with_line = GENERATE(false, true);
  for (const NearCentres& scene :
       {NearCentres{1e-6, "1.000000000001", "1.000000000004"},
        NearCentres{1e-8, "1.0000000000000001", "1.0000000000000004"},
        NearCentres{1e-10, "1.00000000000000000001", "1.00000000000000000004"},
        NearCentres{1e-12, "1.000000000000000000000001", "1.000000000000000000000004"}})
    for (const char* strategy : {"monodromy", "polyhedral"}) {
      const Answer answer = solved(scene, strategy, with_line);
      INFO(scene.h << ", " << strategy << (with_line ? " with a line: " : ": ") << answer.reason);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.counts.at_infinity == 0u);
      std::vector<double> found;
      for (const auto& solution : answer.solutions) {
        const Eigen::VectorXcd beside = solution.complex_point("p") - solution.complex_point("b");
        found.push_back(beside.imag().cwiseAbs().maxCoeff());
      }
      std::sort(found.begin(), found.end());
      REQUIRE(found.size() == 4);
      for (const auto& [i, side_of_c] : {std::pair{0, -1}, {1, -1}, {2, 1}, {3, 1}})
        CHECK(found[static_cast<std::size_t>(i)] == Approx(size_beside(scene.h, side_of_c)).epsilon(1e-9));
    }
}

TEST_CASE("solutions that are at infinity are said to be there") {
  const Answer answer = solved({0, "1", "1"}, "monodromy", GENERATE(false, true));
  INFO(answer.reason);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.solutions.empty());
  CHECK(answer.counts.at_infinity == 4u);
}
