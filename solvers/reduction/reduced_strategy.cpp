#include "solvers/reduction/reduced_strategy.hpp"

#include <algorithm>
#include <utility>

#include "solvers/certificates/proven_error.hpp"
#include "solvers/counting/scene_analysis.hpp"
#include "solvers/elements/element_order.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/homotopies/start_store.hpp"
#include "solvers/interface/options.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/reduction/core_path.hpp"
#include "solvers/reduction/part_reports.hpp"
#include "solvers/reduction/placed_scene.hpp"
#include "solvers/reduction/solution_product.hpp"
#include "solvers/running/words.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {
namespace {

/// As many solutions are listed, where nobody says how many, as have this many coordinates together.
constexpr std::size_t listed_coordinates = 1'000'000;

/// Likewise of combinations of elements that are placed one by one.
constexpr std::size_t most_combinations = 10'000;

/// A part to be solved by a strategy, as a scene of its own.
struct PartScene {
  PartScene(const ProblemStatement& whole, const Part& part) : PartScene(part_problem(whole, part)) {}
  explicit PartScene(PartProblem part)
      : scene(Scene::unchecked(std::move(part.problem))), points(std::move(part.points)) {}

  /// What is asked of the whole scene, asked of this part.
  SolveRequest request(const SolveRequest& of_whole) const { return of_whole.on(scene, &analysis); }

  Scene scene;
  SceneAnalysis analysis{scene.problem()};
  std::vector<int> points;  ///< of each point, its number in the whole scene
};

/// "p1, p2, p3, p4, …"
std::string names(const PartScene& part) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < part.points.size() && i < most; ++i)
    text += (i == 0 ? "" : ", ") + part.scene.problem().points[i];
  return text + (part.points.size() > most ? ", …" : "");
}

std::string about(const PartScene& part, const std::string& reason) {
  return "the part " + names(part) + ": " + reason;
}

/// The figure of a part in the whole scene's unit; points outside the part are at the origin.
Figure in_whole(const Scene& whole, const PartScene& part, const Figure& figure) {
  const Figure scaled = figure.scaled(part.scene.unit_exponent() - whole.unit_exponent());
  Figure result = scaled;
  result.points = Eigen::Matrix3Xd::Zero(3, whole.point_count());
  if (!scaled.is_real()) result.imaginary = result.points;
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    result.points.col(part.points[i]) = scaled.points.col(column);
    if (!scaled.is_real()) result.imaginary.col(part.points[i]) = scaled.imaginary.col(column);
  }
  return result;
}

PartSolution part_solution(const Scene& whole, const PartScene& part_scene, const Part& part,
                           const Figure& representative, const SolutionAccuracy& accuracy, int multiplicity) {
  const Figure placed = in_whole(whole, part_scene, representative);
  const Simplex positions = complex_points(placed);
  PartSolution solution{{},
                        complex_lines(placed),
                        representative.is_real(),
                        is_own_mirror_image(part_scene.scene, representative, accuracy.error),
                        accuracy.condition >= stiff_condition,
                        accuracy.condition,
                        multiplicity};
  std::optional<SimplexFrame> frame;
  if (!part.base.empty()) frame.emplace(columns(positions, part.base));
  for (const int point : part.points)
    solution.points.push_back(frame ? frame->coordinates(positions.col(point)) : positions.col(point).eval());
  return solution;
}

/// One for each class of what was found.
std::vector<PartSolution> part_solutions(const Scene& whole, const PartScene& part_scene, const Part& part,
                                         const SolveReport& report) {
  std::vector<Figure> figures;
  std::vector<SolutionAccuracy> accuracies;
  for (const Candidate& candidate : report.candidates) {
    figures.push_back(part_scene.scene.representative(candidate.figure));
    accuracies.push_back({jacobian_condition(part_scene.scene, figures.back()), candidate.error});
  }
  const ReflectionClasses classes = classes_told_apart(part_scene.scene, figures, accuracies);
  std::vector<PartSolution> solutions;
  for (const int first : classes.first)
    solutions.push_back(part_solution(whole, part_scene, part, figures[first], accuracies[first],
                                      report.candidates[first].multiplicity));
  return solutions;
}

// ---- putting reports together

/// Every part has two sides but for the first.
std::optional<Natural> generic_classes(const std::vector<SolveReport>& reports, std::size_t parts) {
  Natural product = Natural::power_of_two(static_cast<int>(parts) - 1);
  for (const SolveReport& report : reports) {
    if (!report.generic) return std::nullopt;
    product = product * Natural(*report.generic);
  }
  return product;
}

int solved_parts(const std::vector<Part>& parts) {
  return static_cast<int>(
      std::count_if(parts.begin(), parts.end(), [](const Part& part) { return !part.is_hung_point(); }));
}

/// A start system is that of one part, and what names it does not say of which.
class NoStartSystems final : public StartStore {
 public:
  StartSystem read(const std::string& name, const StartFamily&) const override { refuse(name); }
  void reserve(const std::string& name) override { refuse(name); }
  void write(const std::string& name, const StartFamily&, const StartSystem&) override { refuse(name); }

 private:
  [[noreturn]] static void refuse(const std::string& name) {
    throw OptionError(
        "start system " + name +
        ": the scene is solved in several parts, each with one of its own; give reduce=off too");
  }
};

class ReducedStrategy final : public Strategy {
 public:
  ReducedStrategy(const StrategyEntry& inner, const OptionMap& options)
      : split_(inner.needs_sketch ? Split::hung_points : Split::all),
        knows_general_scenes_(inner.knows_general_scenes),
        make_([make = inner.make, options] { return make(options); }),
        make_reduced_([inner, options] { return std::make_unique<ReducedStrategy>(inner, options); }) {
    read_option(options, reduce_option, OnOff{}, reduces_);
    strategies_.push_back(make_());
  }

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    if (request.scene.problem().is_general() && !knows_general_scenes_)
      return "it knows points, lines in space and distances between them alone";
    if (placing_of(request)) return std::nullopt;
    return why_no_parts(request);
  }

  void prepare(const SolveRequest& request) override {
    const std::optional<ElementOrder> order = placing_of(request);
    if (!order) return prepare_parts(request);
    const bool is_only_core = cores_of(*order) == 1;
    std::size_t next = 0;
    for (const PlacingStep& step : order->steps) {
      if (!step.is_core()) continue;
      const Scene core = Scene::unchecked(step.alone->problem);
      const SceneAnalysis analysis(core.problem());
      part(next++).prepare(request_for(request.on(core, &analysis), is_only_core));
    }
  }

  SolveReport solve(const SolveRequest& request) override {
    if (const std::optional<ElementOrder> order = placing_of(request)) return solve_in_order(request, *order);
    return solve_undivided(request);
  }

 private:
  std::vector<Part> parts_of(const SolveRequest& request) const {
    if (!reduces_) return std::vector<Part>(1);
    return request.analysis ? request.analysis->parts(split_) : decompose(request.scene.problem(), split_);
  }

  /// Nothing where the strategy does not know the cores or, without any, what is placed.
  std::optional<ElementOrder> placing_of(const SolveRequest& request) const {
    if (!reduces_ || split_ != Split::all) return std::nullopt;
    std::optional<ElementOrder> order =
        request.analysis ? request.analysis->order() : element_order(request.scene);
    if (order && !knows(request, *order)) return std::nullopt;
    return order;
  }

  static std::ptrdiff_t cores_of(const ElementOrder& order) {
    return std::ranges::count_if(order.steps, [](const PlacingStep& step) { return step.is_core(); });
  }

  /// Without a core it has to know all steps as scenes of their own, unless it knows the equations of general scenes.
  bool knows(const SolveRequest& request, const ElementOrder& order) const {
    const bool is_ready =
        cores_of(order) > 0 || (knows_general_scenes_ && request.scene.problem().is_general());
    return std::ranges::all_of(order.steps, [&](const PlacingStep& step) {
      return step.is_core() || !is_ready ? step.alone && knows_part(request, step.alone->problem) : true;
    });
  }

  bool knows_part(const SolveRequest& request, const ProblemStatement& part) const {
    const Scene scene = Scene::unchecked(part);
    const SceneAnalysis analysis(scene.problem());
    return !make_reduced_()->why_unsupported(request.on(scene, &analysis));
  }

  std::optional<std::string> why_no_parts(const SolveRequest& request) const {
    const std::vector<Part> parts = parts_of(request);
    if (parts.size() == 1) return strategies_.front()->why_unsupported(request);
    for (const Part& part : parts) {
      if (part.is_hung_point()) continue;
      const PartScene part_scene(request.scene.problem(), part);
      if (const auto reason = strategies_.front()->why_unsupported(part_scene.request(request)))
        return about(part_scene, *reason);
    }
    return std::nullopt;
  }

  void prepare_parts(const SolveRequest& request) {
    const std::vector<Part> parts = parts_of(request);
    if (parts.size() == 1) return strategy(0).prepare(request);
    std::size_t next = 0;
    for (const Part& part : parts) {
      if (part.is_hung_point()) continue;
      const PartScene part_scene(request.scene.problem(), part);
      strategy(next++).prepare(request_for(request, parts, part_scene));
    }
  }

  SolveReport solve_undivided(const SolveRequest& request) {
    const std::vector<Part> parts = parts_of(request);
    if (parts.size() == 1) return strategy(0).solve(request);
    if (split_ == Split::hung_points) return solve_on_path(request, parts);
    SolveReport report = solve_parts(request, parts);
    return is_open(request.scene, report) ? in_one_piece(request, std::move(report)) : report;
  }

  /// Where points coincide, or a base is collinear, parts do not say whether the whole moves, and where a point is flat, not
  /// where it is. So small scenes take no second in one piece.
  static bool is_open(const Scene& scene, const SolveReport& report) {
    constexpr int most_points = 12;
    const bool is_unsettled = report.status == SolveStatus::partial || report.status == SolveStatus::infinite;
    return is_unsettled && report.claim == Claim::all_complex && scene.point_count() <= most_points;
  }

  /// The answer in one piece where that has motions, or is complete without ends at infinity, from which ends that are far
  /// away, as where points next to each other carry another, are not told; otherwise that of the parts.
  SolveReport in_one_piece(const SolveRequest& request, SolveReport parts) {
    if (strategies_.front()->why_unsupported(request)) return parts;
    SolveRequest alone = request;
    alone.starts = &no_starts_;
    SolveReport whole = make_()->solve(alone);
    const bool is_finite = std::ranges::none_of(
        whole.paths, [](const PathRecord& path) { return path.end == PathRecord::End::at_infinity; });
    const bool is_settled = !whole.motions.empty() || (whole.status == SolveStatus::complete && is_finite);
    return is_settled ? whole : parts;
  }

  /// Each part by a strategy of its own, which takes it apart further where it can.
  SolveReport solve_in_order(const SolveRequest& request, const ElementOrder& order) {
    const bool is_only_core = cores_of(order) == 1;
    std::size_t next = 0;
    const auto solve = [&](const PlacingStep& step,
                           const SolveRequest& of_part) -> std::optional<SolveReport> {
      if (!step.is_core() && !knows_part(of_part, of_part.scene.problem())) return std::nullopt;
      return part(next++).solve(request_for(of_part, is_only_core));
    };
    if (auto report = solve_placed(request, order, solve, request.most_listed.value_or(most_combinations)))
      return std::move(*report);
    return solve_whole(request);
  }

  ReducedStrategy& part(std::size_t number) {
    while (parts_.size() <= number) parts_.push_back(make_reduced_());
    return *parts_[number];
  }

  /// A start system is that of the only core.
  SolveRequest request_for(SolveRequest of_part, bool is_only_core) {
    if (!is_only_core) of_part.starts = &no_starts_;
    return of_part;
  }

  /// In one piece, where it cannot be taken apart.
  SolveReport solve_whole(const SolveRequest& request) {
    SolveReport report;
    if (const auto reason = strategies_.front()->why_unsupported(request))
      report.reason = "a step has no way at random numbers, and in one piece: " + *reason;
    else
      report = make_()->solve(request);
    return report;
  }

  Strategy& strategy(std::size_t number) {
    while (strategies_.size() <= number) strategies_.push_back(make_());
    return *strategies_[number];
  }

  SolveRequest request_for(const SolveRequest& request, const std::vector<Part>& parts,
                           const PartScene& part) {
    SolveRequest of_part = part.request(request);
    if (solved_parts(parts) > 1) of_part.starts = &no_starts_;
    return of_part;
  }

  SolveReport solve_on_path(const SolveRequest& request, const std::vector<Part>& parts) {
    const PartScene core(request.scene.problem(), parts.front());
    SolveReport report = strategy(0).solve(request_for(request, parts, core));
    for (Candidate& candidate : report.candidates)
      candidate = {in_whole(request.scene, core, candidate.figure), candidate.multiplicity, candidate.error};
    return with_hung_points(request.scene, parts, std::move(report));
  }

  SolveReport solve_parts(const SolveRequest& request, const std::vector<Part>& parts) {
    std::vector<SolveReport> reports;
    std::vector<std::vector<PartSolution>> solved;
    SolveReport whole;
    bool is_empty = false;
    for (const Part& part : parts) {
      solved.emplace_back();
      if (part.is_hung_point()) continue;
      const PartScene part_scene(request.scene.problem(), part);
      reports.push_back(strategy(reports.size()).solve(request_for(request, parts, part_scene)));
      const SolveReport& report = reports.back();
      solved.back() = part_solutions(request.scene, part_scene, part, report);
      is_empty = is_empty || (report.status == SolveStatus::complete && claims_all(report.claim) &&
                              report.candidates.empty());
      if (!report.reason.empty())
        whole.reason += (whole.reason.empty() ? "" : "; ") + about(part_scene, report.reason);
      whole.paths.insert(whole.paths.end(), report.paths.begin(), report.paths.end());
      add(report.work, whole.work);
      add(report.particulars, whole.particulars);
    }
    whole.status = common_status(reports, is_empty);
    if (whole.status == SolveStatus::complete) whole.reason.clear();
    whole.claim = common_claim(reports);
    SolutionProduct product(request.scene, parts, std::move(solved));
    multiply(request, product, whole);
    whole.totals->generic = generic_classes(reports, parts.size());
    return whole;
  }

  /// How many are so far away that doubles lose their distances, and not proven.
  static std::size_t prove_far_ones(const SolveRequest& request, std::vector<Candidate>& candidates) {
    std::vector<Candidate*> far;
    std::vector<const Figure*> figures;
    for (Candidate& candidate : candidates) {
      if (!loses_distances(request.scene, candidate.figure)) continue;
      far.push_back(&candidate);
      figures.push_back(&candidate.figure);
    }
    auto proven = proven_next_to(request.scene, figures, request);
    for (std::size_t i = 0; i < far.size(); ++i)
      if (proven[i]) *far[i] = *std::move(proven[i]);
    return static_cast<std::size_t>(std::ranges::count_if(proven, [](const auto& one) { return !one; }));
  }

  /// Counts, and lists as many as asked for.
  static void multiply(const SolveRequest& request, SolutionProduct& product, SolveReport& whole) {
    const bool only_real = whole.claim != Claim::all_complex;
    const std::size_t coordinates = static_cast<std::size_t>(request.scene.dimension()) *
                                    static_cast<std::size_t>(request.scene.point_count());
    const std::size_t limit =
        request.most_listed.value_or(std::max<std::size_t>(1, listed_coordinates / coordinates));
    SolutionTotals& totals = whole.totals.emplace();
    totals.real = product.count(true);
    if (!only_real) totals.complex = product.count(false);
    if (totals.real != Natural(0)) whole.candidates = product.list(true, limit);
    if (!only_real && (!totals.real || totals.complex != totals.real) && whole.candidates.size() < limit)
      for (Candidate& candidate : product.list(false, limit - whole.candidates.size()))
        whole.candidates.push_back(std::move(candidate));
    if (!claims_all(whole.claim)) totals.real.reset();  // it is the number of those that were found
    std::vector<std::string> undecided = product.undecided();
    const std::size_t lost = prove_far_ones(request, whole.candidates);
    if (lost > 0)
      undecided.push_back("the coordinates of " + counted(lost, "solution") + " are " +
                          too_large_for_doubles());
    for (const std::string& sentence : undecided)
      whole.reason += (whole.reason.empty() ? "" : "; ") + sentence;
    if (!undecided.empty() && whole.status == SolveStatus::complete) whole.status = SolveStatus::partial;
  }

  Split split_;  ///< what follows S from the sketch leaves rigid parts together
  bool knows_general_scenes_;
  bool reduces_ = false;
  std::function<std::unique_ptr<Strategy>()> make_;
  std::function<std::unique_ptr<ReducedStrategy>()> make_reduced_;
  NoStartSystems no_starts_;
  std::vector<std::unique_ptr<Strategy>> strategies_;      ///< one for each part of points that is solved
  std::vector<std::unique_ptr<ReducedStrategy>> parts_{};  ///< one for each part of other scenes
};

}  // namespace

StrategyEntry with_reduction(StrategyEntry inner) {
  StrategyEntry entry = inner;
  entry.options.push_back({reduce_option, OnOff::text(!inner.needs_sketch), OnOff::allowed(),
                           "place what hangs on the rest after it, and solve apart what d points separate"});
  entry.make = [inner = std::move(inner)](const OptionMap& options) -> std::unique_ptr<Strategy> {
    return std::make_unique<ReducedStrategy>(inner, options);
  };
  return entry;
}

}  // namespace gcs
