#include "solvers/homotopies/general_report.hpp"

#include <algorithm>
#include <iterator>
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
/// Relative to 1 + the largest |x_i|: ends that are stiff and no further apart may have changed places, since rounding
/// the values to u moves solutions next to a double one by some √u.
constexpr double one_place = 1e-6;

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
    add_ends(distinct, random);
    report_.paths.reserve(ends.size());
    for (const PathEnd& end : ends) add_path(end);
    if (without_angle_ > 0) report_.particulars.push_back({"segments_of_length_0", without_angle_});
    const bool is_stopped = stop_.stop_requested() || is_any_stopped(ends);
    if (!is_stopped) look_for_motion(random);
    const std::string missing = missing_.in_words(), apparent = apparent_in_words(report_.motions);
    conclude(is_stopped, "", missing + (missing.empty() || apparent.empty() ? "" : "; ") + apparent, report_);
    return std::move(report_);
  }

 private:
  struct StiffEnd {
    int number = 0;  ///< of the distinct ends
    Figure figure;
  };

  /// Where stiff ends are so near each other that they may have changed places.
  struct Place {
    std::vector<StiffEnd> ends;
    int paths = 0;
  };

  void add_ends(const DistinctEnds& distinct, std::mt19937_64& random) {
    SolutionSet middles(equations_.signs, random);
    std::vector<Place> places;
    report_.candidates.reserve(static_cast<std::size_t>(distinct.size()));
    for (int i = 0; i < distinct.size() && !stop_.stop_requested(); ++i) {
      Figure figure = figure_of(distinct[i], distinct.is_singular(i));
      if (has_segment_of_length_0(scene_.problem(), figure)) {
        ++without_angle_;
        continue;
      }
      if (!distinct.is_singular(i) && !judge_.is_stiff(figure)) {
        missing_.too_far += loses_distances(scene_, figure);
        missing_.lonely += !distinct.has_conjugate(i);
        report_.candidates.push_back({std::move(figure), 1});
        continue;
      }
      const auto number = static_cast<std::size_t>(middles.insert(distinct[i], one_place));
      places.resize(std::max(places.size(), number + 1));
      places[number].ends.push_back({i, std::move(figure)});
      places[number].paths += distinct.paths(i);
    }
    std::vector<Candidate> simple;
    for (std::size_t k = 0; k < places.size() && !stop_.stop_requested(); ++k) {
      const int mirrored = middles.find(conjugate(middles[static_cast<int>(k)]), one_place);
      const bool is_lonely =
          mirrored < 0 || places[static_cast<std::size_t>(mirrored)].paths != places[k].paths;
      add_place(distinct, places[k], is_lonely, simple);
    }
    missing_.in_between += !are_different_classes(scene_, simple);
    report_.candidates.insert(report_.candidates.end(), simple.begin(), simple.end());
  }

  /// Several precise ends each for itself, if doubles tell what they are apart; others together.
  ResolvedCandidates settled(const DistinctEnds& distinct, const Place& place) const {
    const bool are_precise =
        place.ends.size() > 1 && std::ranges::all_of(place.ends, [&](const StiffEnd& end) {
          return distinct.is_precise(end.number) && !distinct.is_singular(end.number);
        });
    ResolvedCandidates each;
    for (std::size_t k = 0; are_precise && k < place.ends.size(); ++k) {
      const int number = place.ends[k].number;
      ResolvedCandidates one =
          simple_solutions_near(system_, distinct[number], distinct.paths(number), stop_);
      std::ranges::move(one.list, std::back_inserter(each.list));
    }
    each.are_told_apart = are_different_classes(scene_, each.list);
    if (each.are(place.paths)) return each;
    return simple_solutions_near(system_, distinct[place.ends.front().number], place.paths, stop_);
  }

  /// As many simple solutions for the file's own numbers as paths ended there, or the ends as they are.
  void add_place(const DistinctEnds& distinct, const Place& place, bool is_lonely,
                 std::vector<Candidate>& simple) {
    const ResolvedCandidates found = settled(distinct, place);
    const auto is_real = [](const Candidate& candidate) { return candidate.figure.is_real(); };
    if (found.are(place.paths)) {
      missing_.lonely += is_lonely && !std::ranges::all_of(found.list, is_real);
      simple.insert(simple.end(), found.list.begin(), found.list.end());
      return;
    }
    missing_.in_between += place.ends.size() > 1;
    for (const StiffEnd& end : place.ends) add_unresolved(distinct, end, found.list.empty());
  }

  void add_unresolved(const DistinctEnds& distinct, const StiffEnd& end, bool may_be_multiple) {
    const ComplexVectorX& x = distinct[end.number];
    const bool is_lonely = !distinct.has_conjugate(end.number);
    missing_.too_far += loses_distances(scene_, end.figure);
    const bool loses_rank = is_lonely && judge_.condition(end.figure) >= rank_lost;
    if (loses_rank) add_loose(x);
    missing_.lonely += is_lonely && !loses_rank;
    const int paths = distinct.paths(end.number);
    if (!distinct.is_singular(end.number)) return report_.candidates.push_back({end.figure, 1});
    const bool is_multiple = may_be_multiple && judge_.residual(end.figure) <= double_root_residual &&
                             judge_.condition(end.figure) >= regular;
    missing_.in_between += !is_multiple;
    if (is_multiple && !loses_rank && !can_be_isolated(x, paths)) add_loose(x);
    report_.candidates.push_back({end.figure, paths, std::numeric_limits<double>::infinity()});
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
    return system_.figure(real ? *real : x, real.has_value());
  }

  const Scene& scene_;
  const SceneSystem& system_;
  const GeneralEquations& equations_;
  const std::stop_token& stop_;
  const FigureJudge judge_{system_};
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
