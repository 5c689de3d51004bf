#include "harness/results/reference_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "harness/base/shipped_data.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/families.hpp"
#include "harness/results/file_formats.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/certificates/figure_distance.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/text_input.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {
namespace {

/// Of a list that is made now.
constexpr int digits = 40;

KnownSolution known(const Scene& scene, DecimalFigure exact) {
  Figure figure = scene.in_scene_unit(figure_of(exact));
  return {std::move(exact), std::move(figure)};
}

// ---- the shipped lists

std::string decimal_text(const JsonCursor& cursor) {
  std::string text = cursor.text();
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0')
    cursor.fail("'" + text + "' is no number", "give a decimal number as a text");
  return text;
}

KnownSolution read_known_solution(const JsonCursor& cursor, const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const bool is_real = cursor.required("real").boolean();
  const auto read_vector = [&](const JsonCursor& vector, int dimension) {
    return read_coordinates<DecimalNumber>(vector, dimension, is_real, decimal_text);
  };
  DecimalFigure exact;
  for (const std::string& name : problem.points)
    exact.points.push_back(read_vector(cursor.required("points").required(name), problem.dimension));
  for (const std::string& name : problem.lines) {
    const JsonCursor line = cursor.required("lines").required(name);
    exact.lines.push_back(
        {read_vector(line.required("point"), 3), read_vector(line.required("direction"), 3)});
  }
  for (const std::string& name : problem.planes) {
    const JsonCursor plane = cursor.required("planes").required(name), offset = plane.required("offset");
    exact.planes.push_back(
        {read_vector(plane.required("normal"), 3),
         is_real ? DecimalNumber{decimal_text(offset)} : read_complex<DecimalNumber>(offset, decimal_text)});
  }
  exact.error = cursor.required("error_bound").number().value;
  return known(scene, std::move(exact));
}

ReferenceList read_list(const JsonCursor& root, const Scene& scene, const std::string& file) {
  ReferenceList list;
  const JsonCursor origin = root.required("origin");
  const std::string claim = origin.required("claim").text();
  list.source = file;
  list.has_all_complex = claim == word(Claim::all_complex) && !origin.required("only_real").boolean();
  list.has_all_real = claim == word(Claim::all_complex) || claim == word(Claim::all_real);
  list.is_real_proven = claim == word(Claim::all_real) ||
                        (list.has_all_real && root.required("proofs").required("complete").boolean());
  for (const JsonCursor& solution : root.required("solutions").elements())
    list.solutions.push_back(read_known_solution(solution, scene));
  return list;
}

// ---- lists made now

class ListMaker {
 public:
  explicit ListMaker(const Scene& scene)
      : scene_(scene),
        equations_(scene),
        images_(mirror_images(scene)),
        size_(std::ldexp(scene.size(), scene.unit_exponent())) {}

  /// Every solution that is proven next to one that the run lists.
  void take(const SolveRun& run) {
    for (const AssessedSolution& solution : run.solutions) {
      take_next_to(solution.figure);
      if ((solution.multiplicity > 1 || solution.condition > ill_conditioned) &&
          !is_surrounded(solution.figure))
        take_around(solution.figure);
    }
    const bool is_complete = run.status == RunStatus::complete && run.failed_checks.empty();
    // A multiple solution is not in the list: decimals do not prove it.
    const bool are_simple = std::ranges::all_of(
        run.solutions, [](const AssessedSolution& solution) { return solution.multiplicity == 1; });
    list_.has_all_real = list_.has_all_real || (is_complete && are_simple && run.claim == Claim::all_real);
    if (run.proofs && run.proofs->are_complete() && run.proofs->clusters == 0)
      all_ = Natural(run.proofs->classes);
  }

  /// There are no more solutions than are proven.
  bool has_all(const std::optional<Natural>& limit) const {
    const Natural count(list_.solutions.size());
    return limit == count || all_ == count;
  }

  ReferenceList finish(const std::optional<Natural>& limit) {
    list_.has_all_complex = has_all(limit);
    list_.is_real_proven = list_.has_all_real = list_.has_all_real || list_.has_all_complex;
    list_.source = "proven in this run";
    return std::move(list_);
  }

 private:
  /// Solutions of smaller condition numbers have none next to them that doubles do not tell apart.
  static constexpr double ill_conditioned = 1e4;

  void take_next_to(const Figure& figure) {
    auto exact = decimal_figure(equations_, scene_, figure, digits);
    if (!exact) return;
    KnownSolution found = known(scene_, std::move(*exact));
    if (is_new(found)) list_.solutions.push_back(std::move(found));
  }

  /// As far as doubles tell, another strategy has listed it.
  bool is_surrounded(const Figure& figure) const {
    return std::any_of(surrounded_.begin(), surrounded_.end(), [&](const Figure& other) {
      return least_distance(figure, other, images_, scene_.size()) <= 1e-12 * extent(figure);
    });
  }

  /// Newton's method from all sides, at all distances that doubles know.
  void take_around(const Figure& middle) {
    surrounded_.push_back(middle);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (double distance = 1e-2; distance > 1e-16; distance *= 0.1)
      for (const bool is_complex : {false, true}) {
        Figure start = is_complex && middle.is_real() ? with_imaginary_parts(middle) : middle;
        const auto shift = [&](auto& numbers) {
          for (double& number : numbers.reshaped()) number += distance * scene_.size() * uniform(random);
        };
        shift(start.points);
        if (start.imaginary.cols() > 0) shift(start.imaginary);
        for (auto* lines : {&start.lines, &start.imaginary_lines})
          for (LinePosition& line : *lines) {
            shift(line.point);
            shift(line.direction);
          }
        for (auto* planes : {&start.planes, &start.imaginary_planes})
          for (PlanePosition& plane : *planes) {
            shift(plane.normal);
            plane.offset += distance * scene_.size() * uniform(random);
          }
        take_next_to(start);
      }
  }

  static Figure with_imaginary_parts(Figure figure) {
    figure.imaginary = Eigen::Matrix3Xd::Zero(3, figure.points.cols());
    figure.imaginary_lines.assign(figure.lines.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
    figure.imaginary_planes.assign(figure.planes.size(), {Eigen::Vector3d::Zero(), 0});
    return figure;
  }

  /// Further from every other one, mirror images included, than their errors together.
  bool is_new(const KnownSolution& found) const {
    const double far = 1e-6 * scene_.size();
    return std::all_of(list_.solutions.begin(), list_.solutions.end(), [&](const KnownSolution& other) {
      return std::all_of(images_.begin(), images_.end(), [&](const AxisSigns& signs) {
        if (largest_distance(found.figure, other.figure, signs, scene_.size()) > far) return true;
        const double errors = 4 * (found.exact.error + other.exact.error) * std::max(1.0, size_);
        return largest_distance(found.exact, other.exact, signs, size_) > errors;
      });
    });
  }

  const Scene& scene_;
  SceneEquations equations_;
  std::vector<AxisSigns> images_;
  double size_;  ///< of the scene, in the file's unit
  std::vector<Figure> surrounded_;
  /// So many there are, by what a run has proven, at infinity too.
  std::optional<Natural> all_;
  ReferenceList list_;
};

/// At most so many solutions: by the theory of a family, or the theoretical count.
std::optional<Natural> most_solutions(const Instance& instance) {
  if (const auto known = solutions_by_theory(instance.id)) return Natural(*known);
  const TheoreticalCounts counts = theoretical_counts(instance.problem);
  const SolutionCount* limit = counts.upper_limit();
  return limit == nullptr ? std::nullopt : std::optional(limit->up_to_reflection());
}

ReferenceList list_found_now(const Instance& instance, const Scene& scene, double limit_s,
                             Monitor& progress) {
  ListMaker maker(scene);
  RunLimits limits;
  limits.time_limit_s = limit_s;
  const std::optional<Natural> most = most_solutions(instance);
  // Homotopies first: they know when nothing is missing, proven with their ends at infinity, or that there is no end of it.
  const auto is_homotopy = [](const StrategyEntry* entry) {
    return entry->name == "monodromy" || entry->name == "polyhedral";
  };
  std::vector<const StrategyEntry*> order;
  for (const StrategyEntry& entry : all_strategies()) order.push_back(&entry);
  std::stable_partition(order.begin(), order.end(), is_homotopy);
  for (const StrategyEntry* entry : order) {
    if (interrupted() || maker.has_all(most)) break;
    progress.progress("reference, " + std::string(entry->name), -1);
    limits.certify = is_homotopy(entry);
    const SolveRun run = run_strategy(*entry, {}, scene, limits);
    maker.take(run);
    if (run.status == RunStatus::infinite) break;  // no list has them all
  }
  return maker.finish(most);
}

/// A crossing is the nearest solution, and no further from it than this of the scene's size.
constexpr double same_place = 1e-6;

/// Empty where S is not proven in time or a crossing is not in the list.
std::optional<std::vector<bool>> known_on_path(const Scene& scene, const ReferenceList& list,
                                               double limit_s) {
  if (is_path_of_elements(scene) || why_not_proven(scene)) return std::nullopt;
  const StopWatch watch(limit_s);
  CertifiedTracker tracker(scene, {}, {watch.token(), nullptr});
  const SolveReport report =
      path_report(scene, tracker.run(), [&](const Eigen::VectorXd& y) { return tracker.figure(y); });
  if (report.status != SolveStatus::complete) return std::nullopt;
  std::vector<bool> on_path(list.solutions.size(), false);
  const std::vector<AxisSigns> images = mirror_images(scene);
  for (const Candidate& candidate : report.candidates) {
    const Figure met = scene.representative(candidate.figure);
    double nearest = same_place * scene.size();
    std::optional<std::size_t> same;
    for (std::size_t i = 0; i < on_path.size(); ++i) {
      const double distance = least_distance(met, list.solutions[i].figure, images, scene.size());
      if (distance >= nearest) continue;
      nearest = distance;
      same = i;
    }
    if (!same) return std::nullopt;
    on_path[*same] = true;
  }
  return on_path;
}

}  // namespace

std::optional<ReferenceList> shipped_reference(const Instance& instance, const Scene& scene) {
  const auto file = shipped_file(std::filesystem::path("results") / "reference" / (instance.id + ".json"));
  if (!file) return std::nullopt;
  const JsonValue document = parse_json(read_file(*file, "run scripts/make-references"), *file);
  const JsonCursor root(document, *file);
  root.require_format(reference_format);
  if (to_text(root.required("instance").value(), -1) != to_text(instance.document, -1)) return std::nullopt;
  return read_list(root, scene, *file);
}

ReferenceList reference_for(const Instance& instance, const Scene& scene, double limit_s, Monitor& progress) {
  const auto shipped = shipped_reference(instance, scene);
  ReferenceList list = shipped ? *shipped : list_found_now(instance, scene, limit_s, progress);
  list.on_path = known_on_path(scene, list, limit_s);
  return list;
}

}  // namespace gcs
