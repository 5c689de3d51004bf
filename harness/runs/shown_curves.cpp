#include "harness/runs/shown_curves.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/answers/path_ends.hpp"
#include "solvers/elements/general_structure.hpp"
#include "solvers/motions/apparent_motion.hpp"
#include "solvers/motions/motion_finder.hpp"

namespace gcs {
namespace {

constexpr std::size_t most_figures_of_motion = 200, most_figures_of_edge = 12;

/// As many as these at most, at equal numbers, both ends among them.
std::vector<Figure> thinned(const std::vector<Figure>& figures, std::size_t most) {
  if (figures.size() <= most) return figures;
  std::vector<Figure> result;
  for (std::size_t i = 0; i < most; ++i) result.push_back(figures[i * (figures.size() - 1) / (most - 1)]);
  return result;
}

/// To a hundred-thousandth of the scene's size, in short decimals: nobody sees more of what moves.
Figure rounded(const Scene& scene, Figure figure) {
  const double size = std::ldexp(scene.size(), scene.unit_exponent());
  const double inverse = std::pow(10, 5 - std::ceil(std::log10(size)));
  const auto round_all = [&](auto&& numbers) {
    for (double& number : numbers) number = std::round(number * inverse) / inverse;
  };
  if (!std::isfinite(inverse) || inverse == 0) return figure;
  round_all(figure.points.reshaped());
  return figure;
}

std::vector<Figure> shown_figures(const Scene& scene, const std::vector<Figure>& figures, std::size_t most) {
  std::vector<Figure> result = thinned(figures, most);
  for (Figure& figure : result) figure = rounded(scene, std::move(figure));
  return result;
}

SolveRun solved_again(const CellRecord& cell, const OptionMap& changed, const Scene& scene, double limit_s,
                      Monitor& progress) {
  OptionMap options = cell.spec.given;
  for (const auto& [name, value] : changed) options[name] = value;
  RunLimits limits;
  limits.time_limit_s = limit_s;
  return run_strategy(find_strategy(cell.spec.strategy), options, scene, limits, {&progress, nullptr});
}

// ---- motions

bool moves(const CellRecord& cell) {
  return cell.status == RunStatus::infinite || cell.reason.find(seems_to_move_words) != std::string::npos;
}

std::string motion_label(const ProblemStatement& problem, const Motion& motion) {
  const std::string why = motion.is_proven ? "where " + place_in_words(problem, motion) + ", proven"
                                           : "it seems to move, not proven";
  return why + "; " + std::string(word(motion.curve.end));
}

std::vector<ShownCurve> motions_of(const SolveRun& run, const Scene& scene) {
  std::vector<ShownCurve> curves;
  for (const Motion& motion : run.motions)
    if (motion.curve.figures.size() > 1)
      curves.push_back({motion_label(scene.problem(), motion),
                        "",
                        {},
                        {},
                        shown_figures(scene, motion.curve.figures, most_figures_of_motion)});
  return curves;
}

// ---- the graph

/// Moved and perhaps mirrored so that the first figure lies on another that it is congruent to: by least squares.
void align(std::vector<Figure>& figures, const Figure& with) {
  const Eigen::Vector3d from = figures.front().points.rowwise().mean(), to = with.points.rowwise().mean();
  const Eigen::Matrix3d product =
      (with.points.colwise() - to) * (figures.front().points.colwise() - from).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
  for (Figure& figure : figures) {
    const Eigen::Matrix3Xd points = turn * (figure.points.colwise() - from);
    figure.points = points.colwise() + to;
  }
}

/// The figures from one place to the next, the last before the first where a closed curve goes on; a mirror image of its
/// start, which it may end at, is the start again.
std::vector<Figure> stretch(const AssessedCurve& curve, std::size_t from, std::size_t to) {
  const std::size_t last = curve.figures.size() - 1;
  if (from == last) from = 0;
  if (to == 0) to = last;
  if (to <= from) return {};
  return {curve.figures.begin() + static_cast<std::ptrdiff_t>(from),
          curve.figures.begin() + static_cast<std::ptrdiff_t>(to) + 1};
}

class ShownGraph {
 public:
  ShownGraph(const Scene& scene, const ShownScene& record, const SolveRun& run)
      : scene_(scene), record_(record) {
    for (const AssessedSolution& solution : run.solutions)
      shown_as_.push_back(solution.is_real() ? nearest_solution(scene, solution.placement(), record.solutions)
                                             : std::nullopt);
    for (const AssessedCurve& curve : run.curves) take(curve);
    if (edges_.size() > most_shown_edges) edges_ = forest();
    for (ShownCurve& edge : edges_) put_in_place(edge);
  }

  std::vector<ShownCurve> edges() && { return std::move(edges_); }

 private:
  void take(const AssessedCurve& curve) {
    const std::size_t count = curve.places.size();
    const bool is_closed = curve.end == PathRecord::End::closed;
    if (count != curve.crossings.size()) return;
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const std::optional<int> from = shown(curve.crossings[i]), to = shown(curve.crossings[next]);
      std::vector<Figure> figures = stretch(curve, curve.places[i], curve.places[next]);
      if (!from || !to || figures.size() < 2) continue;
      const std::string id = id_of_value(scene_.problem(), curve.released);
      edges_.push_back({"without " + id, id, from, to, thinned(figures, most_figures_of_edge)});
    }
  }

  std::optional<int> shown(const AssessedCrossing& crossing) const {
    if (!crossing.solution) return std::nullopt;
    const auto& met = shown_as_[static_cast<std::size_t>(*crossing.solution)];
    return met ? std::optional(met->solution) : std::nullopt;
  }

  /// Breadth first, each tree from its lowest solution.
  std::vector<ShownCurve> forest() {
    std::vector<ShownCurve> result;
    std::set<int> reached;
    for (int root = 0; root < static_cast<int>(record_.solutions.size()); ++root) {
      if (!reached.insert(root).second) continue;
      std::vector<int> queue{root};
      for (std::size_t k = 0; k < queue.size(); ++k)
        for (ShownCurve& edge : edges_) {
          const bool forward = edge.from == queue[k];
          if (!forward && edge.to != queue[k]) continue;
          const int other = forward ? *edge.to : *edge.from;
          if (!reached.insert(other).second) continue;
          if (!forward) {
            std::swap(edge.from, edge.to);
            std::ranges::reverse(edge.figures);
          }
          queue.push_back(other);
          result.push_back(edge);
        }
    }
    return result;
  }

  void put_in_place(ShownCurve& edge) const {
    const ProblemStatement& problem = scene_.problem();
    if (problem.lines.empty() && problem.planes.empty() && problem.bodies.empty())
      align(edge.figures, record_.solutions[static_cast<std::size_t>(*edge.from)].figure);
    edge.figures = shown_figures(scene_, edge.figures, most_figures_of_edge);
  }

  const Scene& scene_;
  const ShownScene& record_;
  std::vector<std::optional<MetSolution>> shown_as_;  ///< of the run's solutions
  std::vector<ShownCurve> edges_;
};

}  // namespace

std::optional<MetSolution> nearest_solution(const Scene& scene, const Figure& figure,
                                            const std::vector<ShownSolution>& solutions) {
  const std::vector<AxisSigns> images = mirror_images(scene);
  double nearest = same_place * std::ldexp(scene.size(), scene.unit_exponent());
  std::optional<MetSolution> result;
  for (std::size_t i = 0; i < solutions.size(); ++i)
    for (const AxisSigns& signs : images) {
      const double distance = largest_distance(figure, solutions[i].figure, signs, 1);
      if (distance >= nearest) continue;
      nearest = distance;
      result = {static_cast<int>(i), signs};
    }
  return result;
}

std::vector<ShownCurve> curves_to_show(const Scene& scene, const RunFile& run, const ShownScene& record,
                                       double limit_s, Monitor& progress) {
  const auto first_cell = [&](auto fits) -> const CellRecord* {
    const auto found = std::ranges::find_if(run.cells, [&](const CellRecord& cell) {
      return cell.spec.instance == record.instance.id && cell.spec.digits == 0 && fits(cell);
    });
    return found == run.cells.end() ? nullptr : &*found;
  };
  std::vector<ShownCurve> curves;
  if (const CellRecord* moving = first_cell(moves))
    curves = motions_of(solved_again(*moving, {}, scene, limit_s, progress), scene);
  const auto explores = [](const CellRecord& cell) { return cell.spec.strategy == "explore"; };
  if (const CellRecord* exploring = first_cell(explores)) {
    const OptionMap sampled{{"mode", "fast"}, {"samples", "4"}};
    std::vector<ShownCurve> edges =
        ShownGraph(scene, record, solved_again(*exploring, sampled, scene, limit_s, progress)).edges();
    curves.insert(curves.end(), edges.begin(), edges.end());
  }
  return curves;
}

}  // namespace gcs
