#include "solvers/complex_tracking/complex_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

#include "solvers/certification/proven_error.hpp"
#include "solvers/complex_tracking/close_pair.hpp"
#include "solvers/complex_tracking/mirror_images.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/fold_solutions.hpp"
#include "solvers/model/quality.hpp"
#include "solvers/model/wide_reference.hpp"

namespace gcs {
namespace {

/// Of a singular end: Cauchy's formula is right to the rounding of its samples, which a double root feels by
/// its square root.
constexpr double singular_uncertainty = 1e-7;

/// How far from the reals Newton's method in R may find the solution of a regular end.
constexpr double next_to_real = 1e-9;

double uncertainty(const PathEnd& end) {
  return end.kind == PathEnd::Kind::regular ? regular_uncertainty : singular_uncertainty;
}

bool is_finite_end(const PathEnd& end) {
  return end.kind == PathEnd::Kind::regular || end.kind == PathEnd::Kind::singular;
}

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

/// The real solution next to x, if there is one.
std::optional<Figure> real_figure(const Scene& scene, const DistanceSystem& system,
                                  const std::vector<DoubleDouble>& squares, const ComplexVectorX& x,
                                  double nearby) {
  const double tolerance = real_tolerance(x, nearby);
  const std::optional<Eigen::VectorXd> start = real_part(x, tolerance);
  if (!start) return std::nullopt;
  Eigen::VectorXd real = *start;
  if (!refine(system, squares, real).converged) return std::nullopt;
  const Figure figure = system.figure(real);
  const double moved = (real - *start).cwiseAbs().maxCoeff();
  if (moved <= tolerance) return figure;
  const bool is_regular_end = nearby < singular_uncertainty;
  return is_regular_end && moved <= moved_by_rounding(scene, figure) ? std::optional(figure) : std::nullopt;
}

Figure complex_figure(const DistanceSystem& system, const ComplexVectorX& x) {
  Eigen::VectorXd real(system.unknowns()), imaginary(system.unknowns());
  for (int i = 0; i < system.unknowns(); ++i) {
    real[i] = x[i].real();
    imaginary[i] = x[i].imag();
  }
  Figure figure = system.figure(real);
  figure.imaginary = Eigen::Matrix3Xd::Zero(3, system.point_count());
  system.place(imaginary, figure.imaginary);
  for (std::size_t i = 0; i < figure.lines.size(); ++i)
    figure.imaginary_lines.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  return figure;
}

/// Whether doubles are known to lie next to different solutions, eight times further apart than the rounding
/// of each may leave it from its own, and whether each is known to be real or not to be.
bool are_told_apart(const Scene& scene, const std::array<Figure, 2>& figures) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  double uncertain = 0;
  for (const Figure& figure : figures) {
    const double stretch = std::max(1.0, extent(figure) / scene.size());
    uncertain = std::max(uncertain, 8 * rounding * jacobian_condition(scene, figure) * stretch * stretch);
    if (!figure.is_real() && figure.imaginary.cwiseAbs().maxCoeff() <= next_to_real * stretch) return false;
  }
  double apart = (figures[0].points - figures[1].points).cwiseAbs().maxCoeff();
  if (!figures[0].is_real() && !figures[1].is_real())
    apart = std::max(apart, (figures[0].imaginary - figures[1].imaginary).cwiseAbs().maxCoeff());
  return apart > uncertain * scene.size();
}

/// What there is next to an end at which two paths met, if the end is nearly real.
std::optional<FoldSolutions> fold_solutions(const DistanceSystem& system,
                                            const std::vector<DoubleDouble>& squares, const ComplexVectorX& x,
                                            WorkCounters& work) {
  const std::optional<Eigen::VectorXd> real = real_part(x, real_tolerance(x, singular_uncertainty));
  return real ? solutions_at_fold(system, squares, *real, work) : std::nullopt;
}

/// The real ones, where it is proven which solutions they are; otherwise none.
std::vector<Candidate> proven_pair(const Scene& scene, const DistanceSystem& system,
                                   const std::vector<DoubleDouble>& squares, const FoldSolutions& fold) {
  std::vector<Candidate> pair;
  for (const Eigen::VectorXd& x : fold.x) {
    const Figure figure = system.figure(x);
    pair.push_back({figure, 1, proven_error(scene, squares, figure)});
    if (!std::isfinite(pair.back().error)) return {};
  }
  return pair;
}

PathRecord record_of(const PathEnd& end) {
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

/// The finite ends, distinct, with the number of paths that end at each.
class DistinctEnds {
 public:
  DistinctEnds(const std::vector<PathEnd>& ends, std::vector<int> axes, std::mt19937_64& random)
      : set_(std::move(axes), random) {
    for (const PathEnd& end : ends) {
      if (!is_finite_end(end)) continue;
      const int number = set_.insert(end.x, uncertainty(end));
      if (number == static_cast<int>(paths_.size())) {
        paths_.push_back(0);
        singular_.push_back(false);
      }
      ++paths_[number];
      if (end.kind == PathEnd::Kind::singular) singular_[number] = true;
    }
  }

  int size() const { return set_.size(); }
  const ComplexVectorX& operator[](int i) const { return set_[i]; }
  int paths(int i) const { return paths_[i]; }
  bool is_singular(int i) const { return singular_[i]; }

  /// Regular ends at which several paths arrived.
  int jumps() const {
    int count = 0;
    for (int i = 0; i < size(); ++i) count += !singular_[i] && paths_[i] > 1;
    return count;
  }

  bool has_conjugate(int i) const {
    ComplexVectorX conjugate = set_[i];
    for (std::complex<double>& value : conjugate) value = std::conj(value);
    return set_.find(conjugate, singular_[i] ? singular_uncertainty : regular_uncertainty) >= 0;
  }

 private:
  SolutionSet set_;
  std::vector<int> paths_;
  std::vector<bool> singular_;
};

/// Of one cause.
struct LostPaths {
  int count = 0;
  double condition = 0;  ///< the largest where they were lost
};

/// What keeps the ends from being all solutions.
struct Shortcomings {
  std::map<std::string, LostPaths> lost;
  int jumps = 0;         ///< regular ends at which several paths arrived
  int lonely = 0;        ///< ends without their conjugates
  int not_isolated = 0;  ///< those of them at which the Jacobian loses rank
  int in_between = 0;    ///< singular ends that are no multiple solutions
  int too_far = 0;       ///< ends whose coordinates doubles do not hold finely enough

  /// Empty when there are none.
  std::string in_words() const {
    std::string text;
    const auto append = [&text](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
    for (const auto& [cause, paths] : lost)
      append(number_of(paths.count, "path") + " failed: " + cause + ", at condition numbers up to " +
             one_digit(paths.condition));
    if (jumps > 0)
      append("several paths ended at each of " + number_of(jumps, "regular solution") +
             ": a step has jumped");
    if (not_isolated > 0)
      append(
          "the Jacobian loses rank at " + number_of(not_isolated, "end") +
          " without a conjugate: solutions there are not isolated to working precision, as where the scene " +
          "flexes or nearly does");
    if (lonely > not_isolated)
      append("the conjugates of " + number_of(lonely - not_isolated, "solution") + " are missing");
    if (too_far > 0)
      append("the coordinates of " + number_of(too_far, "end") +
             " are so large beside the lengths that doubles do not hold the distances");
    if (in_between > 0)
      append("solutions next to " + number_of(in_between, "end") +
             " are so close together that their paths " + "were not told apart");
    return text;
  }

 private:
  static std::string one_digit(double value) {
    std::ostringstream text;
    text << std::setprecision(1) << value;
    return text.str();
  }
};

/// A condition number that leaves three digits or fewer of a correction along the Jacobian's near kernel.
constexpr double rank_lost = 1e13;

/// Below this condition number no solution is so near another that doubles do not tell them apart.
constexpr double regular = 1e4;

bool is_multiple_solution(const Scene& scene, const Figure& figure) {
  return relative_residual(scene, figure) <= double_root_residual &&
         jacobian_condition(scene, figure) >= regular;
}

}  // namespace

std::string number_of(std::int64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

SolveReport complex_report(const Scene& scene, const DistanceSystem& system, const std::vector<PathEnd>& ends,
                           const WorkCounters& work, std::mt19937_64& random) {
  SolveReport report;
  report.claim = Claim::all_complex;
  report.work = work;
  const std::vector<DoubleDouble> squares = target_squares(scene);
  const DistinctEnds distinct(ends, mirror_axes(scene, system), random);
  Shortcomings missing;
  missing.jumps = distinct.jumps();
  const auto figure_of = [&](const ComplexVectorX& x, double nearby) {
    const std::optional<Figure> real = real_figure(scene, system, squares, x, nearby);
    return real ? *real : complex_figure(system, x);
  };
  for (int i = 0; i < distinct.size(); ++i) {
    const bool is_singular = distinct.is_singular(i), is_lonely = !distinct.has_conjugate(i);
    const Figure figure = figure_of(distinct[i], is_singular ? singular_uncertainty : next_to_real);
    const bool is_not_isolated = is_lonely && jacobian_condition(scene, figure) >= rank_lost;
    bool is_in_between = is_singular && !is_not_isolated && !is_multiple_solution(scene, figure);
    missing.too_far += loses_distances(scene, figure);
    missing.lonely += is_lonely;
    missing.not_isolated += is_not_isolated;
    if (is_singular && !is_not_isolated && distinct.paths(i) == 2) {
      const auto fold = fold_solutions(system, squares, distinct[i], report.work);
      const std::vector<Candidate> pair =
          fold ? proven_pair(scene, system, squares, *fold) : std::vector<Candidate>{};
      report.candidates.insert(report.candidates.end(), pair.begin(), pair.end());
      if (!pair.empty()) continue;
      is_in_between = is_in_between || fold.has_value();
    }
    if (is_in_between && distinct.paths(i) == 2) {
      const auto pair = close_pair(system, squares, distinct[i]);
      const auto figures = pair ? std::optional(std::array{figure_of((*pair)[0], next_to_real),
                                                           figure_of((*pair)[1], next_to_real)})
                                : std::nullopt;
      if (figures && are_told_apart(scene, *figures)) {
        for (const Figure& one : *figures)
          report.candidates.push_back({one, 1, proven_error(scene, squares, one)});
        continue;
      }
    }
    report.candidates.push_back(
        {figure, is_singular ? distinct.paths(i) : 1,
         is_singular ? std::numeric_limits<double>::infinity() : proven_error(scene, squares, figure)});
    missing.in_between += is_in_between;
  }
  for (const PathEnd& end : ends) {
    if (end.kind != PathEnd::Kind::failed) continue;
    LostPaths& lost = missing.lost[end.cause];
    ++lost.count;
    const Figure where = complex_figure(system, end.x);
    if (std::isfinite(extent(where)))
      lost.condition = std::max(lost.condition, jacobian_condition(scene, where));
  }
  for (const PathEnd& end : ends) report.paths.push_back(record_of(end));
  const bool stopped = std::any_of(ends.begin(), ends.end(),
                                   [](const PathEnd& end) { return end.kind == PathEnd::Kind::stopped; });
  report.reason = stopped ? "stopped on the way" : missing.in_words();
  report.status = stopped                 ? SolveStatus::stopped
                  : report.reason.empty() ? SolveStatus::complete
                                          : SolveStatus::partial;
  return report;
}

}  // namespace gcs
