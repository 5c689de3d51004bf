#include "solvers/scanning/plan_scan.hpp"

#include <algorithm>

#include "solvers/certificates/box_search.hpp"
#include "solvers/scanning/narrowing.hpp"
#include "solvers/scanning/step_pieces.hpp"

namespace gcs {
namespace {

template <int N>
class Scan {
 public:
  Scan(const SolveRequest& request, const ScanPlan& plan, std::int64_t max_cells)
      : request_(request),
        scene_(request.scene),
        plan_(plan),
        max_cells_(max_cells),
        system_(scene_, plan.frame),
        squares_(target_squares(scene_)),
        pieces_(squares_, plan.angles()) {}

  ScanOutcome run() {
    Cell<N> whole;
    for (int i = 0; i < plan_.angles(); ++i) {
      whole.mid[i] = (plan_.ranges[i][0] + plan_.ranges[i][1]) / 2;
      whole.half[i] = (plan_.ranges[i][1] - plan_.ranges[i][0]) / 2;
    }
    pending_.push_back({whole, {}});
    while (!pending_.empty() && !is_over()) {
      if (request_.stop.stop_requested()) {
        outcome_.end = ScanOutcome::End::stopped;
        break;
      }
      const Part part = std::move(pending_.back());
      pending_.pop_back();
      const std::size_t others = pending_.size();
      visit(part);
      share_out(part.share, others);
    }
    return std::move(outcome_);
  }

 private:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;

  /// A cell and, of the first steps, the pieces of a larger cell that hold the branch.
  struct Part {
    Cell<N> cell;
    std::vector<Choice> within;
    double share = 1;  ///< of the whole scan, if all that a part leaves over were alike
  };

  /// One part on its way through the plan.
  struct Visit {
    const Part& part;
    std::vector<Choice> choices;   ///< of all steps: the pieces that the branch is on
    std::vector<Position> points;  ///< by point
    Position last{};               ///< the point placed last: what to halve is judged by it
    /// By symbol: the step whose range it stands for now; −1: the cell's angle.
    std::array<int, N> range_of = all_angles();
  };

  static std::array<int, N> all_angles() {
    std::array<int, N> none{};
    none.fill(-1);
    return none;
  }

  bool is_over() const { return outcome_.end != ScanOutcome::End::complete; }

  /// Divides the share of a part among those that it left over, which are pending beyond `others`.
  void share_out(double share, std::size_t others) {
    const auto parts = static_cast<double>(pending_.size() - others);
    if (parts == 0) outcome_.share += share;
    for (std::size_t i = others; i < pending_.size(); ++i) pending_[i].share = share / parts;
    if (request_.monitor != nullptr && outcome_.cells % cells_between_news == 0)
      request_.monitor->progress("scanning", outcome_.share);
  }

  /// Follows all branches of the part.
  void visit(const Part& part) {
    if (++outcome_.cells > max_cells_) outcome_.end = ScanOutcome::End::too_many_cells;
    Visit visit{part, std::vector<Choice>(plan_.steps.size()), std::vector<Position>(scene_.point_count())};
    for (int p = 0; p < scene_.point_count(); ++p)
      if (const auto position = scene_.fixed_point(p))
        for (int axis = 0; axis < 3; ++axis) {
          visit.points[p][axis].mid = (*position)[axis];
          visit.points[p][axis].rest = system_.coordinate_error(p, axis);
        }
    step(visit, 0, Narrowing<N>());
  }

  void step(Visit& visit, std::size_t k, const Narrowing<N>& narrowing) {
    if (is_over()) return;
    if (k == plan_.steps.size()) return judge(visit, narrowing);
    const std::vector<Choice>& within = visit.part.within;
    const Pieces<N> pieces = pieces_.of(plan_.steps[k], visit.points, visit.part.cell,
                                        k < within.size() ? std::optional(within[k]) : std::nullopt);
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

  /// Takes the piece on, unless the branch ends here.
  void place(Visit& visit, std::size_t k, const Piece<N>& piece, Narrowing<N> narrowing) {
    for (const Form& exists : piece.exists)
      if (!narrowing.by_bound(exists)) return;
    visit.choices[k] = piece.choice;
    if (!piece.exchange) return check(visit, k, piece.position, narrowing);
    if (!narrowing.by_values(piece.exchange->symbol, piece.exchange->value)) return;
    if (go_on_narrower(visit, k + 1, narrowing)) return;
    Visit exchanged = visit;
    for (Position& point : exchanged.points) point = piece.exchange->of(point);
    exchanged.range_of[piece.exchange->symbol] = static_cast<int>(k);
    narrowing.reset(piece.exchange->symbol);
    check(exchanged, k, piece.position, narrowing);
  }

  /// Goes on with the point there, unless a check excludes it.
  void check(Visit& visit, std::size_t k, const Position& position, Narrowing<N> narrowing) {
    const ScanStep& step = plan_.steps[k];
    for (const ScanSphere& check : step.checks)
      if (!narrowing.by_zero(square(position - visit.points[check.center]) -
                             pieces_.square_of(check.constraint)))
        return;
    visit.points[step.place] = position;
    visit.last = position;
    if (!go_on_narrower(visit, k + 1, narrowing)) this->step(visit, k + 1, narrowing);
  }

  /// What is left of a part whose first k steps are taken.
  struct Remainder {
    Part part;
    double share = 1;  ///< of the narrowest symbol, relative to the whole
  };

  Remainder remainder(const Visit& visit, std::size_t k, const Narrowing<N>& narrowing) const {
    Remainder left{visit.part};
    std::vector<Choice>& within = left.part.within;
    if (within.size() < k) within.resize(k);
    std::copy_n(visit.choices.begin(), k, within.begin());
    for (int i = 0; i < plan_.angles(); ++i) {
      const auto [mid, half] = range(left.part, visit, i);
      const double new_mid = mid + half * (narrowing.low(i) + narrowing.high(i)) / 2;
      const double new_half =
          half * (narrowing.high(i) - narrowing.low(i)) / 2 + 2 * Form::epsilon * std::abs(new_mid);
      left.share = std::min(left.share, new_half / half);
      if (new_half < half) set_range(left.part, visit, i, new_mid, new_half);
    }
    return left;
  }

  /// Middle and half width of what symbol i stands for.
  static std::array<double, 2> range(const Part& part, const Visit& visit, int i) {
    if (visit.range_of[i] < 0) return {part.cell.mid[i], part.cell.half[i]};
    const Choice& choice = part.within[visit.range_of[i]];
    return {choice.mid(), choice.half()};
  }
  static void set_range(Part& part, const Visit& visit, int i, double mid, double half) {
    if (visit.range_of[i] < 0) {
      part.cell.mid[i] = mid;
      part.cell.half[i] = half;
    } else {
      Choice& choice = part.within[visit.range_of[i]];
      choice.low = std::max(choice.low, mid - half);
      choice.high = std::min(choice.high, mid + half);
    }
  }

  /// Where much of the part has gone, goes on with the rest. False where not.
  bool go_on_narrower(const Visit& visit, std::size_t k, const Narrowing<N>& narrowing) {
    Remainder left = remainder(visit, k, narrowing);
    if (!(left.share < worth_a_visit)) return false;
    pending_.push_back(std::move(left.part));
    return true;
  }

  /// Goes on with the halves of what is left of the part, or names it when it is too fine.
  void split(const Visit& visit, std::size_t k, const Narrowing<N>& narrowing) {
    if (go_on_narrower(visit, k, narrowing)) return;
    const Part left = remainder(visit, k, narrowing).part;
    const int symbol = symbol_to_halve(visit, left);
    if (symbol < 0) return give_up(visit, left.cell);
    const auto [mid, half] = range(left, visit, symbol);
    for (const double sign : {1.0, -1.0}) {
      pending_.push_back(left);
      set_range(pending_.back(), visit, symbol, mid + sign * half / 2, half / 2);
    }
  }

  /// The one that moves the last point most. −1 where all are too fine.
  int symbol_to_halve(const Visit& visit, const Part& part) const {
    int symbol = -1;
    double most = -1;
    for (int i = 0; i < plan_.angles(); ++i) {
      const double half = range(part, visit, i)[1];
      double move = 0;
      for (const Form& x : visit.last) move += std::abs(x.slope[i]);
      move = std::max(move, 1e-3 * half);
      if (!(half > finest && move > most)) continue;
      most = move;
      symbol = i;
    }
    return symbol;
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
    if (box.radius.maxCoeff() <= worth_a_test * scene_.size() &&
        (is_decided(box) || (is_worth_a_search(visit, narrowing) && is_searched(box))))
      return;
    split(visit, plan_.steps.size(), narrowing);
  }

  bool has_one_solution(const Box& box) const {
    return krawczyk(system_, squares_, box) == BoxContent::one_solution;
  }

  /// A smaller box around the one solution in `around`, as small as the test proves.
  Box tightened(Box around) const {
    while (true) {
      const Box smaller{around.mid, 0x1p-8 * around.radius};
      if (!has_one_solution(smaller)) return around;
      around = smaller;
    }
  }

  enum class Novelty { unknown, known, other };

  /// Whether the one solution in a tight box is one of those found: it is where a box around both tight boxes
  /// still has one solution, and none where they do not meet.
  Novelty novelty(const Box& tight) const {
    bool meets_any = false;
    for (const Box& known : boxes_) {
      const Eigen::VectorXd apart = (known.mid - tight.mid).cwiseAbs() * (1 + 4 * Form::epsilon);
      if ((apart.array() > (known.radius + tight.radius).array()).any()) continue;
      const Box both{tight.mid, (apart + known.radius + tight.radius) * (1 + 4 * Form::epsilon)};
      if (has_one_solution(both)) return Novelty::known;
      meets_any = true;
    }
    return meets_any ? Novelty::unknown : Novelty::other;
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
    return is_known_now(around);
  }

  /// Takes the one solution in the box, at its middle, to those found. False when it cannot be told whether
  /// it is one of them.
  bool is_known_now(const Box& around) {
    const Box tight = tightened(around);
    const Novelty found = novelty(tight);
    if (found == Novelty::other) {
      const double error = std::sqrt(3.0) * tight.radius.maxCoeff() * (1 + 4 * Form::epsilon);
      outcome_.solutions.push_back({system_.figure(tight.mid), error});
      boxes_.push_back(tight);
    }
    return found != Novelty::unknown;
  }

  /// Narrow cells say little more when they are halved: what rounding leaves unknown of the points stays.
  bool is_worth_a_search(const Visit& visit, const Narrowing<N>& narrowing) const {
    if (failed_searches_ == most_failed_searches) return false;
    const Part left = remainder(visit, plan_.steps.size(), narrowing).part;
    for (int i = 0; i < plan_.angles(); ++i)
      if (range(left, visit, i)[1] > narrow) return false;
    return true;
  }

  /// True when all solutions in the box are found, and known from now on.
  bool is_searched(const Box& box) {
    const auto found = solutions_in(system_, squares_, box, most_parts);
    const auto is_known = [this](const Box& around) { return is_known_now(around); };
    if (found && std::all_of(found->begin(), found->end(), is_known)) return true;
    ++failed_searches_;
    return false;
  }

  void give_up(const Visit& visit, const Cell<N>& cell) {
    UndecidedPiece piece;
    for (int i = 0; i < plan_.angles(); ++i)
      piece.ranges.push_back({cell.mid[i] - cell.half[i], cell.mid[i] + cell.half[i]});
    Eigen::VectorXd x = box_of(visit).mid;
    outcome_.newton_iterations += refine(system_, squares_, x).iterations;
    piece.figure = system_.figure(x);
    outcome_.undecided.push_back(std::move(piece));
    if (static_cast<std::int64_t>(outcome_.undecided.size()) > most_undecided)
      outcome_.end = ScanOutcome::End::too_many_undecided;
  }

  static constexpr std::int64_t cells_between_news = 1000;
  static constexpr double worth_a_visit = 0.6;  ///< of a cell: less is left than halving would leave
  static constexpr double coarse = 0.02;        ///< of the scene
  static constexpr double worth_a_test = 0.1;  ///< of the scene: in larger boxes the Jacobian varies too much
  /// Half a cell, as `finest`: regular solutions are found in wider ones.
  static constexpr double narrow = 1e-5;
  /// Half the width of the finest cells: of angles in radians, of heights (see Choice) in the scene's unit:
  /// about a thousand roundings of an angle. A regular solution is found long before.
  static constexpr double finest = 1e-12;
  /// More finest pieces than this are a curve of solutions and not the surroundings of a few multiple ones,
  /// each of which takes about 1e-8 / finest in the direction in which it is multiple.
  static constexpr std::int64_t most_undecided = 200'000;
  static constexpr int most_parts = 5000;          ///< of a search: tens of milliseconds
  static constexpr int most_failed_searches = 50;  ///< more would say no more, and take seconds

  const SolveRequest& request_;
  const Scene& scene_;
  const ScanPlan& plan_;
  std::int64_t max_cells_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  StepPieces<N> pieces_;
  std::vector<Part> pending_;  ///< the last is the next
  std::vector<Box> boxes_;     ///< tight ones around the solutions found
  int failed_searches_ = 0;
  ScanOutcome outcome_;
};

}  // namespace

ScanOutcome scan_plan(const SolveRequest& request, const ScanPlan& plan, std::int64_t max_cells) {
  const int symbols = plan.angles() + (request.scene.has_lines() ? 1 : 0);
  if (symbols <= 1) return Scan<1>(request, plan, max_cells).run();
  if (symbols == 2) return Scan<2>(request, plan, max_cells).run();
  return Scan<3>(request, plan, max_cells).run();
}

}  // namespace gcs
