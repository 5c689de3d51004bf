/// A path that is lost is never silent: legs are lost on purpose, by a journal that gives back results other
/// than those computed.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/tests/braced_k44.hpp"
#include "solvers/answers/assess.hpp"
#include "solvers/homotopies/leg_block.hpp"

using namespace gcs;

namespace {

/// Spoils every so-many-th of the legs of some blocks, as if its steps had become too small.
class LosingJournal final : public Journal {
 public:
  /// From now on: leaves `kept` blocks alone and loses legs of the next `spoiled` ones.
  void lose(std::int64_t every, int kept, int spoiled) {
    every_ = every;
    kept_ = kept;
    spoiled_ = spoiled;
  }

  std::optional<Block> result(std::uint64_t, const std::function<std::optional<Block>()>& compute) override {
    std::optional<Block> block = compute();
    if (!block || kept_-- > 0 || spoiled_-- <= 0) return block;
    FollowedLegs followed = from_block(*block);
    for (LegResult& leg : followed.results) {
      if (++legs_ % every_ != every_ / 2) continue;
      leg.state.end = LegEnd::too_small;
      ++lost_;
    }
    return to_block(followed);
  }

  std::int64_t lost() const { return lost_; }

 private:
  std::int64_t every_ = 1;
  int kept_ = 0;
  int spoiled_ = 0;
  std::int64_t legs_ = 0;
  std::int64_t lost_ = 0;
};

constexpr int all = 1 << 20;  // more blocks than there are

/// A solve whose journal loses legs as it is told.
struct Lossy {
  Lossy(const ProblemStatement& problem, const OptionMap& given = {}, const std::string& name = "monodromy")
      : scene(Scene::unchecked(problem)),
        strategy(find_strategy(name).make(complete_options(find_strategy(name), given))),
        request(scene, {.journal = &journal}) {}

  Scene scene;
  LosingJournal journal;
  std::unique_ptr<Strategy> strategy;
  SolveRequest request;
};

std::int64_t ended(const SolveReport& report, PathRecord::End end) {
  return std::count_if(report.paths.begin(), report.paths.end(),
                       [end](const PathRecord& path) { return path.end == end; });
}

std::int64_t particular(const SolveReport& report, const std::string& name) {
  for (const Particular& count : report.particulars)
    if (count.name == name) return count.value;
  return -1;
}

ProblemStatement problem_of(const std::string& id) { return load_instance(id).problem; }

}  // namespace

TEST_CASE("paths lost on the way to the given lengths are failed paths of an incomplete list") {
  // 80 classes: half of the Laman number 160 (Capco et al. 2018).
  for (const std::int64_t every : {100, 20}) {
    Lossy lossy(problem_of("g160"));
    lossy.strategy->prepare(lossy.request);
    lossy.journal.lose(every, 0, 1);
    const SolveReport report = lossy.strategy->solve(lossy.request);
    const std::int64_t lost = lossy.journal.lost();
    REQUIRE(lost == (80 + every / 2) / every);
    CHECK(report.status == SolveStatus::partial);
    CHECK_THAT(report.reason, Catch::Contains("failed: its steps became too small"));
    // Of most the ends are real; complex ones whose conjugates others have are known.
    const std::int64_t failed = ended(report, PathRecord::End::failed);
    CHECK(failed > 0);
    CHECK(failed <= lost);
    CHECK(ended(report, PathRecord::End::regular) == 80 - failed);
    CHECK(static_cast<std::int64_t>(report.candidates.size()) == 80 - failed);
    CHECK(assess(lossy.scene, report).counts.failed_paths == static_cast<std::uint64_t>(failed));
  }
}

TEST_CASE("paths lost around their ends are followed in balls to the same ends") {
  // A signed sum of lengths around the walk 2, 3, 6, 5 vanishes, so that paths go to infinity (theory: the
  // octahedron's condition ±a23 ± a35 = ±a26 ± a56) and are walked around.
  ProblemStatement problem = problem_of("octahedron");
  const auto length = [&](const std::string& a, const std::string& b) -> double& {
    for (DistanceConstraint& c : problem.constraints) {
      const std::string from = problem.name(c.between[0]), to = problem.name(c.between[1]);
      if ((from != a || to != b) && (from != b || to != a)) continue;
      c.given.text.clear();
      return c.given.value;
    }
    throw std::logic_error("no such edge");
  };
  // In doubles exactly.
  for (const auto& [a, b] : {std::pair{"p2", "p6"}, {"p5", "p6"}, {"p3", "p5"}})
    length(a, b) = std::round(1024 * length(a, b)) / 1024;
  length("p2", "p3") = length("p2", "p6") + length("p5", "p6") - length("p3", "p5");
  Lossy lossy(problem);
  lossy.strategy->prepare(lossy.request);
  const SolveReport whole = lossy.strategy->solve(lossy.request);
  REQUIRE(whole.status == SolveStatus::complete);
  REQUIRE(ended(whole, PathRecord::End::at_infinity) > 0);
  for (int kept = 2; kept < 12; ++kept) {  // the way there and the direct approach, then some of what follows
    lossy.journal.lose(3, kept, all);
    const std::int64_t lost_before = lossy.journal.lost();
    const SolveReport report = lossy.strategy->solve(lossy.request);
    REQUIRE(lossy.journal.lost() > lost_before);
    CHECK(report.status == SolveStatus::complete);
    CHECK(report.candidates.size() == whole.candidates.size());
    for (const auto end : {PathRecord::End::regular, PathRecord::End::at_infinity})
      CHECK(ended(report, end) == ended(whole, end));
    CHECK(report.paths.size() == 8);
  }
}

TEST_CASE("paths lost in a search that meets the count cost nothing but other loops") {
  Lossy lossy(problem_of("g160"));
  lossy.journal.lose(100, 0, all);
  lossy.strategy->prepare(lossy.request);
  lossy.journal.lose(100, all, 0);
  const SolveReport report = lossy.strategy->solve(lossy.request);
  CHECK(lossy.journal.lost() > 0);
  CHECK(particular(report, "lost_loop_paths") == lossy.journal.lost());
  CHECK(report.status == SolveStatus::complete);
  CHECK(report.generic == 80U);
}

TEST_CASE("paths lost on the way from mixed cells cost nothing where the count is met") {
  // At most 8 classes (Bartzos, Emiris, Schicho 2020); nearly all of Bézout's paths run to infinity.
  const auto with_lost = [](std::int64_t every) {
    Lossy lossy(problem_of("octahedron"), {{"formulation", "coordinates"}}, "polyhedral");
    lossy.journal.lose(every, 0, all);
    lossy.strategy->prepare(lossy.request);
    lossy.journal.lose(every, all, 0);
    CHECK(lossy.journal.lost() > 0);
    return lossy.strategy->solve(lossy.request);
  };
  const SolveReport whole = with_lost(2000);
  CHECK(whole.status == SolveStatus::complete);
  CHECK(whole.generic == 8u);
  const SolveReport holes = with_lost(3);
  CHECK(holes.status == SolveStatus::partial);
  CHECK_FALSE(holes.generic);
}

TEST_CASE("paths lost in a search without a count leave open whether its list is complete") {
  // The trace test needs every path of its fibre, of more than a hundred points.
  Lossy lossy(braced_k44(), {{"arcs", "3"}});
  lossy.journal.lose(100, 0, all);
  lossy.strategy->prepare(lossy.request);
  lossy.journal.lose(100, all, 0);
  const SolveReport report = lossy.strategy->solve(lossy.request);
  CHECK(lossy.journal.lost() > 0);
  CHECK(report.status == SolveStatus::partial);
  CHECK_FALSE(report.generic);
  CHECK_THAT(report.reason, Catch::Contains("classes at random lengths, and the trace test did not succeed"));
}
