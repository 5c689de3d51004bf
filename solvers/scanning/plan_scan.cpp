#include "solvers/scanning/plan_scan.hpp"

#include "solvers/certificates/box_search.hpp"
#include "solvers/model/distance_equations.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/scanning/cell_scan.hpp"
#include "solvers/scanning/step_pieces.hpp"

namespace gcs {
namespace {

/// A plan of points with given distances.
template <int N>
class PointStage {
 public:
  using Positions = std::vector<FormVector<N>>;

  PointStage(const Scene& scene, const ScanPlan& plan)
      : scene_(scene),
        plan_(plan),
        system_(scene_, plan.frame),
        squares_(target_squares(scene_)),
        pieces_(squares_, plan.angles()) {}

  std::size_t steps() const { return plan_.steps.size(); }
  const std::vector<std::array<double, 2>>& ranges() const { return plan_.ranges; }
  double size() const { return scene_.size(); }

  Positions start() const {
    Positions points(static_cast<std::size_t>(scene_.point_count()));
    for (int p = 0; p < scene_.point_count(); ++p)
      if (const auto position = scene_.fixed_point(p))
        for (int axis = 0; axis < 3; ++axis) {
          points[p][axis].mid = (*position)[axis];
          points[p][axis].rest = system_.coordinate_error(p, axis);
        }
    return points;
  }

  Pieces<N> pieces(std::size_t k, const Positions& points, const Cell<N>& cell,
                   const std::optional<Choice>& within) const {
    return pieces_.of(plan_.steps[k], points, cell, within);
  }

  bool put(std::size_t k, const Piece<N>& piece, Positions& points, Narrowing<N>& narrowing) const {
    const ScanStep& step = plan_.steps[k];
    for (const ScanSphere& check : step.checks)
      if (!narrowing.by_zero(square(piece.position - points[check.center]) -
                             pieces_.square_of(check.constraint)))
        return false;
    points[step.place] = piece.position;
    return true;
  }

  Box box(const Positions& points) const {
    Box box{Eigen::VectorXd(system_.unknowns()), Eigen::VectorXd(system_.unknowns())};
    for (int p = 0; p < scene_.point_count(); ++p)
      for (int axis = 0; axis < scene_.dimension(); ++axis) {
        const int i = system_.unknown(p, axis);
        if (i < 0) continue;
        box.mid[i] = points[p][axis].mid;
        box.radius[i] = radius_about_middle(points[p][axis]);
      }
    return box;
  }

  QuadraticSystem equations() const { return distance_equations(scene_, system_); }
  BoxContent content(const Box& box) const { return krawczyk(system_, squares_, box); }

  bool refine(Eigen::VectorXd& x, std::int64_t& iterations) const {
    const Refinement refinement = gcs::refine(system_, squares_, x);
    iterations += refinement.iterations;
    return refinement.converged;
  }

  std::optional<std::vector<Box>> solutions_in(const Box& box) const {
    constexpr int most_parts = 5000;  // tens of milliseconds
    return gcs::solutions_in(system_, squares_, box, most_parts);
  }

  std::optional<Box> image_near(const Box& box, const Box& known) const {
    const Eigen::VectorXd apart = (known.mid - box.mid).cwiseAbs() * (1 + 4 * AffineForm<N>::epsilon);
    if ((apart.array() > (known.radius + box.radius).array()).any()) return std::nullopt;
    return box;
  }

  Figure figure(const Eigen::VectorXd& x) const { return system_.figure(x); }

  ScanSolution solution(const Box& box) const {
    return {figure(box.mid), 1, std::sqrt(3.0) * box.radius.maxCoeff() * (1 + 4 * AffineForm<N>::epsilon)};
  }

 private:
  const Scene& scene_;
  const ScanPlan& plan_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  StepPieces<N> pieces_;
};

template <int N>
ScanOutcome scanned(const SolveRequest& request, const ScanPlan& plan, std::int64_t max_cells) {
  return CellScan<N, PointStage<N>>(request, PointStage<N>(request.scene, plan), max_cells).run();
}

}  // namespace

ScanOutcome scan_plan(const SolveRequest& request, const ScanPlan& plan, std::int64_t max_cells) {
  const int symbols = plan.angles() + (request.scene.has_lines() ? 1 : 0);
  if (symbols <= 1) return scanned<1>(request, plan, max_cells);
  if (symbols == 2) return scanned<2>(request, plan, max_cells);
  return scanned<3>(request, plan, max_cells);
}

}  // namespace gcs
