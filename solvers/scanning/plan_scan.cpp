#include "solvers/scanning/plan_scan.hpp"

#include <algorithm>

#include "solvers/certification/krawczyk.hpp"
#include "solvers/scanning/step_pieces.hpp"

namespace gcs {
namespace {

/// The part of a cell, in its own coordinates ξ in [−1, 1], on which a branch may still hold a solution.
template <int N>
class Narrowing {
 public:
  Narrowing() {
    low_.fill(-1);
    high_.fill(1);
  }

  /// Leaves what satisfies g = 0, or g ≥ 0. False when nothing does.
  bool by_zero(const AffineForm<N>& g) { return by_bound(g) && by_bound(-g); }
  bool by_bound(const AffineForm<N>& g) {
    for (int i = 0; i < N; ++i) {
      double others = g.mid + g.rest + 8 * AffineForm<N>::epsilon * (std::abs(g.mid) + g.radius());
      for (int j = 0; j < N; ++j)
        if (j != i) others += std::max(g.slope[j] * low_[j], g.slope[j] * high_[j]);
      // slope_i ξ_i ≥ −others
      if (g.slope[i] > 0) low_[i] = std::max(low_[i], -others / g.slope[i] - margin);
      if (g.slope[i] < 0) high_[i] = std::min(high_[i], -others / g.slope[i] + margin);
      if (!(low_[i] <= high_[i])) return false;
    }
    return g.high() >= 0;
  }

  /// Of the narrowest direction, relative to the whole.
  double share() const {
    double share = 1;
    for (int i = 0; i < N; ++i) share = std::min(share, (high_[i] - low_[i]) / 2);
    return share;
  }
  Cell<N> of(const Cell<N>& cell) const {
    Cell<N> part;
    for (int i = 0; i < N; ++i) {
      part.mid[i] = cell.mid[i] + cell.half[i] * (low_[i] + high_[i]) / 2;
      part.half[i] =
          cell.half[i] * (high_[i] - low_[i]) / 2 + 2 * AffineForm<N>::epsilon * std::abs(part.mid[i]);
    }
    return part;
  }

 private:
  static constexpr double margin = 1e-14;  ///< in ξ: more than the rounding of the division
  std::array<double, N> low_;
  std::array<double, N> high_;
};

template <int N>
class Scan {
 public:
  Scan(const Scene& scene, const ScanPlan& plan, const ScanLimits& limits, const std::stop_token& stop)
      : scene_(scene),
        plan_(plan),
        limits_(limits),
        stop_(stop),
        system_(scene, plan.frame),
        squares_(target_squares(scene)),
        pieces_(squares_, plan.angles()) {}

  ScanOutcome run() {
    Cell<N> whole;
    for (int i = 0; i < plan_.angles(); ++i) {
      whole.mid[i] = (plan_.ranges[i][0] + plan_.ranges[i][1]) / 2;
      whole.half[i] = (plan_.ranges[i][1] - plan_.ranges[i][0]) / 2;
    }
    visit(whole, {});
    return std::move(outcome_);
  }

 private:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;

  /// One cell on its way through the plan.
  struct Visit {
    const Cell<N>& cell;
    std::vector<Choice> within;    ///< of the first steps: the pieces of a larger cell that hold the branch
    std::vector<Choice> choices;   ///< of all steps: the pieces that the branch is on
    std::vector<Position> points;  ///< by point
    Position last{};               ///< the point placed last: what to halve is judged by it
  };

  bool is_over() const { return outcome_.end != ScanOutcome::End::complete; }

  /// Follows all branches that begin with `choices` over the cell.
  void visit(const Cell<N>& cell, std::vector<Choice> choices) {
    if (is_over()) return;
    if (stop_.stop_requested()) outcome_.end = ScanOutcome::End::stopped;
    if (++outcome_.cells > limits_.max_cells) outcome_.end = ScanOutcome::End::too_many_cells;
    Visit visit{cell, std::move(choices), std::vector<Choice>(plan_.steps.size()),
                std::vector<Position>(scene_.point_count())};
    for (int p = 0; p < scene_.point_count(); ++p)
      if (const auto position = scene_.fixed_point(p))
        visit.points[p] = {Form((*position)[0]), Form((*position)[1]), Form((*position)[2])};
    step(visit, 0, Narrowing<N>());
  }

  void step(Visit& visit, std::size_t k, const Narrowing<N>& narrowing) {
    if (is_over()) return;
    if (k == plan_.steps.size()) return judge(visit, narrowing);
    const auto within = k < visit.within.size() ? std::optional(visit.within[k]) : std::nullopt;
    const Pieces<N> pieces = pieces_.of(plan_.steps[k], visit.points, visit.cell, within);
    if (pieces.unbounded_where) {
      Narrowing<N> less = narrowing;
      if (less.by_bound(*pieces.unbounded_where)) split(visit, k, less);
      return;
    }
    if (is_coarse(pieces)) return split(visit, k, narrowing);
    for (const Piece<N>& piece : pieces.list) place(visit, k, piece, narrowing);
  }

  /// Enclosures so wide that hardly any branch would leave the cell later on: halves are followed at less
  /// cost than many branches. Not so with two angles, where it takes four quarters to be as much narrower.
  bool is_coarse(const Pieces<N>& pieces) const {
    if (plan_.angles() > 1) return false;
    return std::any_of(pieces.list.begin(), pieces.list.end(), [this](const Piece<N>& piece) {
      return std::any_of(piece.position.begin(), piece.position.end(),
                         [this](const Form& x) { return x.rest > coarse * scene_.size(); });
    });
  }

  /// Takes the piece on, unless the branch ends here; goes on with less of the cell where much has gone.
  void place(Visit& visit, std::size_t k, const Piece<N>& piece, Narrowing<N> narrowing) {
    const ScanStep& step = plan_.steps[k];
    for (const Form& exists : piece.exists)
      if (!narrowing.by_bound(exists)) return;
    for (const ScanSphere& check : step.checks)
      if (!narrowing.by_zero(square(piece.position - visit.points[check.center]) -
                             pieces_.square_of(check.constraint)))
        return;
    visit.choices[k] = piece.choice;
    visit.points[step.place] = piece.position;
    visit.last = piece.position;
    if (k >= visit.within.size() && narrowing.share() < worth_a_visit)
      return this->visit(narrowing.of(visit.cell), choices_up_to(visit, k + 1));
    this->step(visit, k + 1, narrowing);
  }

  static std::vector<Choice> choices_up_to(const Visit& visit, std::size_t k) {
    return {visit.choices.begin(), visit.choices.begin() + static_cast<std::ptrdiff_t>(k)};
  }

  /// Goes on with the halves of what is left of the cell, or names it when it is too fine.
  void split(const Visit& visit, std::size_t k, const Narrowing<N>& narrowing) {
    const Cell<N> left = narrowing.of(visit.cell);
    if (narrowing.share() < worth_a_visit) return this->visit(left, choices_up_to(visit, k));
    if (left.width() <= fine_enough && split_height(visit, k, left)) return;
    if (left.width() <= limits_.finest) return give_up(visit, left);
    const int axis = axis_to_halve(visit, left);
    for (const double sign : {-1.0, 1.0}) {
      Cell<N> half = left;
      half.half[axis] /= 2;
      half.mid[axis] += sign * half.half[axis];
      this->visit(half, choices_up_to(visit, k));
    }
  }

  /// Near a branch end a height moves by the root of what an angle moves: halving the height goes further.
  /// False where no height is left to halve.
  bool split_height(const Visit& visit, std::size_t k, const Cell<N>& cell) {
    std::vector<Choice> choices = choices_up_to(visit, k);
    const auto height = [](const Choice& choice) { return choice.side != 0 ? choice.width() : 0; };
    const auto widest =
        std::max_element(choices.begin(), choices.end(),
                         [&](const Choice& a, const Choice& b) { return height(a) < height(b); });
    if (widest == choices.end() || height(*widest) <= limits_.finest) return false;
    choices.erase(widest + 1, choices.end());
    Choice lower = choices.back();
    lower.high = (lower.low + lower.high) / 2;
    Choice upper = choices.back();
    upper.low = lower.high;
    for (const Choice& half : {lower, upper}) {
      choices.back() = half;
      this->visit(cell, choices);
    }
    return true;
  }

  /// The angle that moves the last point most.
  int axis_to_halve(const Visit& visit, const Cell<N>& cell) const {
    int axis = 0;
    double most = -1;
    for (int i = 0; i < plan_.angles(); ++i) {
      double move = 0;
      for (const Form& x : visit.last) move += std::abs(x.slope[i]);
      move = std::max(move, 1e-3 * cell.half[i]);
      if (!(move > most)) continue;
      most = move;
      axis = i;
    }
    return axis;
  }

  Box box_of(const Visit& visit) const {
    Box box{Eigen::VectorXd(system_.unknowns()), Eigen::VectorXd(system_.unknowns())};
    for (int p = 0; p < scene_.point_count(); ++p)
      for (int axis = 0; axis < scene_.dimension(); ++axis) {
        const int i = system_.unknown(p, axis);
        if (i < 0) continue;
        const Form& x = visit.points[p][axis];
        box.mid[i] = x.mid;
        box.radius[i] = x.radius() + 4 * Form::epsilon * std::abs(x.mid);
      }
    return box;
  }

  /// All points of a branch are placed and no check excludes them.
  void judge(const Visit& visit, const Narrowing<N>& narrowing) {
    const Box box = box_of(visit);
    if (box.radius.maxCoeff() <= worth_a_test * scene_.size() && is_decided(box)) return;
    split(visit, plan_.steps.size(), narrowing);
  }

  bool is_known(const Eigen::VectorXd& x) const {
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return box.contains(x); });
  }

  /// True when the box holds no solution, or one that is known from now on.
  bool is_decided(const Box& box) {
    ++outcome_.boxes;
    const BoxContent content = krawczyk(system_, squares_, box);
    if (content == BoxContent::no_solution) return true;
    Eigen::VectorXd x = box.mid;
    const Refinement refinement = refine(system_, squares_, x);
    outcome_.newton_iterations += refinement.iterations;
    if (!refinement.converged) return false;
    // Around the solution itself the test is sharpest. Its box holds the whole branch over the cell, so that
    // the one solution in it is all there is.
    Box around{x, box.radius + (x - box.mid).cwiseAbs()};
    around.radius *= 1 + 8 * Form::epsilon;
    if (krawczyk(system_, squares_, around) != BoxContent::one_solution) return false;
    if (!is_known(x)) outcome_.solutions.push_back(system_.figure(x));
    boxes_.push_back(around);
    return true;
  }

  void give_up(const Visit& visit, const Cell<N>& cell) {
    UndecidedPiece piece;
    for (int i = 0; i < plan_.angles(); ++i)
      piece.ranges.push_back({cell.mid[i] - cell.half[i], cell.mid[i] + cell.half[i]});
    Eigen::VectorXd x = box_of(visit).mid;
    outcome_.newton_iterations += refine(system_, squares_, x).iterations;
    piece.figure = system_.figure(x);
    outcome_.undecided.push_back(std::move(piece));
    if (static_cast<std::int64_t>(outcome_.undecided.size()) > limits_.max_undecided)
      outcome_.end = ScanOutcome::End::too_many_undecided;
  }

  static constexpr double worth_a_visit = 0.6;  ///< of a cell: less is left than halving would leave
  static constexpr double fine_enough = 1e-9;  ///< radians: by now all but branch ends and extrema is decided
  static constexpr double coarse = 0.05;       ///< of the scene
  static constexpr double worth_a_test = 0.1;  ///< of the scene: in larger boxes the Jacobian varies too much

  const Scene& scene_;
  const ScanPlan& plan_;
  const ScanLimits& limits_;
  const std::stop_token& stop_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  StepPieces<N> pieces_;
  std::vector<Box> boxes_;  ///< each with one solution, known
  ScanOutcome outcome_;
};

}  // namespace

ScanOutcome scan_plan(const Scene& scene, const ScanPlan& plan, const ScanLimits& limits,
                      const std::stop_token& stop) {
  const bool has_line = scene.has_lines();
  if (plan.angles() + (has_line ? 1 : 0) <= 1) return Scan<1>(scene, plan, limits, stop).run();
  return Scan<2>(scene, plan, limits, stop).run();
}

}  // namespace gcs
