#include "solvers/subdivision/subdivision_report.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>

#include "solvers/certificates/certificate.hpp"
#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/certificates/undecided_place.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/subdivision/distinct_solutions.hpp"

namespace gcs {
namespace {

/// Of the scene's size: undecided boxes that are nearer to each other are of one place. Around a multiple
/// solution boxes of 2^-36 are undecided as far as their squares, or cubes, reach.
constexpr double one_place = 0x1p-12;

/// More places than this nobody reads.
constexpr std::size_t most_named = 5;

class Report {
 public:
  Report(const Scene& scene, const SceneEquations& equations, const SubdivisionOutcome& outcome,
         const std::stop_token& stop)
      : scene_(scene),
        equations_(equations),
        system_(equations.system()),
        points_(scene),
        outcome_(outcome),
        stop_(stop) {}

  SolveReport run() {
    DistinctSolutions distinct = distinct_solutions(outcome_.solutions, system_.mirror);
    undecided_ = std::move(distinct.undecided);
    undecided_.insert(undecided_.end(), outcome_.undecided.begin(), outcome_.undecided.end());
    if (outcome_.end == SubdivisionOutcome::End::complete) count(distinct);
    report_.claim = Claim::all_real;
    for (const ProvenSolution& solution : distinct.list) {
      report_.candidates.push_back({figure(solution.enclosure.mid), solution.multiplicity});
      if (solution.multiplicity == 1) report_.candidates.back().error = error(solution.enclosure);
    }
    are_told_apart_ = !is_counted_ || are_different_classes(scene_, report_.candidates);
    list_places();
    report_.status = status();
    report_.reason = reason();
    count_work();
    return std::move(report_);
  }

 private:
  /// Takes the solutions at the places that are decided by counting to the others, and keeps the boxes of the others.
  void count(DistinctSolutions& distinct) {
    std::vector<ProvenSolution> all = std::move(distinct.list);
    std::vector<Box> left;
    for (const UndecidedPlace& place : places()) {
      const auto counted = real_solutions_in(system_, place.hull, stop_);
      is_counted_ = is_counted_ || counted.has_value();
      if (!counted)
        for (const std::size_t box : place.members) left.push_back(undecided_[box]);
      else
        for (const auto& [box, unique, multiplicity] : *counted)
          all.push_back({box, Eigen::VectorXd::Constant(box.mid.size(), unique), multiplicity});
    }
    distinct = distinct_solutions(all, system_.mirror);
    undecided_ = std::move(left);
    undecided_.insert(undecided_.end(), distinct.undecided.begin(), distinct.undecided.end());
  }

  std::vector<UndecidedPlace> places() const {
    return undecided_places(undecided_, system_.mirror, one_place * scene_.size());
  }

  int line_count() const { return static_cast<int>(scene_.problem().lines.size()); }
  bool has_free_lines() const { return line_count() > 0 && equations_.line_unknown(0, 0, 0) >= 0; }

  Eigen::Vector3d line_part(const Eigen::VectorXd& x, int line, int part) const {
    return Eigen::Vector3d::NullaryExpr(
        [&](Eigen::Index axis) { return x[equations_.line_unknown(line, part, static_cast<int>(axis))]; });
  }

  Figure figure(const Eigen::VectorXd& x) const {
    Figure result = points_.figure(x.head(points_.unknowns()));
    if (!has_free_lines()) return result;
    result.lines.clear();
    for (int line = 0; line < line_count(); ++line)
      result.lines.push_back({line_part(x, line, 0), line_part(x, line, 1).stableNormalized()});
    return result;
  }

  /// At most the distance of a point, or of a line's point and direction (times the scene's size), from that
  /// of the solution.
  double error(const Box& enclosure) const {
    double largest = 0;
    for (int point = 0; point < scene_.point_count(); ++point) {
      double square = 0;
      for (int axis = 0; axis < scene_.dimension(); ++axis) {
        const int unknown = equations_.point_unknown(point, axis);
        const double part = unknown >= 0 ? enclosure.radius[unknown] : points_.coordinate_error(point, axis);
        square += part * part;
      }
      largest = std::max(largest, std::sqrt(square));
    }
    for (int line = 0; has_free_lines() && line < line_count(); ++line) {
      constexpr double normalising = 0x1p-50;  // of a direction whose length is 1 but for rounding
      const double turn = line_part(enclosure.radius, line, 1).norm();
      largest = std::max(
          {largest, line_part(enclosure.radius, line, 0).norm(), (2 * turn + normalising) * scene_.size()});
    }
    return largest * (1 + 0x1p-48);
  }

  /// Of each undecided place the middle of a box that satisfies the constraints best, with the number of solutions that
  /// are proven to lie together there, if one is.
  void list_places() {
    if (undecided_.empty()) return;
    const Certifier certifier(system_);
    for (const UndecidedPlace& place : places()) {
      Eigen::VectorXd best;
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t box : place.members) {
        const Eigen::VectorXd& x = undecided_[box].mid;
        const double residual = relative_residual(scene_, figure(x));
        if (best.size() == 0 || residual < least) std::tie(best, least) = std::pair(x, residual);
      }
      places_.push_back(best);
      if (least > double_root_residual) continue;
      const Certificate certificate = certifier.certify({best.begin(), best.end()});
      report_.candidates.push_back({figure(best), std::max(1, certificate.cluster)});
    }
  }

  SolveStatus status() const {
    if (outcome_.end == SubdivisionOutcome::End::stopped) return SolveStatus::stopped;
    if (outcome_.end == SubdivisionOutcome::End::complete) {
      if (undecided_.empty()) return are_told_apart_ ? SolveStatus::complete : SolveStatus::partial;
      return stop_.stop_requested() ? SolveStatus::stopped : SolveStatus::partial;
    }
    const bool is_found = std::any_of(report_.candidates.begin(), report_.candidates.end(),
                                      [](const Candidate& found) { return std::isfinite(found.error); });
    return is_found ? SolveStatus::partial : SolveStatus::gave_up;
  }

  std::string reason() const {
    std::ostringstream words;
    if (outcome_.end == SubdivisionOutcome::End::stopped) words << "stopped on request";
    if (outcome_.end == SubdivisionOutcome::End::too_many_boxes)
      words << "more boxes than max_boxes allows: " << outcome_.left << " of them left";
    if (outcome_.end == SubdivisionOutcome::End::too_many_undecided)
      words << "so many boxes are undecided that the solutions are unlikely to be isolated: " << outcome_.left
            << " boxes left";
    if (!are_told_apart_) words << too_near;
    if (undecided_.empty()) return words.str();
    if (words.tellp() > 0) words << "; ";
    words << undecided_.size() << " of the smallest boxes undecided, in " << places_.size()
          << (places_.size() == 1 ? " place" : " places") << ", around ";
    words.precision(12);
    for (std::size_t k = 0; k < std::min(places_.size(), most_named); ++k) {
      words << (k == 0 ? "(" : ", (");
      for (Eigen::Index i = 0; i < places_[k].size(); ++i) words << (i == 0 ? "" : ", ") << places_[k][i];
      words << ")";
    }
    if (places_.size() > most_named) words << " and " << places_.size() - most_named << " more";
    words << " in the unknowns of the frame: solutions there are multiple, or nearly so";
    return words.str();
  }

  void count_work() {
    const SubdivisionCounters& work = outcome_.work;
    report_.work.newton_iterations = work.newton_iterations;
    report_.work.evaluations = report_.work.jacobians = report_.work.factorisations =
        work.krawczyk_tests + work.newton_iterations;
    report_.particulars = {{"boxes", work.boxes},
                           {"bisections", work.bisections},
                           {"krawczyk_tests", work.krawczyk_tests},
                           {"linear_programs", work.linear_programs},
                           {"simplex_exchanges", work.pivots},
                           {"undecided_boxes", static_cast<std::int64_t>(undecided_.size())},
                           {"boxes_left", outcome_.left}};
  }

  const Scene& scene_;
  const SceneEquations& equations_;
  QuadraticSystem system_;
  DistanceSystem points_;
  const SubdivisionOutcome& outcome_;
  const std::stop_token& stop_;
  std::vector<Box> undecided_;
  bool is_counted_ = false;  ///< some place was decided by counting
  bool are_told_apart_ = true;
  std::vector<Eigen::VectorXd> places_;
  SolveReport report_;
};

}  // namespace

SolveReport subdivision_report(const Scene& scene, const SceneEquations& equations,
                               const SubdivisionOutcome& outcome, const std::stop_token& stop) {
  return Report(scene, equations, outcome, stop).run();
}

}  // namespace gcs
