#include "solvers/answers/assess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"

namespace gcs {

namespace {

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Above this, a double solution and two solutions that rounding cannot tell apart look the same.
constexpr double singular_condition = 1e12;

/// Two different solutions closer together than the coarsest merging tolerance lie on both sides of a fold,
/// where the condition number is at least of the order of one over their distance. Below this one they are
/// one.
constexpr double fold_condition = 1e6;

/// A candidate that can be judged, with everything that does not depend on the others.
struct Judged {
  Figure figure;          ///< in the frame, not mirrored
  Figure representative;  ///< in the scene's unit
  double condition = 0;
  int multiplicity = 1;
  double error = 0;  ///< that of the candidate
  SignVerdict signs{};
};

bool is_finite(const LinePosition& line) { return line.point.allFinite() && line.direction.allFinite(); }
bool is_finite(const PlanePosition& plane) { return plane.normal.allFinite() && std::isfinite(plane.offset); }

/// Up to motions, complex figures are compared with one line at most.
bool is_usable_as_complex(const Scene& scene, const Figure& figure) {
  if (figure.imaginary.cols() != scene.point_count() || figure.imaginary_lines.size() != figure.lines.size())
    return false;
  if (figure.imaginary_planes.size() != figure.planes.size()) return false;
  if (!scene.problem().is_general() && !scene.is_anchored() && figure.lines.size() > 1) return false;
  const Figure framed = scene.in_frame(figure);
  return framed.points.allFinite() && framed.imaginary.allFinite() &&
         std::isfinite(extent(scene.representative(figure)));
}

bool is_usable(const Scene& scene, const Candidate& candidate) {
  const Figure& figure = candidate.figure;
  return figure.points.cols() == scene.point_count() && figure.lines.size() == scene.problem().lines.size() &&
         figure.planes.size() == scene.problem().planes.size() && figure.points.allFinite() &&
         std::ranges::all_of(figure.lines, [](const LinePosition& line) { return is_finite(line); }) &&
         std::ranges::all_of(figure.planes, [](const PlanePosition& plane) { return is_finite(plane); }) &&
         (figure.is_real() || is_usable_as_complex(scene, figure)) && candidate.multiplicity >= 1;
}

/// The most that a coordinate of a point differs by, and of a line's direction or a plane's normal, whichever way it
/// goes, times `size`.
double figure_distance(const Figure& a, const Figure& b, double size) {
  double largest = (a.points - b.points).cwiseAbs().maxCoeff();
  const auto take = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    largest = std::max(largest, size * std::min((one - other).norm(), (one + other).norm()));
  };
  for (std::size_t i = 0; i < a.lines.size(); ++i) take(a.lines[i].direction, b.lines[i].direction);
  for (std::size_t i = 0; i < a.planes.size(); ++i) take(a.planes[i].normal, b.planes[i].normal);
  return largest;
}

std::vector<Figure> representatives(const std::vector<Judged>& judged) {
  std::vector<Figure> figures;
  for (const Judged& j : judged) figures.push_back(j.representative);
  return figures;
}

std::vector<int> classify(const Scene& scene, const std::vector<Judged>& judged) {
  std::vector<SolutionAccuracy> accuracies;
  for (const Judged& candidate : judged) accuracies.push_back({candidate.condition, candidate.error});
  return solution_classes(scene, representatives(judged), accuracies).class_of;
}

/// Appends the coordinates in units of `grain` of the scene's size, cut to integers so that rounding does not
/// decide an order. The offset keeps the cuts away from round numbers such as the frame's zeros.
void append_cut(const Scene& scene, const Figure& figure, double grain, std::vector<double>& key) {
  const auto append = [&](const Eigen::Vector3d& v, double unit) {
    for (const double x : v) key.push_back(std::floor(x / unit + 0.6180339887));
  };
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) append(figure.points.col(i), grain * scene.size());
  for (Eigen::Index i = 0; i < figure.imaginary.cols(); ++i)
    append(figure.imaginary.col(i), grain * scene.size());
  for (const auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (const LinePosition& line : *lines) {
      append(line.point, grain * scene.size());
      append(line.direction, grain);
    }
  for (const auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (const PlanePosition& plane : *planes) {
      append(plane.normal, grain);
      append(Eigen::Vector3d(plane.offset, 0, 0), grain * scene.size());
    }
}

/// What solutions are sorted by, real ones first, as they stand to what is stated; the finer cut tells neighbours apart.
std::vector<double> order_key(const Scene& scene, const Judged& judged) {
  const Figure& figure = judged.representative;
  std::vector<double> key{figure.is_real() ? 0.0 : 1.0, static_cast<double>(judged.signs.standing)};
  for (const double grain : {1e-7, 1e-10}) append_cut(scene, figure, grain, key);
  return key;
}

/// Of a real figure, whose coordinates are as good as merging takes them to be, or as is proven.
SignVerdict signs_of(const Scene& scene, const std::vector<StatedSign>& signs, const Judged& judged) {
  if (signs.empty() || !judged.figure.is_real()) return {};
  const double reach = std::max(scene.size(), extent(judged.representative));
  const double error = std::min(judged.error, merging_tolerance(judged.condition) * reach);
  return verdict_on(signs, judged.representative, error);
}

/// Multiplicity of a class: the largest that was reported for a member.
AssessedSolution solution_of_class(const FigureJudge& judge, const Judged& first, int multiplicity,
                                   const std::shared_ptr<const FileTerms>& terms) {
  AssessedSolution solution;
  solution.terms = terms;
  solution.figure = first.representative;
  solution.multiplicity = multiplicity;
  solution.residual = judge.residual(first.representative);
  solution.condition = first.condition;
  solution.signs = first.signs;
  return solution;
}

/// Fills `solutions` in their order; returns the index of the solution of each judged candidate.
std::vector<int> list_solutions(const Scene& scene, const FigureJudge& judge,
                                const std::vector<Judged>& judged, std::vector<AssessedSolution>& solutions) {
  const std::vector<int> class_of = classify(scene, judged);
  std::vector<int> first;
  std::vector<int> multiplicity(judged.size(), 0);  // by class
  for (int i = 0; i < static_cast<int>(judged.size()); ++i) {
    if (multiplicity[class_of[i]] == 0) first.push_back(i);
    multiplicity[class_of[i]] = std::max(multiplicity[class_of[i]], judged[i].multiplicity);
  }
  std::vector<std::pair<std::vector<double>, int>> order;
  for (const int i : first) order.emplace_back(order_key(scene, judged[i]), i);
  std::sort(order.begin(), order.end());

  const auto terms = file_terms(scene);
  std::vector<int> solution_of_class_index(judged.size(), -1);
  for (const auto& [key, i] : order) {
    solution_of_class_index[class_of[i]] = static_cast<int>(solutions.size());
    solutions.push_back(solution_of_class(judge, judged[i], multiplicity[class_of[i]], terms));
  }
  std::vector<int> solution_of;
  for (const int c : class_of) solution_of.push_back(solution_of_class_index[c]);
  return solution_of;
}

/// What a figure in double precision can reach: every coordinate is rounded to u·extent, so a distance is off
/// by up to 2·√3·u·extent, divided by the shortest length as relative_residual does. A hundred such roundings
/// are allowed; a corrector that stopped early leaves far more. Between complex points a short distance may
/// be the difference of large squares: its error is larger by the extent over the length once more.
double residual_limit(const Scene& scene, const Judged& judged) {
  const double reach = std::max(scene.size(), extent(judged.representative));
  double shortest = scene.size();
  for (const double length : scene.target_lengths()) shortest = std::min(shortest, length);
  const double stretch = reach / std::max(shortest, 1e-3 * scene.size());
  return 100 * 2 * std::sqrt(3.0) * unit_roundoff * stretch * (judged.figure.is_real() ? 1 : stretch);
}

class Assessor {
 public:
  Assessor(const Scene& scene, const SolveReport& report) : scene_(scene), report_(report) {}

  Assessment run() {
    judge_candidates();
    solution_of_ = list_solutions(scene_, judge_, judged_, assessment_.solutions);
    check_residuals();
    for (const PathRecord& path : report_.paths) take_crossings(path);
    for (const CurveRecord& curve : report_.curves) take_curve(curve);
    if (report_.claim == Claim::on_path) check_all_met();
    for (Motion motion : report_.motions) {
      motion.figure = motion.figure.scaled(scene_.unit_exponent());
      assessment_.motions.push_back(std::move(motion));
    }
    count();
    return std::move(assessment_);
  }

 private:
  void fail(std::string name, std::string what) {
    assessment_.failed_checks.push_back({std::move(name), std::move(what)});
  }

  void judge_candidates() {
    for (std::size_t i = 0; i < report_.candidates.size(); ++i) {
      const Candidate& candidate = report_.candidates[i];
      judged_index_.push_back(-1);
      if (!is_usable(scene_, candidate)) {
        fail("malformed",
             fmt::format("candidate {} lacks an entity, is not finite or has no multiplicity", i));
        continue;
      }
      judged_index_.back() = static_cast<int>(judged_.size());
      Judged judged{scene_.in_frame(candidate.figure), scene_.representative(candidate.figure), 0,
                    candidate.multiplicity, candidate.error};
      judged.condition = judge_.condition(judged.representative);
      judged.signs = signs_of(scene_, signs_, judged);
      judged_.push_back(std::move(judged));
    }
  }

  void check_residuals() {
    for (std::size_t i = 0; i < judged_.size(); ++i) {
      const AssessedSolution& solution = assessment_.solutions[solution_of_[i]];
      if (!listed_.insert(solution_of_[i]).second) continue;
      const double limit = residual_limit(scene_, judged_[i]);
      if (solution.residual <= limit) continue;
      fail("residual", fmt::format("solution {} has a residual of {:.2g}, above {:.2g}", solution_of_[i],
                                   solution.residual, limit));
    }
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
    return figure_distance(a.figure, b.figure, scene_.size()) <= tolerance * scene_.size();
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

  /// What is put together from different solutions of the parts is different. Where none are counted, those
  /// that doubles do not tell apart are one.
  void check_totals() {
    const bool are_counted = report_.totals->real || report_.totals->complex;
    if (are_counted && assessment_.solutions.size() != judged_.size())
      fail("count", fmt::format("{} solutions were put together, and {} of them are different",
                                judged_.size(), assessment_.solutions.size()));
  }

  void count();

  const Scene& scene_;
  const SolveReport& report_;
  const FigureJudge judge_{scene_};
  const std::vector<StatedSign> signs_ = stated_signs(scene_.problem());
  Assessment assessment_;
  std::vector<Judged> judged_;
  std::vector<int> judged_index_;  // by candidate: index in judged_, or −1
  std::vector<int> solution_of_;   // by judged candidate
  std::set<int> listed_;           // solutions whose residual has been checked
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
  if (!signs_.empty()) counts.not_as_stated = counts.undecided = 0;
  counts.generic = report_.generic;
  assessment_.totals = report_.totals;
  if (report_.totals) check_totals();
  recount(assessment_);
  counts.at_infinity = report_.at_infinity;
  assessment_.ends = ends_of(report_.paths);
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

Assessment assess(const Scene& scene, const SolveReport& report) { return Assessor(scene, report).run(); }

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
