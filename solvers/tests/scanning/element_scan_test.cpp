/// Scans of points, lines and planes against the real ones of all complex solutions.

#include "solvers/scanning/element_scan.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <gcsbench/gcsbench.hpp>

#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/elements/measured_scenes.hpp"

namespace gcs {
namespace {

std::size_t real_solutions(const Answer& answer) {
  return static_cast<std::size_t>(
      std::ranges::count_if(answer.solutions, [](const auto& solution) { return solution.is_real(); }));
}

}  // namespace

TEST_CASE("a fine scan of points and planes finds the real solutions that determinants give") {
  samples::RandomNumbers random(5);
  for (const int planes : {1, 2, 3})
    for (int i = 0; i < 3; ++i) {
      const Scene scene(samples::random_octahedral(planes, random));
      REQUIRE_FALSE(why_no_element_plan(scene, Instructions::all_places));
      CHECK(derive_element_plan(scene, Instructions::all_places).ranges.size() == 1);
      const Answer all = solve(scene, "cayley-menger");
      const Answer scan =
          solve(scene, "plan-scan", {{"method", "published"}, {"step", "0.1"}, {"delta", "0.1"}});
      INFO(planes << " planes, scene " << i << ": " << scan.reason);
      CHECK(scan.status == RunStatus::complete);
      CHECK(real_solutions(scan) == real_solutions(all));
    }
}

TEST_CASE("a scan of points and planes at the default spacing finds what lies between folds") {
  samples::RandomNumbers random(7);
  for (const int planes : {1, 2, 3})
    for (int i = 0; i < 8; ++i) {
      const Scene scene(samples::random_octahedral(planes, random));
      INFO(planes << " planes, scene " << i);
      CHECK(real_solutions(solve(scene, "plan-scan", {{"method", "published"}})) ==
            real_solutions(solve(scene, "cayley-menger")));
    }
}

TEST_CASE("a scan of points, lines and planes finds the real ones of all complex solutions") {
  samples::RandomNumbers random(51);
  for (const auto& [name, problem] : samples::measured_scenes(random)) {
    if (name == "line beside" || name == "lines") continue;  // 40 and 64 complex solutions
    const Scene scene = Scene::unchecked(problem);
    CAPTURE(name);
    const Answer scan = solve(scene, "plan-scan", {{"method", "published"}, {"step", "0.2"}});
    CHECK(scan.failed_checks.empty());
    const bool takes_long = name == "beside a body";
    const std::size_t real = real_solutions(solve(scene, takes_long ? "newton-multistart" : "monodromy"));
    CHECK(real > 0);
    CHECK(real_solutions(scan) == real);
  }
}

TEST_CASE("a scene that no plan places is refused with what has no instruction") {
  samples::RandomNumbers random(6);
  const auto reason =
      why_no_element_plan(Scene(samples::random_platform(3, random)), Instructions::all_places);
  REQUIRE(reason);
  CHECK(reason->find("no instruction") != std::string::npos);
  CHECK(reason->find("the body 'b1', which is met by: distance 'p0'") != std::string::npos);
}

}  // namespace gcs
