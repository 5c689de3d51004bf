#include "solvers/scanning/element_scan.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

using Vector = Eigen::Vector3d;

/// Of the last step of Newton's method, which then is past its quadratic phase.
constexpr double last_step = 1e-8;

/// normal·x = offset
struct Cut {
  Vector normal;
  double offset = 0;
};

/// Where a sphere around the origin meets its cuts: at angles what these leave open, on both sides of the cuts' common
/// line otherwise.
std::vector<Vector> on_sphere(double radius, const std::vector<Cut>& cuts,
                              const std::array<double, 2>& angles) {
  const Vector around(std::cos(angles[0]), std::sin(angles[0]), 0);
  if (cuts.empty())
    return {radius *
            Vector(std::cos(angles[1]) * around.x(), std::cos(angles[1]) * around.y(), std::sin(angles[1]))};
  const double length = cuts[0].normal.norm();
  const Vector axis = cuts[0].normal / length;
  const double along = cuts[0].offset / length;
  const double square = (radius - along) * (radius + along);
  if (!(square >= 0)) return {};
  if (cuts.size() == 1) {
    const Vector first = axis.unitOrthogonal();
    return {along * axis + std::sqrt(square) * (around.x() * first + around.y() * axis.cross(first))};
  }
  const Vector within = cuts[1].normal - cuts[1].normal.dot(axis) * axis;
  const double gap = within.norm();
  const double further = (cuts[1].offset - along * cuts[1].normal.dot(axis)) / gap;
  const double rest = square - further * further;
  if (!(rest >= 0)) return {};
  const Vector foot = along * axis + further * within / gap;
  const Vector off = std::sqrt(rest) * axis.cross(within / gap);
  return {foot + off, foot - off};
}

/// Of a step of a plan, at its own angles.
class ElementPlaces {
 public:
  explicit ElementPlaces(const Scene& scene) : problem_(scene.problem()) {}

  /// Every way to place the element in the figure.
  std::vector<Figure> of(const ElementStep& step, const Figure& figure,
                         const std::array<double, 2>& angles) const {
    std::vector<Figure> placed;
    if (problem_.is_plane(step.place))
      for (const Vector& normal : on_sphere(1, cuts_of_normal(step, figure), angles))
        with_plane(step, normal, figure, placed);
    else
      for (const Vector& position : positions(step, figure, angles))
        with_point(step, position, figure, placed);
    return placed;
  }

 private:
  /// What the step has from points, and from planes.
  std::span<const GivenFrom> from_points(const ElementStep& step) const {
    const auto end = std::ranges::find_if_not(
        step.given, [this](const GivenFrom& from) { return problem_.is_point(from.other); });
    return {step.given.begin(), end};
  }
  std::span<const GivenFrom> from_planes(const ElementStep& step) const {
    return std::span(step.given).subspan(from_points(step).size());
  }
  static Vector point(const Figure& figure, const GivenFrom& from) { return figure.points.col(from.other); }
  const PlanePosition& plane(const Figure& figure, const GivenFrom& from) const {
    return figure.planes[static_cast<std::size_t>(problem_.plane_of(from.other))];
  }

  std::vector<Vector> positions(const ElementStep& step, const Figure& figure,
                                const std::array<double, 2>& angles) const {
    if (step.is_origin) return {Vector::Zero()};
    if (from_points(step).empty()) return {where_planes_meet(step, figure)};
    const GivenFrom& first = step.given.front();
    const Vector center = point(figure, first);
    std::vector<Vector> found = on_sphere(first.value, cuts_of_point(step, figure), angles);
    for (Vector& position : found) position += center;
    return found;
  }

  Vector where_planes_meet(const ElementStep& step, const Figure& figure) const {
    Eigen::Matrix3d normals;
    Vector offsets;
    for (int i = 0; i < 3; ++i) {
      const GivenFrom& from = step.given[static_cast<std::size_t>(i)];
      normals.row(i) = plane(figure, from).normal;
      offsets[i] = plane(figure, from).offset + from.value;
    }
    return normals.partialPivLu().solve(offsets);
  }

  /// The first two, as seen from the first point's place.
  std::vector<Cut> cuts_of_point(const ElementStep& step, const Figure& figure) const {
    const Vector center = point(figure, step.given.front());
    const double radius = step.given.front().value;
    std::vector<Cut> cuts;
    for (const int axis : step.zeros) cuts.push_back({Vector::Unit(axis), -center[axis]});
    for (const GivenFrom& from : from_points(step).subspan(1)) {
      const Vector way = point(figure, from) - center;
      const double other = from.value;
      cuts.push_back({way, ((radius - other) * (radius + other) + way.squaredNorm()) / 2});
    }
    for (const GivenFrom& from : from_planes(step)) {
      const PlanePosition& beside = plane(figure, from);
      cuts.push_back({beside.normal, beside.offset + from.value - beside.normal.dot(center)});
    }
    return first_two(std::move(cuts));
  }

  std::vector<Cut> cuts_of_normal(const ElementStep& step, const Figure& figure) const {
    const GivenFrom& first = step.given.front();
    std::vector<Cut> cuts;
    for (const GivenFrom& from : from_points(step).subspan(1))
      cuts.push_back({point(figure, from) - point(figure, first), from.value - first.value});
    for (const GivenFrom& from : from_planes(step)) cuts.push_back({plane(figure, from).normal, from.value});
    return first_two(std::move(cuts));
  }

  static std::vector<Cut> first_two(std::vector<Cut> cuts) {
    if (cuts.size() > 2) cuts.erase(cuts.begin() + 2, cuts.end());
    return cuts;
  }

  static void with_point(const ElementStep& step, const Vector& position, const Figure& figure,
                         std::vector<Figure>& placed) {
    if (!position.allFinite() || (step.positive >= 0 && !(position[step.positive] > 0))) return;
    placed.push_back(figure);
    placed.back().points.col(step.place) = position;
  }
  void with_plane(const ElementStep& step, const Vector& normal, const Figure& figure,
                  std::vector<Figure>& placed) const {
    if (!normal.allFinite()) return;
    const GivenFrom& from = step.given.front();
    placed.push_back(figure);
    placed.back().planes[static_cast<std::size_t>(problem_.plane_of(step.place))] = {
        normal, normal.dot(point(figure, from)) - from.value};
  }

  const ProblemStatement& problem_;
};

class ElementScan {
 public:
  ElementScan(const SolveRequest& request, const ElementPlan& plan, const GridScan& asked)
      : request_(request),
        scene_(request.scene),
        plan_(plan),
        asked_(asked),
        places_(scene_),
        system_(scene_),
        equations_(real_equations(system_.equations())) {}

  SolveReport run() const {
    return scan_slices(
        request_, asked_, no_solutions(),
        [&](std::int64_t number) {
          GridSlice slice{no_solutions()};
          follow(0, start(), {number, slice});
          return slice;
        },
        [&](const RefinedSolutions& refined) { return one_of_each_class(refined.list()); });
  }

 private:
  /// Where a branch's first angle is, and what takes its ends.
  struct Way {
    std::int64_t number;
    GridSlice& slice;
  };

  RefinedSolutions no_solutions() const {
    return {std::vector<int>(static_cast<std::size_t>(equations_.unknowns), -1),
            same_solution * std::max(1.0, scene_.size())};
  }

  Figure start() const {
    Figure figure;
    figure.points = Eigen::Matrix3Xd::Zero(3, scene_.point_count());
    figure.planes.resize(scene_.problem().planes.size());
    for (int p = 0; p < scene_.point_count(); ++p)
      if (const auto position = scene_.fixed_point(p)) figure.points.col(p) = *position;
    return figure;
  }

  void follow(std::size_t k, const Figure& figure, const Way& way) const {
    if (k == plan_.steps.size()) return refine_coarse(figure, way.slice);
    const ElementStep& step = plan_.steps[k];
    const auto first = static_cast<std::size_t>(step.first_angle);
    const auto place = [&](const std::array<double, 2>& angles) {
      for (const Figure& placed : places_.of(step, figure, angles)) follow(k + 1, placed, way);
    };
    if (step.angles == 0) return place({});
    over(first, way, [&](double angle) {
      if (step.angles == 1) return place({angle, 0});
      over(first + 1, way, [&](double other) { place({angle, other}); });
    });
  }

  template <class Call>
  void over(std::size_t angle, const Way& way, const Call& call) const {
    const AngleGrid& grid = asked_.angles[angle];
    if (angle == 0) return call(grid.at(way.number));
    for (std::int64_t i = 0; i < grid.count && !request_.stop.stop_requested(); ++i) call(grid.at(i));
  }

  bool is_in_band(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd jacobian(equations_.count(), equations_.unknowns);
    equations_.jacobian(x, jacobian);
    const Eigen::VectorXd f = equations_.sums(x) - equations_.given;
    return (f.array().abs() <= asked_.delta * jacobian.rowwise().norm().array()).all();
  }

  void refine_coarse(const Figure& figure, GridSlice& slice) const {
    Eigen::VectorXd x = real_parts(system_.coordinates_as_drawn(scene_.in_frame(figure)));
    if (!is_in_band(x)) return;
    ++slice.coarse;
    const Refinement refinement = refine(equations_, last_step, x);
    slice.newton_iterations += refinement.iterations;
    if (refinement.converged)
      slice.refined.take(x);
    else
      ++slice.diverged;
  }

  std::vector<Candidate> one_of_each_class(const std::vector<Eigen::VectorXd>& ends) const {
    std::vector<Figure> figures;
    std::vector<SolutionAccuracy> accuracies;
    for (const Eigen::VectorXd& x : ends) {
      const Figure figure = scene_.representative(system_.figure(ComplexValues(x.begin(), x.end()), true));
      if (relative_residual(scene_, figure) > double_root_residual) continue;
      figures.push_back(figure);
      accuracies.push_back({jacobian_condition(scene_, figure)});
    }
    std::vector<Candidate> candidates;
    for (const int first : solution_classes(scene_, figures, accuracies).first)
      candidates.push_back({figures[static_cast<std::size_t>(first)]});
    return candidates;
  }

  const SolveRequest& request_;
  const Scene& scene_;
  const ElementPlan& plan_;
  const GridScan& asked_;
  ElementPlaces places_;
  SceneSystem system_;
  RealEquations equations_;
};

}  // namespace

SolveReport element_scan(const SolveRequest& request, const ElementPlan& plan, const GridScan& asked) {
  return ElementScan(request, plan, asked).run();
}

}  // namespace gcs
