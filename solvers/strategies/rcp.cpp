/// Tracks S in the driving parameters of a construction plan that is changed on the fly: Algorithm 1 of [I]
/// (§3, §4, §6, §7).
///
/// A plan places the points one by one as intersections of spheres. Where the constraints do not suffice, a
/// radius is a driving parameter k; as many constraints are removed from the plan and become the equations. S
/// is followed in (k, t) ∈ R^(d+1), d ≪ m. Near a boundary configuration (tangent spheres, γ ≤ α) the plan is
/// changed (Algorithms 2–4): an argument is exchanged for a new driving parameter, an earlier exchange is
/// undone, or a reference point is shifted.
///
/// Where the text of [I] cannot be followed, each with the option that follows it nevertheless
/// (as=printed: all of them):
/// - measure: γ does not see p_i1 = p_i3, nor p' = c for interCS, where the intersection is as badly determined
///   as at a tangency. The mended measure also watches the sine of the angle of intersection.
/// - shift: for interCS the printed shift, to the larger of circle radius and a_i6, can leave γ below α
///   (r = 1, a_i6 = 12: 0.083), against Proposition 2; to the circle's radius gives γ ≥ 1/√2.
/// - direction: Algorithm 4 is undefined where p_(i+1) lies on the line of the centres: a direction at a right
///   angle is taken there.
/// - restoring: the second branch of Algorithm 3 removes the driving parameter of the instruction that it
///   restores, which has none: what has to leave is the current one and its reference. As printed H_R keeps an
///   unknown without an equation, and the path ends there, with that reason.
/// - turning: the tangent is carried over a change by the derivative of ϕ'∘ϕ, where ϕ is about to have none;
///   mended, by ϕ'∘ϕ at both ends of the last step.
/// Where it is silent: the first plan is derived with the fewest driving parameters
/// (construction/derive.hpp), or given by the file; hypotheses are not asked for: mode=paper counts how often
/// (h2) to (h7) fail, and a radius that vanishes on S ends the tracking with that reason.
///
/// mode=fast is tracking/series_tracker.hpp on tracking/plan_curve.hpp: exact derivatives through the plan. A
/// step may pass a boundary configuration; γ is looked at where steps end. mode=paper is
/// tracking/euler_newton_tracker.hpp on tracking/paper_homotopies.hpp. swap=off keeps the first plan and only
/// finds the branch again (§3.4): an ablation. Baselines: until=first stops at the first solution; mode=newton
/// is Newton's method on the reduced system, as [I]'s reference 4 has it.
///
/// Of a general scene (points, lines and planes with whatever is stated between them) S is that of
/// tracking/general_curve.hpp, mode=fast, and a plan places element by element (construction/element_plan.hpp): a step's
/// equations are solved by Newton's method from where the element was, so that they need no closed form. α bounds how
/// near the surfaces of a step may come to a tangency, for any surfaces (construction/plan_blocks.hpp); exchanged is an
/// equation for a linear form. No instruction places a body that moves.
///
/// Claims the solutions on S, or some real ones of a baseline. Imbach, Mathis, Schreck, A Robust and Efficient
/// Method for Solving Point Distance Problems by Homotopy, 2016.

#include "solvers/strategies/rcp.hpp"

#include "solvers/construction/derive.hpp"
#include "solvers/construction/hypotheses.hpp"
#include "solvers/homotopies/general_start.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/tracking/general_path.hpp"
#include "solvers/tracking/newton_from_sketch.hpp"
#include "solvers/tracking/paper_homotopies.hpp"
#include "solvers/tracking/path_options.hpp"
#include "solvers/tracking/path_report.hpp"
#include "solvers/tracking/plan_curve.hpp"

namespace gcs {
namespace {

constexpr double paper_step_max = 0.05;  // [I] §7.3.1, with a plan

class RcpStrategy final : public Strategy {
 public:
  explicit RcpStrategy(const Rcp& asked)
      : mode_(asked.mode), options_(path_options(asked.tracking, paper_step_max)) {
    plan_options_.swap = asked.swap;
    plan_options_.partial = asked.derivatives == Rcp::Derivatives::partial;
    plan_options_.rule.alpha = asked.alpha;
    plan_options_.rule.watch_sine = !asked.is_printed(asked.measure);
    plan_options_.rule.shift = {asked.is_printed(asked.shift), asked.is_printed(asked.direction)};
    plan_options_.rule.restores_as_printed = asked.is_printed(asked.restoring);
    plan_options_.turns_as_printed = asked.is_printed(asked.turning);
    if (mode_ == Rcp::Mode::fast && ends_where_undefined())
      throw OptionError(
          "options as, direction, restoring, turning: only mode=paper follows the printed text");
  }

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (is_path_of_elements(scene)) return why_no_general_plan(in_frame_of_elements(scene));
    if (const auto reason = why_no_path(scene)) return reason;
    return why_no_plan(scene);
  }

  void prepare(const SolveRequest& request) override {
    if (!is_path_of_elements(request.scene)) plan_ = first_plan(request.scene, plan_options_.rule);
  }

  SolveReport solve(const SolveRequest& request) override {
    const Scene& scene = request.scene;
    const TrackerContext context{request.stop, request.monitor};
    if (is_path_of_elements(scene)) return solve_general(in_frame_of_elements(scene), context);
    const Plan plan = plan_ ? *plan_ : first_plan(scene, plan_options_.rule);
    const Figure sketch = in_plan_frame(scene, plan, *scene.sketch());
    if (mode_ == Rcp::Mode::newton) return solve_by_newton(scene, plan, sketch, context);
    const PathOptions path = for_scene(options_, scene);
    if (mode_ == Rcp::Mode::paper) return solve_as_published(scene, plan, sketch, path.paper, context);
    return report_once_refined(path.fast, [&](const SeriesTrackerOptions& options) {
      PlanCurve curve(scene, plan, sketch,
                      {options.order, options.tolerance, plan_options_.swap, plan_options_.rule});
      SeriesTracker tracker(curve, options, context);
      return report_of(scene, tracker.run(), curve);
    });
  }

 private:
  bool ends_where_undefined() const {
    return plan_options_.rule.shift.towards_projection || plan_options_.rule.restores_as_printed ||
           plan_options_.turns_as_printed;
  }

  std::optional<std::string> why_no_general_plan(const Scene& scene) const {
    if (mode_ != Rcp::Mode::fast) return "mode=paper and mode=newton are for distances between points";
    if (const auto reason = why_not_general(scene)) return reason;
    return why_no_element_plan(scene, Instructions::one_place);
  }

  SolveReport solve_general(const Scene& scene, const TrackerContext& context) const {
    const ElementPlan plan = derive_element_plan(scene, Instructions::one_place);
    return follow_general_plan(scene, plan, options_.fast,
                               {.swap = plan_options_.swap, .alpha = plan_options_.rule.alpha}, context);
  }

  SolveReport solve_as_published(const Scene& scene, const Plan& plan, const Figure& sketch,
                                 const EulerNewtonOptions& options, const TrackerContext& context) const {
    PaperPlanHomotopy homotopy(scene, plan, sketch, plan_options_);
    EulerNewtonTracker tracker(homotopy, options, context);
    SolveReport report = report_of(scene, tracker.run(), homotopy);
    const PlanChange& changes = homotopy.changes();
    const PlanHypotheses fails = check_hypotheses(scene, plan, sketch, plan_options_.rule.alpha);
    report.particulars = {{"exchanges", changes.exchanges},
                          {"restorations", changes.restorations},
                          {"shifts", changes.shifts},
                          {"shifts_in_vain", changes.shifts_in_vain},
                          {"open_sides", fails.h2},
                          {"equal_lengths", fails.h3},
                          {"vanishing_first_lengths", fails.h4},
                          {"vanishing_pairs", fails.h5},
                          {"vanishing_beside_driven", fails.h6},
                          {"near_boundary_at_sketch", fails.h7}};
    return report;
  }

  SolveReport solve_by_newton(const Scene& scene, const Plan& plan, const Figure& sketch,
                              const TrackerContext& context) const {
    PlanHomotopyOptions options = plan_options_;
    options.swap = false;
    PaperPlanHomotopy homotopy(scene, plan, sketch, options);
    return report_of_newton(scene, newton_from_sketch(homotopy, context),
                            [&](const Eigen::VectorXd& y) { return homotopy.figure(y); });
  }

  template <class Curve>
  static SolveReport report_of(const Scene& scene, const TrackedPath& path, const Curve& curve) {
    SolveReport report = path_report(scene, path, [&](const Eigen::VectorXd& y) { return curve.figure(y); });
    report.paths.front().plans = curve.plans();
    return report;
  }

  Rcp::Mode mode_;
  PathOptions options_;
  PlanHomotopyOptions plan_options_;
  std::optional<Plan> plan_;
};

}  // namespace

StrategyEntry rcp_entry() {
  StrategyEntry entry = entry_of<RcpStrategy, Rcp>();
  entry.summary =
      "tracks S in the driving parameters of a construction plan changed on the fly (Algorithm 1)";
  entry.citation = "Imbach, Mathis, Schreck 2016, Algorithms 1 to 4";
  entry.needs_sketch = true;
  entry.knows_general_scenes = true;
  entry.accuracy_settings = path_accuracy_settings();
  return entry;
}

}  // namespace gcs
