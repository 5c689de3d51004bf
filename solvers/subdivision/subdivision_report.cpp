#include "solvers/subdivision/subdivision_report.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>

#include "solvers/certificates/certificate.hpp"
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
  Report(const Scene& scene, const SceneEquations& equations, const SubdivisionOutcome& outcome)
      : scene_(scene),
        equations_(equations),
        points_(scene),
        outcome_(outcome),
        mirror_(equations.system().mirror),
        signs_(mirror_signs(mirror_)) {}

  SolveReport run() {
    const DistinctSolutions distinct = distinct_solutions(outcome_.solutions, mirror_);
    report_.claim = Claim::all_real;
    for (const ProvenSolution& solution : distinct.list)
      report_.candidates.push_back({figure(solution.enclosure.mid), 1, error(solution.enclosure)});
    for (const IntervalBox& box : outcome_.undecided) add_undecided(middle(box));
    for (const Box& box : distinct.undecided) add_undecided(box.mid);
    list_places();
    const std::size_t undecided = outcome_.undecided.size() + distinct.undecided.size();
    report_.status = status(undecided);
    report_.reason = reason(undecided);
    count_work(undecided);
    return std::move(report_);
  }

 private:
  static Eigen::VectorXd middle(const IntervalBox& box) {
    Eigen::VectorXd x(static_cast<Eigen::Index>(box.size()));
    for (std::size_t i = 0; i < box.size(); ++i) x[static_cast<Eigen::Index>(i)] = box[i].middle();
    return x;
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

  /// Where boxes are undecided: of their middles the one that satisfies the constraints best.
  struct Place {
    Eigen::VectorXd x;
    double residual = 0;
  };

  bool is_near(const Eigen::VectorXd& x, const Place& place) const {
    return std::any_of(signs_.begin(), signs_.end(), [&](const Eigen::VectorXd& sign) {
      return (x.cwiseProduct(sign) - place.x).cwiseAbs().maxCoeff() <= one_place * scene_.size();
    });
  }

  void add_undecided(const Eigen::VectorXd& x) {
    const Place here{x, relative_residual(scene_, figure(x))};
    const auto known =
        std::find_if(places_.begin(), places_.end(), [&](const Place& place) { return is_near(x, place); });
    if (known == places_.end())
      places_.push_back(here);
    else if (here.residual < known->residual)
      *known = here;
  }

  /// With the number of solutions that are proven to lie together there, if one is.
  void list_places() {
    if (places_.empty()) return;
    const Certifier certifier(equations_.system());
    for (const auto& [x, residual] : places_) {
      if (residual > double_root_residual) continue;
      const Certificate certificate = certifier.certify({x.begin(), x.end()});
      report_.candidates.push_back({figure(x), std::max(1, certificate.cluster)});
    }
  }

  SolveStatus status(std::size_t undecided) const {
    if (outcome_.end == SubdivisionOutcome::End::stopped) return SolveStatus::stopped;
    if (outcome_.end == SubdivisionOutcome::End::complete)
      return undecided == 0 ? SolveStatus::complete : SolveStatus::partial;
    const bool is_found = std::any_of(report_.candidates.begin(), report_.candidates.end(),
                                      [](const Candidate& found) { return std::isfinite(found.error); });
    return is_found ? SolveStatus::partial : SolveStatus::gave_up;
  }

  std::string reason(std::size_t undecided) const {
    std::ostringstream words;
    if (outcome_.end == SubdivisionOutcome::End::stopped) words << "stopped on request";
    if (outcome_.end == SubdivisionOutcome::End::too_many_boxes)
      words << "more boxes than max_boxes allows: " << outcome_.left << " of them left";
    if (outcome_.end == SubdivisionOutcome::End::too_many_undecided)
      words << "so many boxes are undecided that the solutions are unlikely to be isolated: " << outcome_.left
            << " boxes left";
    if (undecided == 0) return words.str();
    if (words.tellp() > 0) words << "; ";
    words << undecided << " of the smallest boxes undecided, in " << places_.size()
          << (places_.size() == 1 ? " place" : " places") << ", around ";
    words.precision(12);
    for (std::size_t k = 0; k < std::min(places_.size(), most_named); ++k) {
      words << (k == 0 ? "(" : ", (");
      for (Eigen::Index i = 0; i < places_[k].x.size(); ++i) words << (i == 0 ? "" : ", ") << places_[k].x[i];
      words << ")";
    }
    if (places_.size() > most_named) words << " and " << places_.size() - most_named << " more";
    words << " in the unknowns of the frame: solutions there are multiple, or nearly so";
    return words.str();
  }

  void count_work(std::size_t undecided) {
    const SubdivisionCounters& work = outcome_.work;
    report_.work.newton_iterations = work.newton_iterations;
    report_.work.evaluations = report_.work.jacobians = report_.work.factorisations =
        work.krawczyk_tests + work.newton_iterations;
    report_.particulars = {{"boxes", work.boxes},
                           {"bisections", work.bisections},
                           {"krawczyk_tests", work.krawczyk_tests},
                           {"linear_programs", work.linear_programs},
                           {"simplex_exchanges", work.pivots},
                           {"undecided_boxes", static_cast<std::int64_t>(undecided)},
                           {"boxes_left", outcome_.left}};
  }

  const Scene& scene_;
  const SceneEquations& equations_;
  DistanceSystem points_;
  const SubdivisionOutcome& outcome_;
  SignMasks mirror_;
  std::vector<Eigen::VectorXd> signs_;
  std::vector<Place> places_;
  SolveReport report_;
};

}  // namespace

SolveReport subdivision_report(const Scene& scene, const SceneEquations& equations,
                               const SubdivisionOutcome& outcome) {
  return Report(scene, equations, outcome).run();
}

}  // namespace gcs
