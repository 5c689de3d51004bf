#include "solvers/homotopies/complex_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "solvers/certificates/near_solutions.hpp"
#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/certificates/proven_error.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/figures/fold_solutions.hpp"
#include "solvers/figures/point_conditions.hpp"
#include "solvers/figures/reflection_classes.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/homotopies/close_pair.hpp"
#include "solvers/homotopies/distinct_ends.hpp"
#include "solvers/homotopies/shortcomings.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/wide_reference.hpp"
#include "solvers/motions/apparent_motion.hpp"
#include "solvers/motions/isolation.hpp"
#include "solvers/motions/motion_finder.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// How far from the reals Newton's method in R may find the solution of a regular end.
constexpr double next_to_real = 1e-9;

/// How far the rounding of the lengths to the doubles that paths are followed for moves a regular solution.
double moved_by_rounding(const Scene& scene, const Figure& figure) {
  return 4 * std::numeric_limits<double>::epsilon() * jacobian_condition(scene, figure) * scene.size();
}

/// How far from the reals x may be and be taken for a real point: `nearby`, relative to 1 + the largest
/// |x_i|.
double real_tolerance(const ComplexVectorX& x, double nearby) {
  double size = 0;
  for (const std::complex<double>& value : x) size = std::max(size, std::abs(value));
  return nearby * (1 + size);
}

/// The real part of x, if the rest is within `tolerance`.
std::optional<Eigen::VectorXd> real_part(const ComplexVectorX& x, double tolerance) {
  const auto is_off = [&](const std::complex<double>& value) { return std::abs(value.imag()) > tolerance; };
  if (std::any_of(x.begin(), x.end(), is_off)) return std::nullopt;
  Eigen::VectorXd real(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) real[static_cast<Eigen::Index>(i)] = x[i].real();
  return real;
}

Figure complex_figure(const DistanceSystem& system, const ComplexVectorX& x) {
  return complex_figure(system,
                        Eigen::VectorXcd(Eigen::Map<const Eigen::VectorXcd>(x.data(), system.unknowns())));
}

/// Whether doubles are known to lie next to different solutions, eight times further apart than the rounding
/// of each may leave it from its own, and whether each is known to be real or not to be.
bool are_told_apart(const Scene& scene, const std::array<Figure, 2>& figures) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  double uncertain = 0;
  for (const Figure& figure : figures) {
    const double stretch = std::max(1.0, extent(figure) / scene.size());
    uncertain = std::max(uncertain, 8 * rounding * jacobian_condition(scene, figure) * stretch * stretch);
    if (!figure.is_real() && figure.imaginary.lpNorm<Eigen::Infinity>() <= next_to_real * stretch)
      return false;
  }
  double apart = (figures[0].points - figures[1].points).lpNorm<Eigen::Infinity>();
  if (!figures[0].is_real() && !figures[1].is_real())
    apart = std::max(apart, (figures[0].imaginary - figures[1].imaginary).lpNorm<Eigen::Infinity>());
  return apart > uncertain * scene.size();
}

/// A condition number that leaves three digits or fewer of a correction along the Jacobian's near kernel.
constexpr double rank_lost = 1e13;

/// Of distances, relative to the scene's size: more than any solutions are merged by (merging_tolerance).
constexpr double neighbourhood = 2e-5;

/// Below this condition number no solution is so near another that doubles do not tell them apart.
constexpr double regular = 1e4;

/// The relative residual of a solution for rounded lengths, if that is what it should be.
constexpr double rounded_lengths = 1e-9;

bool is_multiple_solution(const Scene& scene, const Figure& figure) {
  return relative_residual(scene, figure) <= double_root_residual &&
         jacobian_condition(scene, figure) >= regular;
}

/// Makes the report of the ends of all paths.
class ComplexReporter {
 public:
  ComplexReporter(const Scene& scene, const DistanceSystem& system, const SolveMeans& means)
      : scene_(scene), system_(system), means_(means) {
    report_.claim = Claim::all_complex;
  }

  SolveReport run(const std::vector<PathEnd>& ends, const WorkCounters& work, std::mt19937_64& random) {
    report_.work = work;
    std::optional<DistinctEnds> distinct(std::in_place, ends, mirror_axes(scene_, system_), random);
    MotionFinder finder(scene_, system_, random);
    missing_.jumps = distinct->jumps();
    add_ends(*distinct, finder);
    distinct.reset();  // long lists are large
    const bool is_stopped = means_.stop.stop_requested() || is_any_stopped(ends);
    if (loose_end_ && !is_stopped) finder.look_for_apparent_motion(*loose_end_);
    report_.motions = finder.motions();
    prove_regular_ones();
    prove_neighbours();
    report_.paths.reserve(ends.size());
    for (const PathEnd& end : ends) add_path(end);
    conclude(is_stopped, in_words(scene_.problem(), report_.motions), shortcomings_in_words(), report_);
    return std::move(report_);
  }

 private:
  /// What one end says without the others' reports.
  struct EndFacts {
    Figure figure{};  ///< of a regular end
    bool is_lonely = false;
    double condition = std::numeric_limits<double>::infinity();  ///< of a regular end's Jacobian
  };

  EndFacts facts_of(const DistinctEnds& distinct, int i) const {
    return {distinct.is_singular(i) ? Figure{} : figure_of(distinct[i], next_to_real),
            !distinct.has_conjugate(i)};
  }

  /// What threads find out of so many at a time; of all at once it would be as large as the report.
  void add_ends(const DistinctEnds& distinct, MotionFinder& finder) {
    constexpr int at_once = 4096;
    report_.candidates.reserve(static_cast<std::size_t>(distinct.size()));
    for (int first = 0; first < distinct.size(); first += at_once) {
      std::vector<EndFacts> facts(static_cast<std::size_t>(std::min(at_once, distinct.size() - first)));
      on_threads(facts.size(),
                 [&](std::size_t k) { facts[k] = facts_of(distinct, first + static_cast<int>(k)); });
      find_conditions(facts);
      for (std::size_t k = 0; k < facts.size() && !means_.stop.stop_requested(); ++k)
        add_end(distinct, first + static_cast<int>(k), finder, facts[k]);
    }
  }

  void find_conditions(std::vector<EndFacts>& facts) const {
    constexpr std::size_t at_once = 64;  // as many as fill the lanes, and far fewer than threads share
    on_threads((facts.size() + at_once - 1) / at_once, [&](std::size_t block) {
      std::vector<EndFacts*> ends;
      std::vector<const Figure*> figures;
      for (std::size_t k = block * at_once; k < std::min(facts.size(), (block + 1) * at_once); ++k)
        if (facts[k].figure.points.cols() > 0) {
          ends.push_back(&facts[k]);
          figures.push_back(&facts[k].figure);
        }
      const std::vector<double> conditions = points_ ? points_->conditions(figures) : std::vector<double>();
      for (std::size_t k = 0; k < ends.size(); ++k)
        ends[k]->condition = points_ ? conditions[k] : jacobian_condition(scene_, *figures[k]);
    });
  }

  void add_end(const DistinctEnds& distinct, int i, MotionFinder& finder, EndFacts& facts) {
    const bool is_singular = distinct.is_singular(i), is_lonely = facts.is_lonely;
    if (distinct.is_precise(i) && !is_singular)
      if (const auto near = settled_near(distinct[i], 1); near && near->simple.size() == 1) {
        missing_.lonely += is_lonely && near->simple.front().realness != Certificate::Realness::real;
        return add_simple(near->simple);
      }
    const Figure figure = is_singular ? singular_figure(distinct[i]) : std::move(facts.figure);
    if (is_singular || facts.condition >= rank_lost) {
      const std::optional<Collapse> loose = finder.loose_at(distinct[i], singular_uncertainty);
      if (loose && finder.lies_on_motion(*loose, distinct[i])) return;
    }
    const bool is_isolated =
        is_singular
            ? can_be_isolated(scene_, complex_figure(system_, distinct[i]), distinct.paths(i))
            : facts.condition < rank_lost || (!is_lonely && is_isolated_in_more_bits(distinct[i], figure));
    missing_.too_far += is_singular && loses_distances(scene_, figure);
    missing_.lonely += is_lonely && is_isolated;
    missing_.not_isolated += !is_isolated;
    if (!is_isolated && !loose_end_) loose_end_ = distinct[i];
    if (!is_singular)
      add_regular(figure, facts.condition);
    else if (is_isolated)
      add_meeting(distinct[i], distinct.paths(i), figure);
    else
      add_multiple(figure, distinct.paths(i));
  }

  /// Whether an end where doubles do not tell the Jacobian's rank is a proven solution, or next to a few at most, and on no
  /// curve. From real lengths the ends on a curve come in conjugates as isolated ones do. One that
  /// doubles do not hold tells nothing, and is taken for isolated.
  bool is_isolated_in_more_bits(const ComplexVectorX& x, const Figure& figure) const {
    constexpr int few = 4;
    return relative_residual(scene_, figure) > rounded_lengths ||
           proven_next_to(scene_, {&figure}, means_).front().has_value() ||
           can_be_isolated(scene_, complex_figure(system_, x), few);
  }

  std::string shortcomings_in_words() const {
    const std::string missing = missing_.in_words(), apparent = apparent_in_words(report_.motions);
    return missing + (missing.empty() || apparent.empty() ? "" : "; ") + apparent;
  }

  /// An end at which paths met, or one its mirror image: solutions next to it, or a multiple one.
  void add_meeting(const ComplexVectorX& x, int paths, const Figure& figure) {
    bool is_in_between = !is_multiple_solution(scene_, figure);
    if (paths == 2) {
      const std::optional<FoldSolutions> fold = fold_at(nearly_real(x));
      if (fold && add_proven_pair(*fold)) return;
      is_in_between |= fold.has_value();
      if (is_in_between && add_close_pair(x)) return;
    }
    if (const auto near = settled_near(x, paths)) {
      if (std::ssize(near->simple) == paths) return add_simple(near->simple);
      is_in_between = near->count() != paths;
    }
    missing_.in_between += is_in_between;
    add_multiple(figure, paths);
  }

  /// What the file's own numbers make of the place at which so many paths ended, if certificates reach it.
  std::optional<NearSolutions> settled_near(const ComplexVectorX& x, int paths) {
    if (why_not_certified(scene_)) return std::nullopt;
    const SceneEquations equations(scene_);
    if (equations.coordinates(complex_figure(system_, x)) != x) return std::nullopt;
    return solutions_near(equations.system(), {{x, paths}}, paths, means_.stop);
  }

  void add_simple(const std::vector<Certificate>& solutions) {
    const SceneEquations equations(scene_);
    std::vector<Candidate> simple;
    for (const Certificate& solution : solutions) {
      const ComplexVectorX& mid = solution.enclosure.mid;
      const bool is_real = solution.realness == Certificate::Realness::real;
      const Figure figure = is_real ? system_.figure(*real_part(mid, std::numeric_limits<double>::infinity()))
                                    : complex_figure(system_, mid);
      simple.push_back({figure, 1, equations.distance(figure, solution)});
    }
    missing_.in_between += !are_different_classes(scene_, simple);
    report_.candidates.insert(report_.candidates.end(), simple.begin(), simple.end());
  }

  /// A simple one.
  void add_regular(const Figure& figure, std::optional<double> condition) {
    regular_.push_back(report_.candidates.size());
    report_.candidates.push_back({.figure = figure, .condition = condition});
  }

  /// Of complex ones those whose distances are not those of the file, in doubles; others that have neighbours, when all are
  /// known.
  void prove_regular_ones() {
    std::vector<char> is_far(regular_.size()), is_off(regular_.size());  // threads do not share a char
    on_threads(regular_.size(), [&](std::size_t i) {
      const Figure& figure = report_.candidates[regular_[i]].figure;
      is_far[i] = loses_distances(scene_, figure);
      is_off[i] = is_far[i] || (!figure.is_real() && relative_residual(scene_, figure) > rounded_lengths);
    });
    std::vector<std::size_t> off, others;
    for (std::size_t i = 0; i < regular_.size(); ++i) (is_off[i] ? off : others).push_back(i);
    std::vector<const Figure*> figures;
    for (const std::size_t i : off) figures.push_back(&report_.candidates[regular_[i]].figure);
    std::vector<std::optional<Candidate>> proven = proven_next_to(scene_, figures, means_);
    for (std::size_t k = 0; k < off.size(); ++k) {
      if (proven[k])
        report_.candidates[regular_[off[k]]] = *std::move(proven[k]);
      else
        others.push_back(off[k]);
      missing_.too_far += is_far[off[k]] && !proven[k];
    }
    on_threads(others.size(), [&](std::size_t k) {
      Candidate& candidate = report_.candidates[regular_[others[k]]];
      if (candidate.figure.is_real()) candidate.error = proven_error(scene_, squares_, candidate.figure);
    });
  }

  void on_threads(std::size_t items, const std::function<void(std::size_t)>& function) const {
    share_on_threads(items, means_.threads, [&](std::size_t i) {
      if (!means_.stop.stop_requested()) function(i);
    });
  }

  /// Of simple complex solutions that their distances alone may not tell apart. There are few.
  void prove_neighbours() {
    std::vector<Candidate*> complex;
    std::vector<const Figure*> figures;
    for (Candidate& candidate : report_.candidates)
      if (!candidate.figure.is_real() && candidate.multiplicity == 1 && !std::isfinite(candidate.error)) {
        complex.push_back(&candidate);
        figures.push_back(&candidate.figure);
      }
    const std::vector<ClassTolerance> tolerances(figures.size(), {neighbourhood});
    const ReflectionClasses alike = reflection_classes(scene_, figures, tolerances, means_.threads);
    std::vector<int> members(static_cast<std::size_t>(alike.count()), 0);
    for (const int one : alike.class_of) ++members[one];
    for (std::size_t i = 0; i < complex.size(); ++i)
      if (members[alike.class_of[i]] > 1)
        complex[i]->error = proven_error(scene_, squares_, complex[i]->figure);
  }

  void add_multiple(const Figure& figure, int multiplicity) {
    report_.candidates.push_back({figure, multiplicity, std::numeric_limits<double>::infinity()});
  }

  /// The real part of a singular end, if the end is nearly real.
  static std::optional<Eigen::VectorXd> nearly_real(const ComplexVectorX& x) {
    return real_part(x, real_tolerance(x, singular_uncertainty));
  }

  /// What there is next to a real part, if there is one.
  std::optional<FoldSolutions> fold_at(const std::optional<Eigen::VectorXd>& real) {
    return real ? solutions_at_fold(system_, squares_, *real, report_.work) : std::nullopt;
  }

  /// Whether there are real ones, and it is proven which solutions they are.
  bool add_proven_pair(const FoldSolutions& fold) {
    std::vector<Candidate> pair;
    for (const Eigen::VectorXd& x : fold.x) {
      const Figure figure = system_.figure(x);
      pair.push_back({figure, 1, proven_error(scene_, squares_, figure)});
      if (!std::isfinite(pair.back().error)) return false;
    }
    report_.candidates.insert(report_.candidates.end(), pair.begin(), pair.end());
    return !pair.empty();
  }

  /// Whether two solutions next to x are told apart.
  bool add_close_pair(const ComplexVectorX& x) {
    const auto pair = close_pair(system_, squares_, x);
    if (!pair) return false;
    const std::array figures{figure_of((*pair)[0], next_to_real), figure_of((*pair)[1], next_to_real)};
    if (!are_told_apart(scene_, figures)) return false;
    for (const Figure& figure : figures) add_regular(figure, std::nullopt);
    return true;
  }

  void add_path(const PathEnd& end) {
    report_.paths.push_back(path_record(end));
    if (end.kind == PathEnd::Kind::at_infinity) report_.escaping.push_back(complex_figure(system_, end.x));
    if (end.kind != PathEnd::Kind::failed) return;
    LostPaths& lost = missing_.lost[end.cause];
    ++lost.count;
    const Figure where = complex_figure(system_, end.x);
    if (std::isfinite(extent(where)))
      lost.condition = std::max(lost.condition, jacobian_condition(scene_, where));
  }

  /// Newton's method does not settle where a column of the Jacobian vanishes, as at a figure that is its own
  /// mirror image: there the exact lengths decide whether it is real, and where they do not, to rounding, it
  /// is one that the real part is.
  Figure singular_figure(const ComplexVectorX& x) {
    const Figure figure = figure_of(x, singular_uncertainty);
    const std::optional<Eigen::VectorXd> real = nearly_real(x);
    if (figure.is_real() || !real) return figure;
    if (const auto fold = fold_at(real)) return fold->x.empty() ? figure : system_.figure(fold->x.front());
    const Figure flat = system_.figure(*real);
    return relative_residual(scene_, flat) <= double_root_residual ? flat : figure;
  }

  Figure figure_of(const ComplexVectorX& x, double nearby) const {
    const std::optional<Figure> real = real_figure(x, nearby);
    return real ? *real : complex_figure(system_, x);
  }

  /// The real solution next to x, if there is one.
  std::optional<Figure> real_figure(const ComplexVectorX& x, double nearby) const {
    const double tolerance = real_tolerance(x, nearby);
    const std::optional<Eigen::VectorXd> start = real_part(x, tolerance);
    if (!start) return std::nullopt;
    Eigen::VectorXd real = *start;
    if (!refine(system_, squares_, real).converged) return std::nullopt;
    const Figure figure = system_.figure(real);
    const double moved = (real - *start).cwiseAbs().maxCoeff();
    if (moved <= tolerance) return figure;
    const bool is_regular_end = nearby < singular_uncertainty;
    return is_regular_end && moved <= moved_by_rounding(scene_, figure) ? std::optional(figure)
                                                                        : std::nullopt;
  }

  const Scene& scene_;
  const DistanceSystem& system_;
  const SolveMeans& means_;
  const std::vector<DoubleDouble> squares_ = target_squares(scene_);
  const std::optional<PointConditions> points_ = PointConditions::of(scene_);
  Shortcomings missing_;
  std::optional<ComplexVectorX> loose_end_;  ///< the first one that is not isolated
  std::vector<std::size_t> regular_;         ///< candidates to be proven
  SolveReport report_;
};

}  // namespace

bool is_any_stopped(const std::vector<PathEnd>& ends) {
  return std::ranges::any_of(ends, [](const PathEnd& end) { return end.kind == PathEnd::Kind::stopped; });
}

void conclude(bool is_stopped, const std::string& moving, const std::string& missing, SolveReport& report) {
  report.reason =
      is_stopped ? "stopped on the way" : moving + (moving.empty() || missing.empty() ? "" : "; ") + missing;
  report.status = is_stopped              ? SolveStatus::stopped
                  : !moving.empty()       ? SolveStatus::infinite
                  : report.reason.empty() ? SolveStatus::complete
                                          : SolveStatus::partial;
}

void conclude_stopped(const std::stop_token& stop, SolveReport& report) {
  if (report.status == SolveStatus::partial && stop.stop_requested()) conclude(true, "", "", report);
}

PathRecord path_record(const PathEnd& end) {
  PathRecord record;
  switch (end.kind) {
    case PathEnd::Kind::regular:
      record.end = PathRecord::End::regular;
      break;
    case PathEnd::Kind::singular:
      record.end = PathRecord::End::singular;
      break;
    case PathEnd::Kind::at_infinity:
      record.end = PathRecord::End::at_infinity;
      break;
    case PathEnd::Kind::failed:
      record.end = PathRecord::End::failed;
      break;
    case PathEnd::Kind::stopped:
      record.end = PathRecord::End::stopped;
      break;
  }
  record.cause = end.cause;
  if (end.kind == PathEnd::Kind::failed || end.kind == PathEnd::Kind::stopped) return record;
  record.winding_number = end.winding_number;
  record.pole_order = end.pole_order;
  return record;
}

SolveReport complex_report(const Scene& scene, const DistanceSystem& system, const std::vector<PathEnd>& ends,
                           const WorkCounters& work, std::mt19937_64& random, const SolveMeans& means) {
  return ComplexReporter(scene, system, means).run(ends, work, random);
}

}  // namespace gcs
