#include "solvers/homotopies/complex_strategy.hpp"

#include <limits>
#include <utility>

#include "solvers/certificates/proven_error.hpp"
#include "solvers/counting/scene_analysis.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/homotopies/complex_report.hpp"
#include "solvers/homotopies/conjugate_ends.hpp"
#include "solvers/homotopies/precise_ends.hpp"
#include "solvers/homotopies/restated_scene.hpp"

namespace gcs {
namespace {

InstructionSet instruction_set(HomotopySettings::Instructions instructions) {
  if (instructions == HomotopySettings::Instructions::automatic) return widest_instruction_set();
  const auto set = static_cast<InstructionSet>(static_cast<int>(instructions) - 1);
  if (!is_available(set))
    throw OptionError("option instructions=" + HomotopySettings::instruction_sets.text(instructions) +
                      ": this machine does not have them; auto takes the widest that it has");
  return set;
}

TrackingSetup tracking_setup(const HomotopySettings& settings) {
  TrackingSetup setup;
  setup.options.order = settings.order;
  setup.options.tolerance = settings.tolerance;
  setup.all_wide = settings.precision == HomotopySettings::Precision::twice;
  setup.set = instruction_set(settings.instructions);
  return setup;
}

/// The squared lengths that the file gives.
ComplexVectorX given_squares(const Scene& scene) {
  ComplexVectorX squares;
  for (const DoubleDouble& square : target_squares(scene)) squares.push_back(square.value());
  return squares;
}

void add_start(const GenericStart& start, SolveReport& report) {
  report.particulars = start.particulars();
  const std::string missing = start.missing();
  if (missing.empty()) {
    report.generic = start.solutions().size();
    report.generic_member = GenericMember{start.squares(), start.solutions()};
    return;
  }
  report.reason = missing + (report.reason.empty() ? "" : "; " + report.reason);
  if (report.status != SolveStatus::stopped && report.status != SolveStatus::infinite)
    report.status = start.is_stopped() ? SolveStatus::stopped : SolveStatus::partial;
}

/// With two mirror images for each doubling. Where given points are in special places there may be fewer. `are_pairs`: asked
/// where there may be fewer classes than figures, whether each class is two figures.
std::optional<ClassCount> most_classes(const Scene& scene, const TheoreticalCounts& counts, int doublings,
                                       const std::function<bool()>& are_pairs) {
  const SolutionCount* limit = counts.upper_limit();
  if (!limit) return std::nullopt;
  Natural classes = limit->up_to_reflection() * Natural::power_of_two(doublings);
  if (counts.bound && counts.bound->figures && are_pairs())
    classes = std::min(classes, *counts.bound->figures / 2U);
  if (classes > Natural(std::numeric_limits<std::uint32_t>::max())) return std::nullopt;
  return ClassCount{static_cast<std::uint64_t>(classes.approximate()), counts.exact && !scene.is_anchored()};
}

/// Wherever given points are, the scene of the request has no more isolated solutions than its limit.
ClassLimit limit_of(
    const SolveRequest& request, int doublings = 0,
    const std::function<bool()>& are_pairs = [] { return false; }) {
  return [&request, doublings, are_pairs] {
    const Scene& scene = request.scene;
    return request.analysis ? most_classes(scene, request.analysis->counts(), doublings, are_pairs)
                            : most_classes(scene, theoretical_counts(scene.problem()), doublings, are_pairs);
  };
}

/// Whether a member at random differs from all its images by changes of signs, as all that can be reached from it do then.
bool differs_from_images(const GeneralStart& start) {
  constexpr double nothing = 1e-8;  // of the largest number; of random ones none is so small by chance
  std::mt19937_64 random = start.random;
  const ComplexVectorX x = start.family.random_member(random).x;
  double size = 0;
  for (const std::complex<double>& number : x) size = std::max(size, std::abs(number));
  std::vector<SignMask> changed;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(x[i]) > nothing * size) changed.push_back(start.family.signs[i]);
  return SignMasks(std::move(changed)).rank() == start.family.signs.rank();
}

/// Whether a solution that is not real is proven next to x, where doubles cannot tell the Jacobian's rank.
bool is_proven_complex(const SolveRequest& request, const DistanceSystem& coordinates,
                       const ComplexVectorX& x) {
  const Figure figure =
      complex_figure(coordinates, Eigen::Map<const Eigen::VectorXcd>(x.data(), coordinates.unknowns()));
  return proven_next_to(request.scene, {&figure}, request).front().has_value();
}

bool is_released(const Scene& scene) { return scene.has_lines() && scene.is_anchored(); }

/// Whether the scene is solved by the equations of all kinds of elements, and not by those of squared lengths.
bool takes_general_road(const Scene& scene) {
  return has_element_equations(scene.problem()) || scene.problem().lines.size() > 1;
}

}  // namespace

std::vector<OptionMap> tracking_accuracy_settings() {
  return {{{"tolerance", "1e-4"}},
          {{"tolerance", "1e-8"}},
          {{"tolerance", "1e-10"}},
          {{"order", "8"}},
          {{"order", "20"}}};
}

GenericStart::GenericStart(const Scene& scene, std::uint64_t seed, const TrackingSetup& setup)
    : random(seed),
      coordinates(scene),
      system(square_system(coordinates)),
      elimination(order_elimination(system, random)),
      tracking(system, elimination, setup) {}

ComplexStrategy::ComplexStrategy(const HomotopySettings& settings)
    : setup_(tracking_setup(settings)),
      follows_mirror_images_(settings.mirror_images == HomotopySettings::MirrorImages::followed) {}

std::optional<std::string> ComplexStrategy::why_unsupported(const SolveRequest& request) const {
  const Scene& scene = request.scene;
  if (takes_general_road(scene)) {
    if (auto reason = why_no_general_scenes()) return reason;
    return why_not_general(scene);
  }
  if (is_released(scene)) return why_not_restated(scene);
  if (scene.has_lines() && scene.reference().line < 0)
    return "it puts the line on the x-axis, which a reference of points does not allow";
  return std::nullopt;
}

void ComplexStrategy::prepare(const SolveRequest& request) {
  if (takes_general_road(request.scene)) {
    prepared_general_ = general_start(request, GivenScene(request.scene).equations);
    return;
  }
  if (!is_released(request.scene)) {
    prepared_ = solve_at_random_lengths(request, limit_of(request));
    return;
  }
  const RestatedScene restated(request.scene);
  const ReleasedScene& released = restated.released();
  prepared_ = solve_at_random_lengths(request.on(released.scene()), limit_of(request, released.doublings()));
}

std::unique_ptr<GeneralStart> ComplexStrategy::general_start(const SolveRequest& request,
                                                             const GeneralEquations& equations) const {
  auto start = std::make_unique<GeneralStart>(equations, request.seed, setup_for(request));
  solve_random_member(request, limit_of(request, 0, [&start] { return differs_from_images(*start); }),
                      *start);
  return start;
}

SolveReport ComplexStrategy::solve_general(const SolveRequest& request) const {
  const GivenScene given(request.scene);
  const bool is_prepared = prepared_general_ && prepared_general_->serves(given);
  const std::unique_ptr<GeneralStart> fresh = is_prepared ? nullptr : general_start(request, given.equations);
  GeneralStart& start = fresh ? *fresh : *prepared_general_;
  return start.carried_to_values(request, given, [&](double fraction) {
    report_progress(request, "paths to the given values", fraction);
  });
}

SolveReport ComplexStrategy::solve(const SolveRequest& request) {
  if (takes_general_road(request.scene)) return solve_general(request);
  if (!is_released(request.scene)) return solve_free(request, limit_of(request));
  const RestatedScene restated(request.scene);
  const ReleasedScene& released = restated.released();
  return restated.carried_back(
      request, solve_free(request.on(released.scene()), limit_of(request, released.doublings())));
}

SolveReport ComplexStrategy::solve_free(const SolveRequest& request, const ClassLimit& limit) const {
  const std::unique_ptr<GenericStart> fresh =
      is_prepared_for(request.scene) ? nullptr : solve_at_random_lengths(request, limit);
  GenericStart& start = fresh ? *fresh : *prepared_;
  const auto stopped = [&] { return request.stop.stop_requested(); };
  const auto progress = [&](double fraction) {
    report_progress(request, "paths to the given lengths", fraction);
  };
  WorkCounters work = start.work;
  const ComplexVectorX squares = given_squares(request.scene);
  const auto is_zero = [&](const ComplexVectorX& x) { return is_zero_at(start.system, squares, x); };
  std::vector<PathEnd> ends = follow_to_end(start.tracking, start.solutions(), start.squares(), squares,
                                            is_zero, stopped, progress, work);
  settle(start.system, squares, request.threads, ends);
  if (has_precise_ends(request.scene))
    continue_ends(request.scene, start.squares(), squares, request.threads, ends, request.stop);
  std::mt19937_64 random(request.seed);
  const auto make_report = [&] {
    const auto is_isolated = [&](const ComplexVectorX& x) {
      return keeps_rank(jacobian_at(start.system, x)) || is_proven_complex(request, start.coordinates, x);
    };
    std::vector<LostPath> lost =
        end_at_conjugates(is_isolated, mirror_axes(request.scene, start.coordinates), random, ends);
    SolveReport made = complex_report(request.scene, start.coordinates, ends, work, random, request);
    restore(std::move(lost), ends);
    return made;
  };
  const auto before = [&](const std::vector<std::size_t>& numbers, double sigma) {
    std::vector<ComplexVectorX> starts;
    for (const std::size_t i : numbers) starts.push_back(start.solutions()[i]);
    return follow_to_radius(start.tracking, std::move(starts), start.squares(), squares, sigma, stopped,
                            work);
  };
  SolveReport report = make_report();
  if (report.status == SolveStatus::partial && has_precise_ends(request.scene) &&
      determine_ends(request.scene, start.squares(), squares, before, request.threads, ends, request.stop))
    report = make_report();
  conclude_stopped(request.stop, report);
  ends = std::vector<PathEnd>();  // they may be as large as the start, which the report may need again
  add_start(start, report);
  return report;
}

/// What was prepared serves the same equations: which ones a restated scene has depends on the positions.
bool ComplexStrategy::is_prepared_for(const Scene& scene) const {
  return prepared_ && prepared_->coordinates.edges() == DistanceSystem(scene).edges();
}

TrackingSetup ComplexStrategy::setup_for(const SolveRequest& request) const {
  TrackingSetup setup = setup_;
  setup.threads = request.threads;
  setup.journal = request.journal;
  setup.crew = request.crew;
  return setup;
}

void ComplexStrategy::report_progress(const SolveRequest& request, std::string_view stage, double fraction) {
  const bool stopped = request.stop.stop_requested();  // what still comes then is not on its way
  if (request.monitor && !stopped) request.monitor->progress(stage, fraction);
}

}  // namespace gcs
