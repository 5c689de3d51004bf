#include "harness/solving/solve_run.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "harness/tests/instances/toy_scene.hpp"

using namespace gcs;

namespace {

/// Does what its option `behaviour` says.
class ToyStrategy final : public Strategy {
 public:
  explicit ToyStrategy(std::string behaviour) : behaviour_(std::move(behaviour)) {
    if (behaviour_ == "wrong") throw OptionError("option behaviour=wrong: expected something else");
  }

  std::optional<std::string> why_unsupported(const SolveRequest&) const override {
    if (behaviour_ == "refuses") return "it does not want to";
    return std::nullopt;
  }

  void prepare(const SolveRequest&) override {
    if (behaviour_ == "fails early") throw std::runtime_error("no luck");
  }

  SolveReport solve(const SolveRequest& request) override {
    SolveReport report = toy::good_report(request.scene);
    if (behaviour_ == "fails") throw std::runtime_error("no luck");
    if (behaviour_ == "waits")
      while (!request.stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (behaviour_ == "waits" || behaviour_ == "stops") report.status = SolveStatus::stopped;
    if (behaviour_ == "gives up") {
      report.status = SolveStatus::gave_up;
      report.reason = "it is too hard";
    }
    if (behaviour_ == "generic 1") report.generic = 1;
    if (behaviour_ == "generic 2") report.generic = 2;
    if (behaviour_ == "multiplicity 2") report.candidates.front().multiplicity = 2;
    if (behaviour_ == "all" || behaviour_ == "all, often") report.claim = Claim::all_complex;
    if (behaviour_ == "all, often")
      for (const std::vector<Candidate> once = report.candidates; report.candidates.size() <= 1000;)
        report.candidates.insert(report.candidates.end(), once.begin(), once.end());
    return report;
  }

 private:
  std::string behaviour_;
};

StrategyEntry toy_entry() {
  StrategyEntry entry;
  entry.name = "toy";
  entry.options = {{"behaviour", "good", "any word", "what it does"}};
  entry.make = [](const OptionMap& options) -> std::unique_ptr<Strategy> {
    return std::make_unique<ToyStrategy>(options.at("behaviour"));
  };
  return entry;
}

SolveRun run(const std::string& behaviour, const RunLimits& limits = {}, Monitor* monitor = nullptr) {
  const Scene scene(toy::instance().problem);
  return run_strategy(toy_entry(), {{"behaviour", behaviour}}, scene, limits, {monitor});
}

/// Lets time pass with every report.
struct SlowMonitor final : Monitor {
  explicit SlowMonitor(std::chrono::milliseconds pause) : pause_(pause) {}
  void progress(std::string_view, double) override { std::this_thread::sleep_for(pause_); }

 private:
  std::chrono::milliseconds pause_;
};

}  // namespace

TEST_CASE("a complete run holds what was asked for and what was found") {
  const SolveRun result = run("good", {{.seed = 7, .threads = 2}});
  CHECK(result.status == RunStatus::complete);
  CHECK(result.reason.empty());
  CHECK(result.strategy == "toy");
  CHECK(result.options == OptionMap{{"behaviour", "good"}});
  CHECK(result.seed == 7);
  CHECK(result.threads == 2);
  CHECK(result.claim == Claim::on_path);
  CHECK(result.counts.on_path == 2u);
  CHECK(result.timing.wall_s > 0);
  CHECK(result.timing.prepare_s > 0);
}

TEST_CASE("an option that is not allowed or not known is the caller's error") {
  CHECK_THROWS_AS(run("wrong"), OptionError);
  const Scene scene(toy::instance().problem);
  CHECK_THROWS_AS(run_strategy(toy_entry(), {{"behavior", "good"}}, scene, {}), OptionError);
}

TEST_CASE("a strategy that cannot do the scene is not run") {
  const SolveRun result = run("refuses");
  CHECK(result.status == RunStatus::unsupported);
  CHECK(result.reason == "it does not want to");
  CHECK_FALSE(result.claim);
  CHECK_FALSE(result.counts.singular);
}

TEST_CASE("a path strategy needs a sketch") {
  const Scene scene(toy::instance("8", "10", false).problem);
  StrategyEntry entry = toy_entry();
  CHECK(run_strategy(entry, {}, scene, {}).status == RunStatus::complete);
  entry.needs_sketch = true;
  const SolveRun result = run_strategy(entry, {}, scene, {});
  CHECK(result.status == RunStatus::unsupported);
  CHECK_THAT(result.reason, Catch::Contains("sketch"));
}

TEST_CASE("an exception ends the strategy, not the program") {
  for (const std::string behaviour : {"fails", "fails early"}) {
    const SolveRun result = run(behaviour);
    CHECK(result.status == RunStatus::gave_up);
    CHECK(result.has_failed);
    CHECK_THAT(result.reason, Catch::Contains("no luck"));
  }
}

TEST_CASE("giving up keeps the strategy's reason and what it found") {
  const SolveRun result = run("gives up");
  CHECK(result.status == RunStatus::gave_up);
  CHECK(result.reason == "it is too hard");
  CHECK_FALSE(result.has_failed);
  CHECK(result.solutions.size() == 2);
}

TEST_CASE("the time limit stops a strategy and keeps what it found") {
  const auto start = std::chrono::steady_clock::now();
  const SolveRun result = run("waits", {{}, 0.05});
  CHECK(std::chrono::steady_clock::now() - start >= std::chrono::milliseconds(50));
  CHECK(result.status == RunStatus::timed_out);
  CHECK_THAT(result.reason, Catch::Contains("0.05 s"));
  CHECK(result.solutions.size() == 2);
}

TEST_CASE("the time limit stops proofs unless it is for the solve alone") {
  SlowMonitor slow(std::chrono::milliseconds(1200));
  RunLimits limits{{.certify = true}, 1};
  const SolveRun stopped = run("good", limits, &slow);
  CHECK(stopped.status == RunStatus::timed_out);
  CHECK(stopped.reason == "the time limit of 1 s has passed while solutions were proven");
  CHECK(stopped.counts.certified == 1);
  limits.limits_proofs = false;
  const SolveRun proven = run("good", limits, &slow);
  CHECK(proven.status == RunStatus::complete);
  CHECK(proven.counts.certified == 2);
}

TEST_CASE("a strategy that stops by itself has given up") {
  CHECK(run("stops", {{}, 1000}).status == RunStatus::gave_up);
}

TEST_CASE("a limit that was not reached changes nothing") {
  const SolveRun result = run("good", {{.max_solutions = 2}, 1e30});
  CHECK(result.status == RunStatus::complete);
  CHECK(result.solutions.size() == 2);
}

TEST_CASE("a list cut short is partial and says so") {
  const SolveRun result = run("good", {{.max_solutions = 1}});
  CHECK(result.status == RunStatus::partial);
  CHECK(result.reason == "1 of the 2 solutions found are kept, as asked");
  CHECK(result.solutions.size() == 1);
}

TEST_CASE("a long list of all solutions some of which doubles take for others is not called complete") {
  const SolveRun result = run("all, often");
  CHECK(result.status == RunStatus::partial);
  CHECK_THAT(result.reason, Catch::Contains("doubles do not tell all apart"));
}

TEST_CASE("counts that exceed the theoretical ones or differ from the exact one are failed checks") {
  const auto failed = [](const std::string& behaviour) {
    std::vector<std::string> names;
    for (const FailedCheck& check : run(behaviour).failed_checks) names.push_back(check.name);
    return names;
  };
  // Two points hang on a segment: two classes, whatever the lengths.
  using Names = std::vector<std::string>;
  CHECK(failed("good").empty());
  CHECK(failed("generic 2").empty());
  CHECK(failed("generic 1") == Names{"count"});
  CHECK(failed("multiplicity 2") == Names{"count"});
}

TEST_CASE("what is left of all complex solutions when only real ones are kept are all real ones") {
  CHECK(run("all").claim == Claim::all_complex);
  CHECK(run("all", {{.only_real = true}}).claim == Claim::all_real);
  CHECK(run("good", {{.only_real = true}}).claim == Claim::on_path);
}
