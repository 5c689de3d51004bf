/// Tracks S in full space, R^m × R ([I] §2.2, §7.1).
///
/// S is the component through the sketch of {(X, t) : |p_j − p_k| = a_i(t)}, with the lengths a_i(t) going
/// from those of the sketch (t = 0) to the given ones (t = 1) and on, one or more of them bent so that t stays
/// bounded ([I] (h2)), or none. Where the Jacobian has full rank on it ([I] (h1)) S is a closed curve; it is followed
/// through the folds of t until it is back at the sketch, and every crossing of t = 1 is a solution.
///
/// Of a general scene (lines, planes, bodies, angles, incidences) S is that of tracking/general_curve.hpp, mode=fast, certified
/// or newton. There it may go to infinity, and is then followed to both of its ends.
///
/// mode=fast is tracking/series_tracker.hpp on tracking/distance_curve.hpp, mode=paper is
/// tracking/euler_newton_tracker.hpp on tracking/paper_homotopies.hpp, mode=certified is
/// proven_paths/certified_tracker.hpp: it proves that S closes and the number and order of its crossings.
/// Baselines: until=first stops at the first solution, as [I]'s reference 11; mode=newton is Newton's method.
///
/// Claims the solutions on S, or some real ones of a baseline. Fails, and says where, when S is singular or nearly so,
/// runs off to infinite t, or is too long for max_steps. Imbach, Mathis, Schreck, A Robust and Efficient Method for
/// Solving Point Distance Problems by Homotopy, 2016.

#include "solvers/strategies/full_space.hpp"

#include "solvers/elements/general_structure.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/proven_paths/path_jumps.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/newton_from_sketch.hpp"
#include "solvers/tracking/paper_homotopies.hpp"
#include "solvers/tracking/path_options.hpp"
#include "solvers/tracking/path_report.hpp"
#include "solvers/tracking/scene_path.hpp"

namespace gcs {
namespace {

constexpr double paper_step_max = 0.1;  // [I] §7.3.1, without a plan

/// The tracker of [I] corrects until a correction is below 1e-10 in the file's unit: an accepted point is
/// this near to S, relative to the scene's size, unless S is nearly singular there.
constexpr double newton_distance = 1e-7;

class FullSpaceStrategy final : public Strategy {
 public:
  explicit FullSpaceStrategy(const FullSpace& asked)
      : mode_(asked.mode),
        options_(path_options(asked.tracking, paper_step_max)),
        names_jumps_(asked.jumps == FullSpace::Jumps::named) {
    options_.paper.keep_points = names_jumps_;
  }

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (is_path_of_elements(scene)) return why_no_general_path(in_frame_of_elements(scene));
    const bool proves = mode_ == FullSpace::Mode::certified || names_jumps_;
    return proves ? why_not_proven(scene) : why_no_path(scene);
  }

  SolveReport solve(const SolveRequest& request) override {
    const TrackerContext context{request.stop, request.monitor};
    if (is_path_of_elements(request.scene))
      return solve_general(in_frame_of_elements(request.scene), context);
    switch (mode_) {
      case FullSpace::Mode::paper:
        return solve_as_published(request.scene, for_scene(options_, request.scene).paper, context);
      case FullSpace::Mode::certified:
        return solve_with_proof(request.scene, context);
      case FullSpace::Mode::newton:
        return solve_by_newton(request.scene, context);
      case FullSpace::Mode::fast:
        break;
    }
    return follow_scene_path(request.scene, options_.fast, context);
  }

 private:
  std::optional<std::string> why_no_general_path(const Scene& scene) const {
    if (mode_ == FullSpace::Mode::paper || names_jumps_)
      return "the tracker as published is for distances between points; leave out mode=paper";
    return why_not_general(scene);
  }

  SolveReport solve_general(const Scene& scene, const TrackerContext& context) const {
    if (mode_ == FullSpace::Mode::newton) return newton_from_general_sketch(scene);
    if (mode_ == FullSpace::Mode::certified) return solve_general_with_proof(scene, context);
    return follow_general_path(scene, options_.fast, context);
  }

  SolveReport solve_as_published(const Scene& scene, const EulerNewtonOptions& options,
                                 const TrackerContext& context) const {
    PaperDistanceHomotopy homotopy(scene);
    EulerNewtonTracker tracker(homotopy, options, context);
    TrackedPath path = tracker.run();
    std::vector<Eigen::VectorXd> points = std::move(path.points);
    SolveReport report =
        path_report(scene, path, [&](const Eigen::VectorXd& y) { return homotopy.figure(y); });
    if (names_jumps_) {
      for (Eigen::VectorXd& y : points) y.head(y.size() - 1) *= std::ldexp(1.0, -scene.unit_exponent());
      name_jumps(scene, points, context, report);
    }
    return report;
  }

  static SolveReport solve_by_newton(const Scene& scene, const TrackerContext& context) {
    PaperDistanceHomotopy homotopy(scene);
    return report_of_newton(scene, newton_from_sketch(homotopy, context),
                            [&](const Eigen::VectorXd& y) { return homotopy.figure(y); });
  }

  /// A path that left S is no complete answer, however it ends.
  void name_jumps(const Scene& scene, const std::vector<Eigen::VectorXd>& points,
                  const TrackerContext& context, SolveReport& report) const {
    SeriesTrackerOptions proof;
    proof.orientation = options_.fast.orientation;
    CertifiedTracker tracker(scene, proof, context);
    tracker.keep_arcs();
    const TrackedPath path = tracker.run();
    if (!path.proven) {
      report.status = report.status == SolveStatus::complete ? SolveStatus::partial : report.status;
      report.reason += separator(report) + "jumps are not known, since S could not be proven: " + path.cause;
      return;
    }
    const std::vector<PathJump> jumps =
        find_jumps(points, tracker.arcs(), path.crossings, newton_distance * scene.size());
    report.particulars = {{"jumps", static_cast<std::int64_t>(jumps.size())}};
    if (jumps.empty()) return;
    report.status = report.status == SolveStatus::complete ? SolveStatus::partial : report.status;
    report.reason += separator(report) + in_words(jumps);
  }

  static std::string separator(const SolveReport& report) { return report.reason.empty() ? "" : "; "; }

  SolveReport solve_with_proof(const Scene& scene, const TrackerContext& context) const {
    CertifiedTracker tracker(scene, options_.fast, context);
    SolveReport report =
        path_report(scene, tracker.run(), [&](const Eigen::VectorXd& y) { return tracker.figure(y); });
    count_tubes(report);
    return report;
  }

  /// Of a path with ends at infinity what is proven is the piece between them: S may meet more solutions further out.
  SolveReport solve_general_with_proof(const Scene& scene, const TrackerContext& context) const {
    const auto by_tubes = [&](const SceneSystem&, const Eigen::VectorXd&,
                              const SeriesTrackerOptions& of_half) {
      return CertifiedTracker(scene, of_half, context).run();
    };
    SolveReport report = follow_general_path(scene, options_.fast, by_tubes);
    count_tubes(report);
    if (report.status == SolveStatus::complete && report.paths[0].end == PathRecord::End::at_infinity) {
      report.claim = Claim::some_real;
      report.reason = "S goes to infinity at both ends; its crossings are proven as far as it was followed";
    }
    return report;
  }

  static void count_tubes(SolveReport& report) {
    report.particulars.push_back({"tubes", report.work.iterations});
    report.particulars.push_back({"rejected_tubes", report.work.rejected_steps});
  }

  FullSpace::Mode mode_;
  PathOptions options_;
  bool names_jumps_;
};

}  // namespace

StrategyEntry full_space_entry() {
  StrategyEntry entry = entry_of<FullSpaceStrategy, FullSpace>();
  entry.summary = "tracks the path S from the sketch in all coordinates";
  entry.citation = "Imbach, Mathis, Schreck 2016, sections 2.2 and 7.1";
  entry.needs_sketch = true;
  entry.knows_general_scenes = true;
  entry.accuracy_settings = path_accuracy_settings();
  return entry;
}

}  // namespace gcs
