/// What a struct of options declares is what help says, what is checked, and what its values are as texts.

#include "solvers/interface/options.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "solvers/strategies/cayley_menger.hpp"
#include "solvers/strategies/full_space.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/newton_multistart.hpp"
#include "solvers/strategies/plan_scan.hpp"
#include "solvers/strategies/polyhedral.hpp"
#include "solvers/strategies/rcp.hpp"
#include "solvers/strategies/sphere_tangents.hpp"
#include "solvers/strategies/system_paths.hpp"
#include "solvers/strategies/theta_scan.hpp"

using namespace gcs;

namespace {

const StrategyEntry& entry_named(std::string_view name) {
  for (const StrategyEntry& entry : all_strategies())
    if (entry.name == name) return entry;
  throw std::logic_error("no strategy " + std::string(name));
}

std::unique_ptr<Strategy> made(const StrategyEntry& entry, const OptionMap& given) {
  return entry.make(complete_options(entry, given));
}

template <class Options>
void check_texts(const Options& values, const OptionMap& expected) {
  INFO(Options::strategy);
  CHECK(options_of(values) == expected);
}

/// Every option has another value than its default, so that one which is tied to the wrong member shows.
template <class Options>
void check_round_trip(const Options& values) {
  INFO(Options::strategy);
  const OptionMap defaults = options_of(Options{}), texts = options_of(values);
  CHECK(texts.size() == defaults.size());
  for (const auto& [name, text] : texts) {
    INFO(name);
    CHECK(text != defaults.find(name)->second);
  }
  CHECK(read_options<Options>(texts) == values);
  CHECK_NOTHROW(complete_options(entry_named(Options::strategy), texts));
}

/// Where an option's values are words, each is read as itself, and no other is.
template <class Options>
void check_words() {
  INFO(Options::strategy);
  for (const OptionSpec& spec : specs_of<Options>()) {
    if (spec.allowed.find(' ') != std::string::npos) continue;
    const std::string name(spec.name);
    std::istringstream words(spec.allowed);
    for (std::string word; std::getline(words, word, '|');)
      CHECK(options_of(read_options<Options>({{name, word}})).find(name)->second == word);
    for (const std::string word : {"nonsense", "", "|"})
      CHECK_THROWS_WITH(read_options<Options>({{name, word}}),
                        Catch::StartsWith("option " + name + "=" + word + ": expected " + spec.allowed));
  }
}

struct HelpRange {
  std::string low, high;
  bool is_whole = false;
};

/// What help says of a number: "… a whole number from 2 to 1000".
std::optional<HelpRange> range_in(const std::string& allowed) {
  const auto at = allowed.find("number from ");
  if (at == std::string::npos) return std::nullopt;
  HelpRange range;
  std::string to;
  std::istringstream words(allowed.substr(at + std::string("number from ").size()));
  words >> range.low >> to >> range.high;
  range.is_whole = allowed.find("whole number") != std::string::npos;
  return range;
}

/// The next number above, or below for the direction −1.
std::string next_to(const std::string& number, bool is_whole, int direction) {
  if (is_whole) return std::to_string(std::stoll(number) + direction);
  const double infinity = std::numeric_limits<double>::infinity();
  return Range<double>::text(std::nextafter(std::stod(number), direction * infinity));
}

}  // namespace

TEST_CASE("defaults have the texts that results keep") {
  const OptionMap path{{"max_steps", "1000000"},   {"mode", "fast"},     {"order", "12"},
                       {"orientation", "forward"}, {"step_max", "auto"}, {"tolerance", "1e-7"},
                       {"until", "closed"}};
  OptionMap full_space = path, rcp = path;
  full_space.insert({{"jumps", "ignored"}});
  rcp.insert({{"alpha", "0.1"},
              {"as", "mended"},
              {"derivatives", "partial"},
              {"direction", "as"},
              {"measure", "as"},
              {"restoring", "as"},
              {"shift", "as"},
              {"swap", "on"},
              {"turning", "as"}});
  check_texts(FullSpace{}, full_space);
  check_texts(Rcp{}, rcp);

  const OptionMap homotopy{{"instructions", "auto"},
                           {"mirror_images", "divided"},
                           {"order", "12"},
                           {"precision", "auto"},
                           {"tolerance", "1e-6"}};
  OptionMap monodromy = homotopy, polyhedral = homotopy;
  monodromy.insert({{"arcs", "12"}, {"save_start", "none"}, {"start", "none"}, {"trace", "on"}});
  polyhedral.insert({{"formulation", "spheres"}});
  check_texts(Monodromy{}, monodromy);
  check_texts(Polyhedral{}, polyhedral);

  check_texts(CayleyMenger{}, {{"method", "eigenvalues"}});
  check_texts(
      ThetaScan{},
      {{"delta", "0.2"}, {"dtheta", "1"}, {"max_cells", "100000000"}, {"method", "events"}, {"start", "0"}});
  check_texts(SphereTangents{}, {{"method", "direct"}, {"system", "quadrics"}});
  check_texts(PlanScan{}, {{"delta", "auto"},
                           {"max_cells", "100000000"},
                           {"max_points", "100000000"},
                           {"method", "certified"},
                           {"most_angles", "2"},
                           {"start", "0"},
                           {"step", "1"}});
  check_texts(SystemPaths{}, {{"start", "mixed-cells"}, {"system", "quartics"}});
  check_texts(NewtonMultistart{}, {{"starts", "1000"}, {"unseen", "0.5"}});
}

TEST_CASE("values come back from their texts") {
  const PathSettings tracking{.step_max = 0.1 + 0.2,
                              .max_steps = 750'000'000,
                              .orientation = PathSettings::Orientation::backward,
                              .until = PathSettings::Until::first,
                              .order = 40,
                              .tolerance = 1.0 / 3e9};
  check_round_trip(
      FullSpace{.mode = FullSpace::Mode::certified, .tracking = tracking, .jumps = FullSpace::Jumps::named});
  check_round_trip(Rcp{.mode = Rcp::Mode::paper,
                       .tracking = tracking,
                       .alpha = 0.3,
                       .as = Rcp::Text::printed,
                       .measure = Rcp::Choice::printed,
                       .shift = Rcp::Choice::mended,
                       .direction = Rcp::Choice::printed,
                       .restoring = Rcp::Choice::mended,
                       .turning = Rcp::Choice::mended,
                       .swap = false,
                       .derivatives = Rcp::Derivatives::whole});
  const HomotopySettings paths{.order = 14,
                               .tolerance = 2e-5,
                               .precision = HomotopySettings::Precision::twice,
                               .mirror_images = HomotopySettings::MirrorImages::followed,
                               .instructions = HomotopySettings::Instructions::avx512};
  check_round_trip(
      Monodromy{.arcs = 20, .trace = false, .start = "old", .save_start = "new", .tracking = paths});
  check_round_trip(Polyhedral{.formulation = Formulation::coordinates, .tracking = paths});
  check_round_trip(CayleyMenger{.method = DiagonalMethod::univariate});
  check_round_trip(ThetaScan{.method = ThetaScan::Method::published,
                             .dtheta = 0.01,
                             .start = -1.5,
                             .delta = 1e-20,
                             .scan = {.max_cells = 999'999'999'999}});
  check_round_trip(
      SphereTangents{.method = SphereTangents::Method::published, .system = PublishedSystem::cubic});
  check_round_trip(PlanScan{.method = PlanScan::Method::published,
                            .most_angles = 3,
                            .scan = {.max_cells = 1},
                            .step = 0.1,
                            .start = 1.0 / 3,
                            .delta = 1e-20,
                            .max_points = 999'999'999'999});
  check_round_trip(SystemPaths{.system = SystemPaths::System::echelon, .start = PathStart::total_degree});
  check_round_trip(NewtonMultistart{.starts = 64, .unseen = 0});
}

TEST_CASE("of what every strategy has, only reduce is a text") {
  CHECK(options_of(Rcp{.seed = 7, .threads = 4, .certify = true}) == options_of(Rcp{}));
  for (const bool reduce : {true, false}) {
    const Rcp values{.reduce = reduce};
    CHECK(options_of(values).find("reduce")->second == (reduce ? "on" : "off"));
    CHECK(read_options<Rcp>(options_of(values)) == values);
    CHECK_NOTHROW(made(entry_named("rcp"), options_of(values)));
  }
}

TEST_CASE("an entry lists the options of its struct") {
  constexpr Polyhedral defaults{.certify = true};
  static_assert(defaults.tracking.order == 12);
  const StrategyEntry& entry = entry_named(Polyhedral::strategy);
  OptionMap listed = options_of(Polyhedral{.reduce = true});
  CHECK(complete_options(entry, {}) == listed);
  CHECK(entry.options.front().name == "formulation");
  CHECK(entry.options.back().name == "reduce");
}

TEST_CASE("what help says of a number is what is checked") {
  int numbers = 0;
  for (const StrategyEntry& entry : all_strategies())
    for (const OptionSpec& spec : entry.options) {
      const auto range = range_in(spec.allowed);
      if (!range) continue;
      ++numbers;
      const std::string name(spec.name);
      INFO(entry.name << " " << name << ": " << spec.allowed);
      CHECK_NOTHROW(made(entry, {{name, range->low}}));
      CHECK_NOTHROW(made(entry, {{name, range->high}}));
      for (const std::string& text :
           {next_to(range->low, range->is_whole, -1), next_to(range->high, range->is_whole, 1),
            range->low + " ", std::string("nan"), std::string("1e400"), std::string()})
        CHECK_THROWS_WITH(made(entry, {{name, text}}),
                          "option " + name + "=" + text + ": expected " + spec.allowed);
    }
  CHECK(numbers >= 20);
}

TEST_CASE("a choice takes its words alone") {
  check_words<FullSpace>();
  check_words<Rcp>();
  check_words<CayleyMenger>();
  check_words<ThetaScan>();
  check_words<SphereTangents>();
  check_words<PlanScan>();
  check_words<Monodromy>();
  check_words<Polyhedral>();
  check_words<SystemPaths>();
  check_words<NewtonMultistart>();
  CHECK_THROWS_WITH(made(entry_named("rcp"), {{"swap", "yes"}}), "option swap=yes: expected on|off");
  CHECK_THROWS_WITH(made(entry_named("rcp"), {{"reduce", "yes"}}), "option reduce=yes: expected on|off");
}

TEST_CASE("a word may stand for no value") {
  CHECK_FALSE(read_options<FullSpace>({{"step_max", "auto"}}).tracking.step_max);
  CHECK(read_options<FullSpace>({{"step_max", "0.25"}}).tracking.step_max == 0.25);
  CHECK_THROWS_WITH(read_options<FullSpace>({{"step_max", "0"}}),
                    "option step_max=0: expected auto, or a number from 1e-6 to 1e6");
  CHECK_FALSE(read_options<Monodromy>({{"start", "none"}}).start);
  CHECK(read_options<Monodromy>({{"start", "auto"}}).start == "auto");
  CHECK_THROWS_WITH(read_options<Monodromy>({{"start", ""}}), "option start=: expected FILE, or none");
}

TEST_CASE("values of a struct are checked as texts are") {
  const auto refusal = [](const auto& values) {
    const StrategyEntry& entry = entry_named(values.strategy);
    try {
      made(entry, options_of(values));
    } catch (const OptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal(Monodromy{.arcs = 1}) == "option arcs=1: expected a whole number from 2 to 1000");
  CHECK(refusal(Rcp{.alpha = std::nan("")}) == "option alpha=nan: expected a number from 1e-6 to 0.49");
  CHECK(refusal(SphereTangents{.method = static_cast<SphereTangents::Method>(3)}) ==
        "option method=: expected direct|homotopy|published");
  CHECK(refusal(Monodromy{.save_start = ""}) == "option save_start=: expected FILE, or none");
  CHECK(refusal(Monodromy{.start = "a", .save_start = "b"}) != "");
  CHECK(refusal(Monodromy{.arcs = 2}) == "");
}

TEST_CASE("the text of a number is its shortest decimal") {
  CHECK(Range<double>::text(1e-7) == "1e-7");
  CHECK(Range<double>::text(1e6) == "1e6");
  CHECK(Range<double>::text(-1.5e-300) == "-1.5e-300");
  CHECK(Range<double>::text(1e300) == "1e300");
  CHECK(Range<double>::text(0.001) == "0.001");
  CHECK(Range<double>::text(0.1 + 0.2) == "0.30000000000000004");
  CHECK(Range<std::int64_t>::text(1'000'000'000'000) == "1000000000000");
}
