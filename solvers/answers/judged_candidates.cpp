#include "solvers/answers/judged_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "solvers/answers/settled_figure.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// Up to this, a solution for residuals in doubles is one to 1e-13 or so.
constexpr double ill_condition = 1e2;

bool is_finite(const LinePosition& line) { return line.point.allFinite() && line.direction.allFinite(); }
bool is_finite(const PlanePosition& plane) { return plane.normal.allFinite() && std::isfinite(plane.offset); }

/// Up to motions, complex figures are compared with one line at most.
bool is_usable_as_complex(const Scene& scene, const Figure& figure) {
  if (figure.imaginary.cols() != scene.point_count() || figure.imaginary_lines.size() != figure.lines.size())
    return false;
  if (figure.imaginary_planes.size() != figure.planes.size()) return false;
  if (!scene.problem().is_general() && !scene.is_anchored() && figure.lines.size() > 1) return false;
  const Figure framed = scene.in_frame(figure);
  return framed.points.allFinite() && framed.imaginary.allFinite() &&
         std::isfinite(extent(scene.representative(figure)));
}

bool is_usable(const Scene& scene, const Candidate& candidate) {
  const Figure& figure = candidate.figure;
  return figure.points.cols() == scene.point_count() && figure.lines.size() == scene.problem().lines.size() &&
         figure.planes.size() == scene.problem().planes.size() && figure.points.allFinite() &&
         std::ranges::all_of(figure.lines, [](const LinePosition& line) { return is_finite(line); }) &&
         std::ranges::all_of(figure.planes, [](const PlanePosition& plane) { return is_finite(plane); }) &&
         (figure.is_real() || is_usable_as_complex(scene, figure)) && candidate.multiplicity >= 1;
}

std::vector<Figure> representatives(const std::vector<Judged>& judged) {
  std::vector<Figure> figures;
  for (const Judged& j : judged) figures.push_back(j.representative);
  return figures;
}

std::vector<int> classify(const Scene& scene, const std::vector<Judged>& judged) {
  std::vector<SolutionAccuracy> accuracies;
  for (const Judged& candidate : judged) accuracies.push_back({candidate.condition, candidate.error});
  return solution_classes(scene, representatives(judged), accuracies).class_of;
}

/// Appends the coordinates in units of `grain` of the scene's size, cut to integers so that rounding does not
/// decide an order. The offset keeps the cuts away from round numbers such as the frame's zeros.
void append_cut(const Scene& scene, const Figure& figure, double grain, std::vector<double>& key) {
  const auto append = [&](const Eigen::Vector3d& v, double unit) {
    for (const double x : v) key.push_back(std::floor(x / unit + 0.6180339887));
  };
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) append(figure.points.col(i), grain * scene.size());
  for (Eigen::Index i = 0; i < figure.imaginary.cols(); ++i)
    append(figure.imaginary.col(i), grain * scene.size());
  for (const auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (const LinePosition& line : *lines) {
      append(line.point, grain * scene.size());
      append(line.direction, grain);
    }
  for (const auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (const PlanePosition& plane : *planes) {
      append(plane.normal, grain);
      append(Eigen::Vector3d(plane.offset, 0, 0), grain * scene.size());
    }
}

/// What solutions are sorted by, real ones first, as they stand to what is stated; the finer cut tells neighbours apart.
std::vector<double> order_key(const Scene& scene, const Judged& judged) {
  const Figure& figure = judged.representative;
  std::vector<double> key{figure.is_real() ? 0.0 : 1.0, static_cast<double>(judged.signs.standing)};
  for (const double grain : {1e-7, 1e-10}) append_cut(scene, figure, grain, key);
  return key;
}

/// Of a real figure, whose coordinates are as good as merging takes them to be, or as is proven.
SignVerdict signs_of(const Scene& scene, const std::vector<StatedSign>& signs, const Judged& judged) {
  if (signs.empty() || !judged.figure.is_real()) return {};
  const double reach = std::max(scene.size(), extent(judged.representative));
  const double error = std::min(judged.error, merging_tolerance(judged.condition) * reach);
  return verdict_on(signs, judged.representative, error);
}

/// Judges one candidate at a time, on any thread.
class CandidateJudge {
 public:
  CandidateJudge(const Scene& scene, const FigureJudge& judge) : scene_(scene), judge_(judge) {}

  std::optional<Judged> judged(const Candidate& candidate) const {
    if (!is_usable(scene_, candidate)) return std::nullopt;
    Judged judged{scene_.in_frame(candidate.figure), scene_.representative(candidate.figure), 0,
                  candidate.multiplicity, candidate.error};
    judged.condition = judge_.condition(judged.representative);
    settle(judged);
    judged.signs = signs_of(scene_, signs_, judged);
    return judged;
  }

 private:
  /// Of general scenes: their strategies take residuals in doubles.
  void settle(Judged& judged) const {
    const bool is_ill = judged.condition > ill_condition && judged.condition < singular_condition;
    if (!is_ill || judged.multiplicity > 1 || std::isfinite(judged.error)) return;
    if (!scene_.problem().is_general()) return;
    std::call_once(is_set_up_, [&] { settler_.emplace(scene_); });
    judged.figure = settler_->settled(judged.figure);
    judged.representative = scene_.representative(judged.figure);
  }

  const Scene& scene_;
  const FigureJudge& judge_;
  const std::vector<StatedSign> signs_ = stated_signs(scene_.problem());
  mutable std::once_flag is_set_up_;
  mutable std::optional<FigureSettler> settler_;  ///< where it is needed
};

/// Multiplicity of a class: the largest that was reported for a member.
AssessedSolution solution_of_class(const FigureJudge& judge, const Judged& first, int multiplicity,
                                   const std::shared_ptr<const FileTerms>& terms) {
  AssessedSolution solution;
  solution.terms = terms;
  solution.figure = first.representative;
  solution.multiplicity = multiplicity;
  solution.residual = judge.residual(first.representative);
  solution.condition = first.condition;
  solution.signs = first.signs;
  return solution;
}

}  // namespace

std::vector<std::optional<Judged>> judged_candidates(const Scene& scene, const FigureJudge& judge,
                                                     const std::vector<Candidate>& candidates, int threads) {
  const CandidateJudge of_candidates(scene, judge);
  std::vector<std::optional<Judged>> judged(candidates.size());
  share_on_threads(candidates.size(), threads,
                   [&](std::size_t i) { judged[i] = of_candidates.judged(candidates[i]); });
  return judged;
}

ListedSolutions list_solutions(const Scene& scene, const FigureJudge& judge,
                               const std::vector<Judged>& judged, int threads) {
  const std::vector<int> class_of = classify(scene, judged);
  std::vector<int> first;
  std::vector<int> multiplicity(judged.size(), 0);  // by class
  for (int i = 0; i < static_cast<int>(judged.size()); ++i) {
    if (multiplicity[class_of[i]] == 0) first.push_back(i);
    multiplicity[class_of[i]] = std::max(multiplicity[class_of[i]], judged[i].multiplicity);
  }
  std::vector<std::pair<std::vector<double>, int>> order(first.size());
  share_on_threads(first.size(), threads, [&](std::size_t i) {
    order[i] = {order_key(scene, judged[first[i]]), first[i]};
  });
  std::sort(order.begin(), order.end());

  const auto terms = file_terms(scene);
  ListedSolutions listed;
  listed.solutions.resize(order.size());
  share_on_threads(order.size(), threads, [&](std::size_t i) {
    const int of = order[i].second;
    listed.solutions[i] = solution_of_class(judge, judged[of], multiplicity[class_of[of]], terms);
  });
  std::vector<int> solution_of_class_index(judged.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i)
    solution_of_class_index[class_of[order[i].second]] = static_cast<int>(i);
  for (const int c : class_of) listed.solution_of.push_back(solution_of_class_index[c]);
  return listed;
}

}  // namespace gcs
