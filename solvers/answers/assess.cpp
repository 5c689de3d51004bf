#include "solvers/answers/assess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {

namespace {

/// Two different solutions closer together than the coarsest merging tolerance lie on both sides of a fold,
/// where the condition number is at least of the order of one over their distance. Below this one they are
/// one.
constexpr double fold_condition = 1e6;

/// The most that a coordinate of a point differs by, and of a line's direction or a plane's normal, whichever way it
/// goes, times `size`.
double figure_distance(const Figure& a, const Figure& b, double size) {
  double largest = (a.points - b.points).lpNorm<Eigen::Infinity>();
  const auto take = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    largest = std::max(largest, size * std::min((one - other).norm(), (one + other).norm()));
  };
  for (std::size_t i = 0; i < a.lines.size(); ++i) take(a.lines[i].direction, b.lines[i].direction);
  for (std::size_t i = 0; i < a.planes.size(); ++i) take(a.planes[i].normal, b.planes[i].normal);
  return largest;
}

/// The scene's size, if that is shorter.
double shortest_length(const Scene& scene) {
  double shortest = scene.size();
  for (const double length : scene.target_lengths()) shortest = std::min(shortest, length);
  return shortest;
}

/// What a figure in double precision can reach: every coordinate is rounded to u·extent, so a distance is off
/// by up to 2·√3·u·extent, divided by the shortest length as relative_residual does. A hundred such roundings
/// are allowed; a corrector that stopped early leaves far more. Between complex points a short distance may
/// be the difference of large squares: its error is larger by the extent over the length once more.
double residual_limit(const Scene& scene, double shortest, const Figure& representative) {
  const double reach = std::max(scene.size(), extent(representative));
  const double stretch = reach / std::max(shortest, 1e-3 * scene.size());
  return 100 * 2 * std::sqrt(3.0) * unit_roundoff * stretch * (representative.is_real() ? 1 : stretch);
}

class Assessor {
 public:
  Assessor(const Scene& scene, SolveReport report, int threads)
      : scene_(scene), report_(std::move(report)), threads_(threads) {}

  Assessment run(const ErrorsOf& errors_of) {
    judge_candidates();
    ListedSolutions listed = list_solutions(scene_, judge_, judged_, errors_of, threads_);
    assessment_.solutions = std::move(listed.solutions);
    solution_of_ = std::move(listed.solution_of);
    check_residuals();
    for (const PathRecord& path : report_.paths) take_crossings(path);
    for (const CurveRecord& curve : report_.curves) take_curve(curve);
    if (report_.claim == Claim::on_path) check_all_met();
    for (const Motion& motion : report_.motions) assessment_.motions.push_back(in_file_unit(motion));
    count();
    return std::move(assessment_);
  }

 private:
  void fail(std::string name, std::string what) {
    assessment_.failed_checks.push_back({std::move(name), std::move(what)});
  }

  /// Whether it matters which image of a class a candidate is.
  bool has_crossings() const {
    return std::ranges::any_of(report_.paths, [](const PathRecord& path) { return !path.crossings.empty(); });
  }

  void judge_candidates() {
    const bool takes_figures = !has_crossings();
    std::vector<std::optional<Judged>> judged =
        judged_candidates(scene_, judge_, report_.candidates, takes_figures, threads_);
    if (takes_figures) report_.candidates = std::vector<Candidate>();
    judged_.reserve(judged.size());
    for (std::size_t i = 0; i < judged.size(); ++i) {
      judged_index_.push_back(judged[i] ? static_cast<int>(judged_.size()) : -1);
      if (judged[i])
        judged_.push_back(*std::move(judged[i]));
      else
        fail("malformed",
             fmt::format("candidate {} lacks an entity, is not finite or has no multiplicity", i));
    }
  }

  void check_residuals() {
    const double shortest = shortest_length(scene_);
    for (std::size_t i = 0; i < assessment_.solutions.size(); ++i) {
      const AssessedSolution& solution = assessment_.solutions[i];
      const double limit = residual_limit(scene_, shortest, solution.figure);
      if (solution.residual <= limit) continue;
      fail("residual",
           fmt::format("solution {} has a residual of {:.2g}, above {:.2g}", i, solution.residual, limit));
    }
  }

  Motion in_file_unit(Motion motion) const {
    motion.figure = scene_.in_file_unit(motion.figure);
    for (Figure& figure : motion.curve.figures) figure = scene_.in_file_unit(figure);
    return motion;
  }

  int judged_candidate(const Crossing& crossing) const {
    const bool known = crossing.candidate >= 0 && crossing.candidate < static_cast<int>(judged_index_.size());
    return known && std::abs(crossing.direction) == 1 ? judged_index_[crossing.candidate] : -1;
  }

  /// Judged candidates and directions.
  std::vector<std::pair<int, int>> well_formed_crossings(const PathRecord& path) {
    std::vector<std::pair<int, int>> taken;
    for (const Crossing& crossing : path.crossings) {
      const int judged = judged_candidate(crossing);
      if (judged < 0)
        fail("malformed", fmt::format("a crossing names candidate {} with direction {}", crossing.candidate,
                                      crossing.direction));
      else
        taken.emplace_back(judged, crossing.direction);
    }
    return taken;
  }

  /// Its crossings name classes, whose mirror images may be met too.
  void take_curve(const CurveRecord& curve) {
    const std::vector<std::pair<int, int>> taken = well_formed_crossings(curve.path);
    AssessedCurve assessed{curve.released, curve.path.end, curve.path.cause, curve.path.proven};
    for (const auto& [judged, direction] : taken)
      assessed.crossings.push_back({solution_of_[judged], direction});
    if (taken.size() == curve.places.size()) assessed.places = curve.places;
    for (const Figure& figure : curve.figures) assessed.figures.push_back(scene_.in_file_unit(figure));
    assessment_.curves.push_back(std::move(assessed));
    if (report_.status == SolveStatus::complete) check_alternation(curve.path, taken);
  }

  /// Takes one path's crossings into the list and checks them as a whole.
  void take_crossings(const PathRecord& path) {
    const std::vector<std::pair<int, int>> taken = well_formed_crossings(path);
    for (const auto& [judged, direction] : taken) {
      assessment_.crossings.push_back({solution_of_[judged], direction});
      met_.insert(judged);
    }
    if (report_.claim == Claim::on_path) check_alternation(path, taken);
    check_repetition(taken);
  }

  /// Between two upward crossings of t = 1 a continuous path must come down, and a closed one meets it
  /// evenly. On a core's path some crossings may be no solutions of the whole scene.
  void check_alternation(const PathRecord& path, const std::vector<std::pair<int, int>>& taken) {
    const bool closed = path.end == PathRecord::End::closed;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (i + 1 == taken.size() && !closed) break;
      if (taken[i].second != taken[(i + 1) % taken.size()].second) continue;
      fail("alternation",
           fmt::format("crossings {} and {} of a path have the same direction: the path has jumped "
                       "or lost a crossing",
                       i, (i + 1) % taken.size()));
      return;
    }
  }

  bool same_point(const Judged& a, const Judged& b) const {
    const double tolerance = merging_tolerance(std::max(a.condition, b.condition));
    const auto placed = [&](const Judged& judged) {
      return scene_.in_frame(report_.candidates[judged.candidate].figure);
    };
    return figure_distance(placed(a), placed(b), scene_.size()) <= tolerance * scene_.size();
  }

  /// A regular curve passes each of its points once in a round; its mirror image is another point.
  void check_repetition(const std::vector<std::pair<int, int>>& taken) {
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const Judged& later = judged_[taken[i].first];
      for (std::size_t j = 0; j < i && later.condition < fold_condition; ++j) {
        if (solution_of_[taken[j].first] != solution_of_[taken[i].first]) continue;
        if (!same_point(judged_[taken[j].first], later)) continue;
        fail("repetition",
             fmt::format(
                 "crossings {} and {} of a path are the same point: the path has jumped or missed its end", j,
                 i));
        return;
      }
    }
  }

  void check_all_met() {
    for (std::size_t i = 0; i < judged_.size(); ++i)
      if (met_.count(static_cast<int>(i)) == 0)
        fail("off path", fmt::format("solution {} is claimed to be on the path, but no crossing names it",
                                     solution_of_[i]));
  }

  /// Doubles do not show what tells solutions apart next to a multiple one, or of a part that is smaller than the rounding of
  /// the whole.
  bool shows_all_parts() const {
    double condition = 1;
    for (const Judged& judged : judged_) condition = std::max(condition, judged.condition);
    return condition < singular_condition &&
           shortest_length(scene_) > merging_tolerance(condition) * scene_.size();
  }

  /// What is put together from different solutions of the parts is different. Where none are counted, those that doubles do
  /// not tell apart are one; where parts have undecided ones, doubles may have found one twice.
  void check_totals() {
    const bool are_counted = report_.totals->real || report_.totals->complex;
    const bool are_decided = are_counted && report_.status == SolveStatus::complete && shows_all_parts();
    if (are_decided && assessment_.solutions.size() != judged_.size())
      fail("count", fmt::format("{} solutions were put together, and {} of them are different",
                                judged_.size(), assessment_.solutions.size()));
  }

  void count();

  const Scene& scene_;
  SolveReport report_;
  int threads_;
  const FigureJudge judge_{scene_};
  Assessment assessment_;
  std::vector<Judged> judged_;     // their representatives are those of the list
  std::vector<int> judged_index_;  // by candidate: index in judged_, or −1
  std::vector<int> solution_of_;   // by judged candidate
  std::set<int> met_;              // judged candidates that a crossing names
};

bool is_singular(const AssessedSolution& solution) {
  return solution.multiplicity > 1 || !(solution.condition <= singular_condition);
}

void Assessor::count() {
  Counts& counts = assessment_.counts;
  counts.singular = 0;
  const Claim claim = report_.claim;
  if (claim == Claim::on_path || claim == Claim::on_path_of_core) counts.on_path = 0;
  if (claim == Claim::all_real || claim == Claim::all_complex) counts.real_up_to_reflection = 0;
  if (claim == Claim::all_complex) counts.complex_up_to_reflection = 0;
  if (!stated_signs(scene_.problem()).empty()) counts.not_as_stated = counts.undecided = 0;
  counts.generic = report_.generic;
  assessment_.totals = report_.totals;
  if (report_.totals) check_totals();
  recount(assessment_);
  counts.at_infinity = report_.at_infinity;
  assessment_.ends = ends_of(report_.paths);
  for (const Figure& figure : report_.escaping)
    if (!scene_.problem().is_general() && !scene_.has_lines() &&
        figure.points.cols() == scene_.point_count() && figure.imaginary.cols() == scene_.point_count())
      assessment_.escaping.push_back(scene_.in_file_unit(figure));
  if (report_.paths.empty()) return;
  const auto ended = [this](auto... ends) {
    return std::count_if(report_.paths.begin(), report_.paths.end(),
                         [=](const PathRecord& path) { return ((path.end == ends) || ...); });
  };
  counts.paths = report_.paths.size();
  counts.at_infinity = ended(PathRecord::End::at_infinity);
  counts.failed_paths = ended(PathRecord::End::failed, PathRecord::End::stopped);
}

}  // namespace

Assessment::Assessment() = default;
Assessment::Assessment(const Assessment&) = default;
Assessment::Assessment(Assessment&&) noexcept = default;
Assessment& Assessment::operator=(const Assessment&) = default;
Assessment& Assessment::operator=(Assessment&&) noexcept = default;
Assessment::~Assessment() = default;

Assessment assess(const Scene& scene, SolveReport report, int threads, const ErrorsOf& errors_of) {
  return Assessor(scene, std::move(report), threads).run(errors_of);
}

void recount(Assessment& assessment) {
  Counts& counts = assessment.counts;
  const auto& solutions = assessment.solutions;
  const auto count_standing = [&](Standing standing) {
    return std::count_if(solutions.begin(), solutions.end(), [=](const AssessedSolution& s) {
      return s.is_real() && s.signs.standing == standing;
    });
  };
  if (counts.real_up_to_reflection) counts.real_up_to_reflection = count_standing(Standing::as_stated);
  if (counts.not_as_stated) counts.not_as_stated = count_standing(Standing::not_as_stated);
  if (counts.undecided) counts.undecided = count_standing(Standing::undecided);
  if (counts.complex_up_to_reflection) counts.complex_up_to_reflection = solutions.size();
  if (assessment.totals) {
    counts.real_up_to_reflection = assessment.totals->real;
    counts.complex_up_to_reflection = assessment.totals->complex;
    counts.generic = assessment.totals->generic;
  }
  if (counts.singular) counts.singular = std::count_if(solutions.begin(), solutions.end(), is_singular);
  if (counts.certified)
    counts.certified = std::count_if(solutions.begin(), solutions.end(),
                                     [](const AssessedSolution& s) { return s.certified; });
  if (counts.on_path) {
    std::set<int> met;
    for (const AssessedCrossing& crossing : assessment.crossings)
      if (crossing.solution && solutions[static_cast<std::size_t>(*crossing.solution)].is_as_stated())
        met.insert(*crossing.solution);
    counts.on_path = met.size();
  }
}

void keep_real(Assessment& assessment) {
  const auto is_complex = [](const AssessedSolution& solution) { return !solution.figure.is_real(); };
  std::erase_if(assessment.solutions, is_complex);
  assessment.counts.complex_up_to_reflection.reset();
  if (assessment.totals) assessment.totals->complex.reset();
  recount(assessment);
}

void keep_first(Assessment& assessment, std::size_t limit) {
  if (assessment.solutions.size() <= limit) return;
  assessment.solutions.resize(limit);
  const auto reset_left_out = [limit](std::vector<AssessedCrossing>& crossings) {
    for (AssessedCrossing& crossing : crossings)
      if (crossing.solution && *crossing.solution >= static_cast<int>(limit)) crossing.solution.reset();
  };
  reset_left_out(assessment.crossings);
  for (AssessedCurve& curve : assessment.curves) reset_left_out(curve.crossings);
  recount(assessment);
}

}  // namespace gcs
