#pragma once
/// The subdivision of plan_scan.hpp, whatever the plan places.

#include <algorithm>

#include "solvers/certificates/krawczyk.hpp"
#include "solvers/certificates/undecided_place.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/narrowing.hpp"
#include "solvers/scanning/piece.hpp"
#include "solvers/scanning/scan_outcome.hpp"

namespace gcs {

/// The scan of a stage: what a plan places step by step, and the equations that it is to meet. It has
///   steps(), ranges(), the range of each angle, and size(), that of the scene;
///   start(), the positions before the first step;
///   pieces(k, positions, cell, within), those of step k;
///   put(k, piece, positions, narrowing): the positions with the piece; false where a check excludes it;
///   box(positions), what they say of the unknowns, and figure(x), a figure at them;
///   equations(), and content(box), refine(x, iterations) and solutions_in(box) by them;
///   image_near(box, known), of the box what holds solutions of the same class, near another one; nothing where none
///   of these meets that one;
///   solution(box), the one solution there.
template <int N, class Stage>
class CellScan {
 public:
  /// Keeps references.
  CellScan(const SolveRequest& request, const Stage& stage, std::int64_t max_cells)
      : request_(request),
        stage_(stage),
        angles_(static_cast<int>(stage.ranges().size())),
        max_cells_(max_cells) {}

  ScanOutcome run() {
    Cell<N> whole;
    for (int i = 0; i < angles_; ++i) {
      const auto [low, high] = stage_.ranges()[i];
      whole.mid[i] = (low + high) / 2;
      whole.half[i] = (high - low) / 2;
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
    if (!is_over()) count_at_places();
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
    std::vector<Choice> choices;      ///< of all steps: the pieces that the branch is on
    std::vector<Position> positions;  ///< of points and whatever else the stage has
    Position last{};                  ///< what was placed last: what to halve is judged by it
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
    Visit visit{part, std::vector<Choice>(stage_.steps()), stage_.start()};
    step(visit, 0, Narrowing<N>());
  }

  void step(Visit& visit, std::size_t k, const Narrowing<N>& narrowing) {
    if (is_over()) return;
    if (k == stage_.steps()) return judge(visit, narrowing);
    const std::vector<Choice>& within = visit.part.within;
    const Pieces<N> pieces = stage_.pieces(k, visit.positions, visit.part.cell,
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
    if (angles_ > 1) return false;
    return std::any_of(pieces.list.begin(), pieces.list.end(), [this](const Piece<N>& piece) {
      return std::any_of(piece.position.begin(), piece.position.end(),
                         [this](const Form& x) { return x.rest > coarse * stage_.size(); });
    });
  }

  /// Takes the piece on, unless the branch ends here.
  void place(Visit& visit, std::size_t k, const Piece<N>& piece, Narrowing<N> narrowing) {
    for (const Form& exists : piece.exists)
      if (!narrowing.by_bound(exists)) return;
    visit.choices[k] = piece.choice;
    if (!piece.exchange) return check(visit, k, piece, narrowing);
    if (!narrowing.by_values(piece.exchange->symbol, piece.exchange->value)) return;
    if (go_on_narrower(visit, k + 1, narrowing)) return;
    Visit exchanged = visit;
    for (Position& position : exchanged.positions) position = piece.exchange->of(position);
    exchanged.range_of[piece.exchange->symbol] = static_cast<int>(k);
    narrowing.reset(piece.exchange->symbol);
    check(exchanged, k, piece, narrowing);
  }

  /// Goes on with the piece, unless a check excludes it.
  void check(Visit& visit, std::size_t k, const Piece<N>& piece, Narrowing<N> narrowing) {
    if (!stage_.put(k, piece, visit.positions, narrowing)) return;
    visit.last = piece.position;
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
    for (int i = 0; i < angles_; ++i) {
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
    if (symbol < 0) return give_up(visit, k, left.cell);
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
    for (int i = 0; i < angles_; ++i) {
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

  /// All of a branch is placed and no check excludes them.
  void judge(const Visit& visit, const Narrowing<N>& narrowing) {
    const Box box = stage_.box(visit.positions);
    if (box.radius.maxCoeff() <= worth_a_test * stage_.size() &&
        (is_decided(box) || (is_worth_a_search(visit, narrowing) && is_searched(box))))
      return;
    split(visit, stage_.steps(), narrowing);
  }

  bool has_one_solution(const Box& box) const { return stage_.content(box) == BoxContent::one_solution; }

  /// The box, or one around it with room for the rounding of a solution, where that has exactly one.
  std::optional<Box> with_one_solution(Box box) const {
    if (has_one_solution(box)) return box;
    box.radius = box.radius.cwiseMax(room * stage_.size());
    return has_one_solution(box) ? std::optional(box) : std::nullopt;
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

  /// Whether the one solution in a tight box is of the class of one of those found: it is where a box around both tight
  /// boxes still has one solution, and none where they do not meet.
  Novelty novelty(const Box& tight) const {
    bool meets_any = false;
    for (const Box& known : boxes_) {
      const std::optional<Box> image = stage_.image_near(tight, known);
      if (!image) continue;
      const Eigen::VectorXd apart = (known.mid - image->mid).cwiseAbs() * (1 + 4 * Form::epsilon);
      const Box both{image->mid, (apart + known.radius + image->radius) * (1 + 4 * Form::epsilon)};
      if (with_one_solution(both)) return Novelty::known;
      meets_any = true;
    }
    return meets_any ? Novelty::unknown : Novelty::other;
  }

  /// True when the box holds no solution, or one that is known from now on.
  bool is_decided(const Box& box) {
    ++outcome_.boxes;
    if (stage_.content(box) == BoxContent::no_solution) return true;
    Eigen::VectorXd x = box.mid;
    if (!stage_.refine(x, outcome_.newton_iterations)) return false;
    // Around the solution itself the test is sharpest. Its box holds the whole branch over the cell, so that
    // the one solution in it is all there is.
    Box around{x, box.radius + (x - box.mid).cwiseAbs()};
    around.radius *= 1 + 8 * Form::epsilon;
    const std::optional<Box> with_one = with_one_solution(around);
    return with_one && is_known_now(*with_one);
  }

  /// Takes the one solution in the box, at its middle, to those found. False when it cannot be told whether
  /// it is one of them.
  bool is_known_now(const Box& around, int multiplicity = 1) {
    const Box tight = tightened(around);
    const Novelty found = novelty(tight);
    if (found == Novelty::other) {
      outcome_.solutions.push_back(stage_.solution(tight));
      outcome_.solutions.back().multiplicity = multiplicity;
      boxes_.push_back(tight);
    }
    return found != Novelty::unknown;
  }

  /// Narrow cells say little more when they are halved: what rounding leaves unknown of the points stays.
  bool is_worth_a_search(const Visit& visit, const Narrowing<N>& narrowing) const {
    if (failed_searches_ == most_failed_searches) return false;
    const Part left = remainder(visit, stage_.steps(), narrowing).part;
    for (int i = 0; i < angles_; ++i)
      if (range(left, visit, i)[1] > narrow) return false;
    return true;
  }

  /// True when all solutions in the box are found, and known from now on.
  bool is_searched(const Box& box) {
    const auto found = stage_.solutions_in(box);
    const auto is_known = [this](const Box& around) { return is_known_now(around); };
    if (found && std::all_of(found->begin(), found->end(), is_known)) return true;
    ++failed_searches_;
    return false;
  }

  void give_up(const Visit& visit, std::size_t k, const Cell<N>& cell) {
    UndecidedPiece piece;
    for (int i = 0; i < angles_; ++i)
      piece.ranges.push_back({cell.mid[i] - cell.half[i], cell.mid[i] + cell.half[i]});
    const Box box = stage_.box(visit.positions);
    if (k == stage_.steps() && box.radius.allFinite()) piece.box = box;
    Eigen::VectorXd x = box.mid;
    stage_.refine(x, outcome_.newton_iterations);
    piece.figure = stage_.figure(x);
    outcome_.undecided.push_back(std::move(piece));
    if (static_cast<std::int64_t>(outcome_.undecided.size()) > most_undecided)
      outcome_.end = ScanOutcome::End::too_many_undecided;
  }

  /// Leaves the pieces undecided of which counting does not decide the place (undecided_place.hpp).
  void count_at_places() {
    if (outcome_.undecided.empty() || outcome_.undecided.size() > most_counted) return;
    std::vector<UndecidedPiece> placed, left;
    std::vector<Box> boxes;
    for (UndecidedPiece& piece : outcome_.undecided) {
      if (piece.box) boxes.push_back(*piece.box);
      (piece.box ? placed : left).push_back(std::move(piece));
    }
    const QuadraticSystem equations = stage_.equations();
    for (const UndecidedPlace& place : undecided_places(boxes, equations.mirror, one_place * stage_.size()))
      if (!is_counted(equations, place.hull))
        for (const std::size_t member : place.members) left.push_back(std::move(placed[member]));
    outcome_.undecided = std::move(left);
  }

  /// True when all solutions in the box are found, and known from now on.
  bool is_counted(const QuadraticSystem& equations, const Box& box) {
    const auto solutions = real_solutions_in(equations, box, request_.stop);
    outcome_.is_counted = outcome_.is_counted || solutions;
    return solutions && std::ranges::all_of(*solutions, [this](const CountedSolution& solution) {
             return is_known_now(solution.box, solution.multiplicity);
           });
  }

  static constexpr std::int64_t cells_between_news = 1000;
  static constexpr double worth_a_visit = 0.6;  ///< of a cell: less is left than halving would leave
  static constexpr double coarse = 0.02;        ///< of the scene
  static constexpr double room = 0x1p-40;       ///< of the scene
  static constexpr double worth_a_test = 0.1;  ///< of the scene: in larger boxes the Jacobian varies too much
  /// Half a cell, as `finest`: regular solutions are found in wider ones.
  static constexpr double narrow = 1e-5;
  /// Half the width of the finest cells: of angles in radians, of heights (see Choice) in the scene's unit:
  /// about a thousand roundings of an angle. A regular solution is found long before.
  static constexpr double finest = 1e-12;
  /// More finest pieces than this are a curve of solutions and not the surroundings of a few multiple ones,
  /// each of which takes about 1e-8 / finest in the direction in which it is multiple.
  static constexpr std::int64_t most_undecided = 200'000;
  /// Of the scene: pieces that are nearer to each other are of one place.
  static constexpr double one_place = 0x1p-12;
  /// More are a curve of solutions, or nearly one, in hundreds of places.
  static constexpr std::size_t most_counted = 20'000;
  static constexpr int most_failed_searches = 50;  ///< more would say no more, and take seconds

  const SolveRequest& request_;
  const Stage& stage_;
  int angles_;
  std::int64_t max_cells_;
  std::vector<Part> pending_;  ///< the last is the next
  std::vector<Box> boxes_;     ///< tight ones around the solutions found
  int failed_searches_ = 0;
  ScanOutcome outcome_;
};

}  // namespace gcs
