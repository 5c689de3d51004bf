#include "solvers/answers/judged_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "solvers/answers/settled_figure.hpp"
#include "solvers/figures/point_conditions.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

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

std::vector<Figure> take_representatives(std::vector<Judged>& judged) {
  std::vector<Figure> figures;
  figures.reserve(judged.size());
  for (Judged& j : judged) figures.push_back(std::move(j.representative));
  return figures;
}

ReflectionClasses classify(const Scene& scene, const std::vector<Judged>& judged,
                           const std::vector<Figure>& figures, int threads) {
  std::vector<SolutionAccuracy> accuracies;
  for (const Judged& candidate : judged) accuracies.push_back({candidate.condition, candidate.error});
  return solution_classes(scene, figures, accuracies, threads);
}

/// How two figures with as many elements stand to each other by their coordinates in units of `grain` of the scene's
/// size, cut to integers so that rounding does not decide an order: < 0, 0 or > 0 for the first that differs. The offset
/// keeps the cuts away from round numbers such as the frame's zeros.
class CutOrder {
 public:
  CutOrder(double size, double grain) : length_(grain * size), direction_(grain) {}

  int of(const Figure& a, const Figure& b) const {
    if (const int order = of_columns(a.points, b.points)) return order;
    if (const int order = of_columns(a.imaginary, b.imaginary)) return order;
    if (const int order = of_each(a.lines, b.lines)) return order;
    if (const int order = of_each(a.imaginary_lines, b.imaginary_lines)) return order;
    if (const int order = of_each(a.planes, b.planes)) return order;
    return of_each(a.imaginary_planes, b.imaginary_planes);
  }

 private:
  static int of_number(double a, double b, double unit) {
    constexpr double offset = 0.6180339887;
    if (a == b) return 0;  // as all that the frame fixes is
    const double cut_a = std::floor(a / unit + offset), cut_b = std::floor(b / unit + offset);
    return (cut_a > cut_b) - (cut_a < cut_b);
  }
  static int of_vector(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double unit) {
    for (int axis = 0; axis < 3; ++axis)
      if (const int order = of_number(a[axis], b[axis], unit)) return order;
    return 0;
  }
  int of_columns(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) const {
    for (Eigen::Index i = 0; i < a.cols(); ++i)
      if (const int order = of_vector(a.col(i), b.col(i), length_)) return order;
    return 0;
  }
  int of_one(const LinePosition& a, const LinePosition& b) const {
    const int order = of_vector(a.point, b.point, length_);
    return order != 0 ? order : of_vector(a.direction, b.direction, direction_);
  }
  int of_one(const PlanePosition& a, const PlanePosition& b) const {
    const int order = of_vector(a.normal, b.normal, direction_);
    return order != 0 ? order : of_number(a.offset, b.offset, length_);
  }
  template <class Elements>
  int of_each(const Elements& a, const Elements& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (const int order = of_one(a[i], b[i])) return order;
    return 0;
  }

  double length_, direction_;
};

/// Whether a solution comes first: real ones do, then by how they stand to what is stated; the finer cut tells neighbours
/// apart.
bool comes_first(double size, const Figure& a, const SignVerdict& signs_of_a, const Figure& b,
                 const SignVerdict& signs_of_b) {
  if (a.is_real() != b.is_real()) return a.is_real();
  if (signs_of_a.standing != signs_of_b.standing) return signs_of_a.standing < signs_of_b.standing;
  for (const double grain : {1e-7, 1e-10})
    if (const int order = CutOrder(size, grain).of(a, b)) return order < 0;
  return false;
}

/// Of a real figure, whose coordinates are as good as merging takes them to be, or as is proven.
SignVerdict signs_of(const Scene& scene, const std::vector<StatedSign>& signs, const Judged& judged,
                     const Figure& representative) {
  if (signs.empty() || !representative.is_real()) return {};
  const double reach = std::max(scene.size(), extent(representative));
  const double error = std::min(judged.error, merging_tolerance(judged.condition) * reach);
  return verdict_on(signs, representative, error);
}

/// By proven errors where their condition numbers alone take some for the same.
std::vector<int> classes_told_apart(const Scene& scene, const std::vector<Figure>& figures,
                                    const ErrorsOf& errors_of, int threads, std::vector<Judged>& judged) {
  ReflectionClasses classes = classify(scene, judged, figures, threads);
  if (classes.count() == static_cast<int>(judged.size()) || !errors_of) return classes.class_of;
  const std::vector<double> errors = errors_of(figures);
  if (errors.empty()) return classes.class_of;
  const std::vector<StatedSign> signs = stated_signs(scene.problem());
  for (std::size_t i = 0; i < judged.size(); ++i) {
    judged[i].error = std::min(judged[i].error, errors[i]);
    judged[i].signs = signs_of(scene, signs, judged[i], figures[i]);
  }
  return classify(scene, judged, figures, threads).class_of;
}

/// Judges some candidates at a time, on any thread.
class CandidateJudge {
 public:
  CandidateJudge(const Scene& scene, const FigureJudge& judge) : scene_(scene), judge_(judge) {
    if (const SceneSystem* system = judge.system()) {
      settler_.emplace(*system);
    } else if (scene.problem().lines.size() > 1 && !why_no_system(scene)) {
      of_lines_.emplace(scene);
      settler_.emplace(*of_lines_);
    }
  }

  /// Fills a place for each; the first has that number.
  void judge(std::span<const Candidate> candidates, std::size_t first,
             std::span<std::optional<Judged>> places) const {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (is_usable(scene_, candidates[i]))
        places[i] = Judged{first + i, scene_.representative(candidates[i].figure), 0,
                           candidates[i].multiplicity, candidates[i].error};
    find_conditions(candidates, places);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!places[i]) continue;
      settle(*places[i], candidates[i].figure);
      places[i]->signs = signs_of(scene_, signs_, *places[i], places[i]->representative);
    }
  }

 private:
  void find_conditions(std::span<const Candidate> candidates, std::span<std::optional<Judged>> places) const {
    std::vector<Judged*> judged;
    std::vector<const Figure*> figures;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!places[i]) continue;
      if (candidates[i].condition) {
        places[i]->condition = *candidates[i].condition;
        continue;
      }
      judged.push_back(&*places[i]);
      figures.push_back(&places[i]->representative);
    }
    const std::vector<double> conditions = points_ ? points_->conditions(figures) : std::vector<double>();
    for (std::size_t i = 0; i < judged.size(); ++i)
      judged[i]->condition = points_ ? conditions[i] : judge_.condition(*figures[i]);
  }

  /// Of scenes that are solved by the equations of all kinds of elements: their strategies take residuals in doubles.
  void settle(Judged& judged, const Figure& figure) const {
    if (!settler_ || !(judged.condition < singular_condition) || judged.multiplicity > 1 ||
        std::isfinite(judged.error))
      return;
    const Figure settled = settler_->settled(scene_.in_frame(figure), judged.condition);
    judged.representative = scene_.representative(settled);
  }

  const Scene& scene_;
  const FigureJudge& judge_;
  const std::optional<PointConditions> points_ = PointConditions::of(scene_);
  const std::vector<StatedSign> signs_ = stated_signs(scene_.problem());
  std::optional<SceneSystem> of_lines_;   ///< where there are several, and distances alone
  std::optional<FigureSettler> settler_;  ///< where there are equations of elements
};

/// Multiplicity of a class: the largest that was reported for a member.
void set_class(const FigureJudge& judge, const Judged& first, Figure representative, int multiplicity,
               AssessedSolution& solution) {
  solution.figure = std::move(representative);
  solution.multiplicity = multiplicity;
  solution.residual = judge.residual(solution.figure);
  solution.condition = first.condition;
  solution.signs = first.signs;
}

}  // namespace

std::vector<std::optional<Judged>> judged_candidates(const Scene& scene, const FigureJudge& judge,
                                                     std::vector<Candidate>& candidates, bool takes_figures,
                                                     int threads) {
  const CandidateJudge of_candidates(scene, judge);
  std::vector<std::optional<Judged>> judged(candidates.size());
  constexpr std::size_t at_once = 64;  // as many as fill the lanes, and far fewer than threads share
  share_on_threads((candidates.size() + at_once - 1) / at_once, threads, [&](std::size_t block) {
    const std::size_t first = block * at_once, some = std::min(at_once, candidates.size() - first);
    const std::span<Candidate> some_of_them = std::span(candidates).subspan(first, some);
    of_candidates.judge(some_of_them, first, std::span(judged).subspan(first, some));
    if (takes_figures)
      for (Candidate& candidate : some_of_them) candidate.figure = Figure();
  });
  return judged;
}

ListedSolutions list_solutions(const Scene& scene, const FigureJudge& judge, std::vector<Judged>& judged,
                               const ErrorsOf& errors_of, int threads) {
  std::vector<Figure> figures = take_representatives(judged);
  const std::vector<int> class_of = classes_told_apart(scene, figures, errors_of, threads, judged);
  std::vector<int> order;                           // the first candidate of each class
  std::vector<int> multiplicity(judged.size(), 0);  // by class
  for (int i = 0; i < static_cast<int>(judged.size()); ++i) {
    if (multiplicity[class_of[i]] == 0) order.push_back(i);
    multiplicity[class_of[i]] = std::max(multiplicity[class_of[i]], judged[i].multiplicity);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return comes_first(scene.size(), figures[a], judged[a].signs, figures[b], judged[b].signs);
  });

  AssessedSolution blank;
  blank.terms = file_terms(scene);
  ListedSolutions listed{std::vector<AssessedSolution>(order.size(), blank), {}};
  share_on_threads(order.size(), threads, [&](std::size_t i) {
    const int of = order[i];
    set_class(judge, judged[of], std::move(figures[of]), multiplicity[class_of[of]], listed.solutions[i]);
  });
  std::vector<int> solution_of_class_index(judged.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i)
    solution_of_class_index[class_of[order[i]]] = static_cast<int>(i);
  for (const int c : class_of) listed.solution_of.push_back(solution_of_class_index[c]);
  return listed;
}

}  // namespace gcs
