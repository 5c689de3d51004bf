/// Answers against references: what is met, missed and spurious, how large errors are, and what is shown of
/// it.

#include <catch2/catch.hpp>
#include <set>

#include "harness/results/accuracy.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/tables/table_run.hpp"
#include "harness/tables/tables.hpp"

using namespace gcs;

namespace {

struct NoMonitor final : Monitor {
  void progress(std::string_view, double) override {}
};

SolveRun solved(const Scene& scene, const std::string& strategy, int digits = 0) {
  RunLimits limits;
  limits.digits = digits;
  return run_strategy(find_strategy(strategy), {}, scene, limits);
}

ReferenceList reference_of(const Instance& instance, const Scene& scene) {
  NoMonitor monitor;
  return reference_for(instance, scene, 60, monitor);
}

/// A scene, and a judge of answers about it.
struct Court {
  explicit Court(const std::string& id)
      : instance(load_instance(id)), scene(instance.problem), judge(scene, reference_of(instance, scene)) {}

  Instance instance;
  Scene scene;
  AccuracyJudge judge;
};

}  // namespace

TEST_CASE("right answers meet all solutions that they claim, with errors of rounding") {
  struct Case {
    const char* instance;
    const char* strategy;
    std::uint64_t met;
  };
  for (const Case& one :
       {Case{"octahedron", "cayley-menger", 8}, Case{"octahedron", "rcp", 4},
        Case{"disulfide", "full-space", 8}, Case{"prism", "plan-scan", 12},
        Case{"hoffmann-yuan", "theta-scan", 6}, Case{"tangents-durand", "sphere-tangents", 12},
        Case{"planar-platform", "monodromy", 6}, Case{"octahedral-3p3h", "cayley-menger", 8}}) {
    INFO(one.instance << ", " << one.strategy);
    const Court court(one.instance);
    const Accuracy accuracy = court.judge.judge(solved(court.scene, one.strategy), 0);
    CHECK(accuracy.met == one.met);
    CHECK(accuracy.missed == 0u);
    CHECK(accuracy.spurious == 0);
    CHECK(accuracy.largest_error > 1e-20);
    CHECK(accuracy.largest_error < 1e-10);
    CHECK(accuracy.median_error <= accuracy.largest_error);
  }
}

TEST_CASE("an error is the distance that a point was moved, a mirror image none, and others are spurious") {
  const Court court("octahedron");
  SolveRun run = solved(court.scene, "cayley-menger");
  std::vector<AssessedSolution>& solutions = run.solutions;
  const double size = court.scene.size();

  solutions[1].figure.points.row(2) *= -1;
  CHECK(court.judge.judge(run, 0).largest_error < 1e-12);

  solutions[2].figure.points(0, 3) += 3e-6 * size;
  solutions[2].figure.points(1, 3) += 4e-6 * size;
  CHECK(court.judge.judge(run, 0).largest_error == Approx(5e-6).epsilon(1e-6));
  CHECK(court.judge.judge(run, 0).median_error < 1e-12);

  solutions[3].figure.points(0, 3) += size;
  Accuracy accuracy = court.judge.judge(run, 0);
  CHECK(accuracy.met == 7);
  CHECK(accuracy.missed == 1u);
  CHECK(accuracy.spurious == 1);

  solutions[3] = solutions[0];
  accuracy = court.judge.judge(run, 0);
  CHECK(accuracy.missed == 1u);
  CHECK(accuracy.spurious == 1);

  // Of a path nothing is missed but what lies on it.
  run.claim = Claim::all_real;
  CHECK(court.judge.judge(run, 0).missed == 1u);
  run.claim = Claim::some_real;
  solutions.erase(solutions.begin() + 3);
  accuracy = court.judge.judge(run, 0);
  CHECK(accuracy.spurious == 0);
  CHECK(accuracy.missed.value_or(0) > 0);
  CHECK(accuracy.contradicts(Claim::all_real));
  CHECK_FALSE(accuracy.contradicts(Claim::some_real));
}

TEST_CASE("refined answers are as exact as was asked for") {
  const Court court("octahedron");
  for (const int digits : {30, 60, 100}) {
    const Accuracy accuracy = court.judge.judge(solved(court.scene, "rcp", digits), digits);
    CHECK(accuracy.met == 4);
    CHECK(accuracy.largest_error < std::pow(10.0, 1 - digits));
    CHECK(accuracy.largest_error > std::pow(10.0, -5 - digits));
  }
}

TEST_CASE("refined answers are as exact in general scenes, of bodies and of planes") {
  for (const char* id : {"planar-platform", "octahedral-3p3h"}) {
    INFO(id);
    const Court court(id);
    const SolveRun run = solved(court.scene, "monodromy", 60);
    CHECK(run.refined.size() == run.solutions.size());
    CHECK(court.judge.judge(run, 60).largest_error < 1e-57);
    CHECK(court.judge.judge(run, 60).largest_error > 1e-70);
  }
}

TEST_CASE("a plane that is moved is off by as much") {
  const Court court("octahedral-3p3h");
  SolveRun run = solved(court.scene, "cayley-menger");
  run.solutions.front().figure.planes.front().offset += 1e-5 * court.scene.size();
  CHECK(court.judge.judge(run, 0).largest_error == Approx(1e-5).epsilon(1e-4));
}

TEST_CASE("an instance that is not shipped gets a reference of its own, proven") {
  Instance instance = load_instance("octahedron");
  instance.id = "another";
  const Scene scene(instance.problem);
  REQUIRE_FALSE(shipped_reference(instance, scene));
  const ReferenceList list = reference_of(instance, scene);
  CHECK(list.source == "proven in this run");
  CHECK(list.solutions.size() == 8);
  CHECK(list.has_all_complex);
  REQUIRE(list.on_path);
  CHECK(std::count(list.on_path->begin(), list.on_path->end(), true) == 4);
}

TEST_CASE("a shipped reference serves the very instance only") {
  Instance instance = load_instance("k33");
  const Scene scene(instance.problem);
  REQUIRE(shipped_reference(instance, scene));
  instance.document.members.front().second.text += " ";
  CHECK_FALSE(shipped_reference(instance, scene));
}

TEST_CASE("every accuracy setting of every strategy is one that it allows") {
  for (const StrategyEntry& entry : all_strategies())
    for (const OptionMap& setting : entry.accuracy_settings) {
      INFO(entry.name);
      CHECK_FALSE(setting.empty());
      CHECK_NOTHROW(entry.make(complete_options(entry, setting)));
    }
}

TEST_CASE("precision measures every strategy that can do the instance with all of its settings") {
  TableRequest request;
  request.tables = {"precision"};
  request.instances = {"k33"};
  request.repetitions = 3;
  NoMonitor monitor;
  const RunFile run = run_tables(request, {}, monitor);
  std::set<std::string> measured;
  for (const CellRecord& cell : run.cells) {
    if (cell.status == RunStatus::unsupported) continue;
    REQUIRE(cell.accuracy);
    measured.insert(cell.spec.strategy);
  }
  const Scene scene(load_instance("k33").problem);
  for (const StrategyEntry& entry : all_strategies())
    CHECK(measured.count(std::string(entry.name)) ==
          (why_not(entry, *entry.make(complete_options(entry, {})), scene) ? 0 : 1));
  CHECK(measured.size() >= 6);
  for (const std::string& strategy : measured) {
    const CellRecord* exact = run.find({"k33", strategy, {}, 100});
    REQUIRE(exact != nullptr);
    // Complex points are up to 70 times further away than the scene is large.
    CHECK(exact->accuracy->largest_error < 1e-97);
    CHECK(exact->repetitions.size() == 3);
    CHECK(exact->repetitions.front().refine_s > 0);
    CHECK(run.find({"k33", strategy, {}})->accuracy->missed == 0u);
  }

  const RunFile stored = parse_run_file(to_json_text(run), "run.json");
  const TableSet set = build_tables(stored, {});
  REQUIRE(set.tables.size() == 1);
  CHECK(set.tables.front().name == "precision-k33");
  std::vector<std::string> remarks = build_precision(run, {}).front().remarks;
  remarks.push_back(measured_with(run));
  CHECK(set.tables.front().remarks == remarks);
  std::set<std::string> drawings;
  for (const Drawing& drawing : set.drawings) drawings.insert(drawing.name);
  CHECK(drawings ==
        std::set<std::string>{"precision-k33", "precision-profile-all", "precision-profile-path"});
  CHECK(set.drawings.front().svg == draw_precision(run).front().svg);
}
