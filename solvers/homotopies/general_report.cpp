#include "solvers/homotopies/general_report.hpp"

#include <algorithm>
#include <limits>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/homotopies/complex_report.hpp"
#include "solvers/homotopies/distinct_ends.hpp"
#include "solvers/homotopies/shortcomings.hpp"
#include "solvers/motions/apparent_motion.hpp"
#include "solvers/motions/local_multiplicity.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// How far from the reals the end of a path may be, relative to 1 + its largest |x_i|, for its real part to be tried.
constexpr double nearly_real = 1e-6;
/// How far from there Newton's method may find the solution that the end is.
constexpr double same_solution = 1e-9;
/// Below this condition number no solution is double.
constexpr double regular = 1e4;
/// From here on an end without a conjugate has a Jacobian that loses rank.
constexpr double rank_lost = 1e13;

double distance_from_reals(const ComplexVectorX& x) {
  double distance = 0;
  for (const std::complex<double>& value : x) distance = std::max(distance, std::abs(value.imag()));
  return distance / (1 + largest(x));
}

/// Whether a segment of a relation has the length 0 to rounding: its direction is an unknown, and none of the figure's.
bool has_segment_of_length_0(const ProblemStatement& problem, const Figure& figure) {
  constexpr double rounding = 1e-13;  // of coordinates that Newton's method has settled, in the scene's unit
  const double least = rounding * std::max(1.0, extent(figure));
  const auto meet = [least](const Eigen::Matrix3Xd& at, const Operand& segment) {
    return at.cols() == 0 || (at.col(segment.end) - at.col(segment.entity)).norm() <= least;
  };
  const auto is_point = [&](const Operand& segment) {
    return meet(figure.points, segment) && meet(figure.imaginary, segment);
  };
  return std::ranges::any_of(problem.relations, [&](const Relation& relation) {
    return std::ranges::any_of(relation.of,
                               [&](const Operand& of) { return of.is_segment() && is_point(of); });
  });
}

class GeneralReporter {
 public:
  GeneralReporter(const SceneSystem& system, const GeneralEquations& equations, const std::stop_token& stop)
      : scene_(system.elements().scene()), system_(system), equations_(equations), stop_(stop) {
    report_.claim = Claim::all_complex;
  }

  SolveReport run(const std::vector<PathEnd>& ends, const WorkCounters& work, std::mt19937_64& random) {
    report_.work = work;
    const DistinctEnds distinct(ends, equations_.signs, random);
    missing_.jumps = distinct.jumps();
    for (int i = 0; i < distinct.size() && !stop_.stop_requested(); ++i) add_end(distinct, i);
    for (const PathEnd& end : ends) add_path(end);
    if (without_angle_ > 0) report_.particulars.push_back({"segments_of_length_0", without_angle_});
    const bool is_stopped = stop_.stop_requested() || is_any_stopped(ends);
    if (!is_stopped) look_for_motion(random);
    const std::string missing = missing_.in_words(), apparent = apparent_in_words(report_.motions);
    conclude(is_stopped, "", missing + (missing.empty() || apparent.empty() ? "" : "; ") + apparent, report_);
    return std::move(report_);
  }

 private:
  void add_end(const DistinctEnds& distinct, int i) {
    const bool is_lonely = !distinct.has_conjugate(i);
    const Figure figure = figure_of(distinct[i], distinct.is_singular(i));
    if (has_segment_of_length_0(scene_.problem(), figure)) {
      ++without_angle_;
      return;
    }
    missing_.too_far += loses_distances(scene_, figure);
    const bool loses_rank = is_lonely && judge_.condition(figure) >= rank_lost;
    if (loses_rank) add_loose(distinct[i]);
    missing_.lonely += is_lonely && !loses_rank;
    if (distinct.is_singular(i))
      add_meeting(distinct[i], distinct.paths(i), figure, loses_rank);
    else if (!judge_.is_stiff(figure) || !add(simple_solutions_near(system_, distinct[i], 1, stop_), 1))
      report_.candidates.push_back({figure, 1});
  }

  /// An end at which paths met: simple solutions next to it, or a multiple one where none is proven to be simple.
  void add_meeting(const ComplexVectorX& x, int paths, const Figure& figure, bool is_loose) {
    const ResolvedCandidates simple = simple_solutions_near(system_, x, paths, stop_);
    if (add(simple, paths)) return;
    const bool is_multiple = simple.list.empty() && judge_.residual(figure) <= double_root_residual &&
                             judge_.condition(figure) >= regular;
    missing_.in_between += !is_multiple;
    if (is_multiple && !is_loose && !can_be_isolated(x, paths)) add_loose(x);
    report_.candidates.push_back({figure, paths, std::numeric_limits<double>::infinity()});
  }

  /// Each of so many classes at values nearby has next to x as many solutions as there are changes of signs that leave x
  /// where it is.
  bool can_be_isolated(const ComplexVectorX& x, int paths) const {
    std::vector<SignMask> changing;
    for (std::size_t i = 0; i < x.size(); ++i)
      changing.push_back(std::abs(x[i]) <= singular_uncertainty * (1 + largest(x)) ? 0 : equations_.signs[i]);
    const int most = paths << (equations_.signs.rank() - SignMasks(std::move(changing)).rank());
    const auto multiplicity = local_multiplicity(equations_.exact, x, most);
    return multiplicity && *multiplicity <= most;
  }

  void add_loose(const ComplexVectorX& x) {
    ++missing_.not_isolated;
    if (!loose_end_) loose_end_ = x;
  }

  void look_for_motion(std::mt19937_64& random) {
    if (!loose_end_) return;
    auto motion = apparent_motion(
        scene_, real_equations(equations_.exact), real_parts(*loose_end_),
        [this](const Eigen::VectorXd& x) {
          return system_.figure({x.begin(), x.end()}, true);
        },
        random);
    if (motion) report_.motions.push_back(*std::move(motion));
  }

  /// Where these are so many, which doubles tell apart.
  bool add(const ResolvedCandidates& simple, int count) {
    if (!simple.are(count)) return false;
    report_.candidates.insert(report_.candidates.end(), simple.list.begin(), simple.list.end());
    return true;
  }

  void add_path(const PathEnd& end) {
    report_.paths.push_back(path_record(end));
    if (end.kind != PathEnd::Kind::failed) return;
    LostPaths& lost = missing_.lost[end.cause];
    ++lost.count;
    if (end.x.size() == static_cast<std::size_t>(equations_.system.unknowns))
      lost.condition = std::max(lost.condition, judge_.condition(system_.figure(end.x, false)));
  }

  Figure figure_of(const ComplexVectorX& x, bool is_singular) const {
    const std::optional<ComplexVectorX> real =
        real_end(equations_.system, equations_.coefficients, x, is_singular);
    return system_.figure(real.value_or(x), real.has_value());
  }

  const Scene& scene_;
  const SceneSystem& system_;
  const GeneralEquations& equations_;
  const std::stop_token& stop_;
  const FigureJudge judge_{scene_};
  Shortcomings missing_;
  int without_angle_ = 0;                    ///< ends
  std::optional<ComplexVectorX> loose_end_;  ///< the first one that is not isolated
  SolveReport report_;
};

}  // namespace

std::optional<ComplexVectorX> real_end(const MonomialSystem& system, const ComplexVectorX& coefficients,
                                       const ComplexVectorX& x, bool is_singular) {
  if (distance_from_reals(x) > (is_singular ? singular_uncertainty : nearly_real)) return std::nullopt;
  ComplexVectorX real = x;
  for (std::complex<double>& value : real) value = value.real();
  if (is_singular) return real;
  if (!newton(system, coefficients, real)) return std::nullopt;
  if (distance(real, x) > same_solution * (1 + largest(x))) return std::nullopt;
  return real;
}

bool RegularClasses::add(ComplexVectorX x) {
  const ComplexVectorX from = x;
  if (!newton(equations_.system, equations_.coefficients, x) ||
      distance(x, from) > tolerances_.nearby * (1 + largest(from)))
    return false;
  const int known = known_.size();
  known_.insert(x, tolerances_.same);
  if (known_.size() == known) return true;
  ends_.emplace_back().kind = PathEnd::Kind::regular;
  ends_.back().x = std::move(x);
  return true;
}

SolveReport general_report(const SceneSystem& scene, const GeneralEquations& equations,
                           const std::vector<PathEnd>& ends, const WorkCounters& work,
                           std::mt19937_64& random, const std::stop_token& stop) {
  return GeneralReporter(scene, equations, stop).run(ends, work, random);
}

}  // namespace gcs
