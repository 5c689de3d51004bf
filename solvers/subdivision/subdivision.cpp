#include "solvers/subdivision/subdivision.hpp"

#include <algorithm>
#include <optional>

#include "solvers/running/run_on_threads.hpp"
#include "solvers/subdivision/linear_narrowing.hpp"
#include "solvers/subdivision/square_narrowing.hpp"

namespace gcs {
namespace {

/// Of the unknowns' size: boxes that are no wider are not halved. Squares of their widths, by which a
/// relaxation is off, are below the rounding of the equations then, and solutions that are farther apart are
/// told apart.
constexpr double finest = 0x1p-36;

/// A round that leaves more than this share of a box's widths is the last one before it is halved.
constexpr double worth_a_round = 0.9;

/// Around a solution of multiplicity 4 some hundred boxes are undecided; a curve of solutions has no end of
/// them.
constexpr std::size_t most_undecided = 3000;

/// Of the widest unknown's width: narrower ones are not halved while others are so much wider.
constexpr double comparable = 0.2;

/// Boxes that are looked at side by side, whatever the number of threads.
constexpr std::size_t batch = 32;

Box as_box(const IntervalBox& sides) {
  const auto n = static_cast<Eigen::Index>(sides.size());
  Box box{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Interval& side = sides[static_cast<std::size_t>(i)];
    box.mid[i] = side.middle();
    box.radius[i] = side.reach(box.mid[i]);
  }
  return box;
}

/// What became of a box.
struct Visit {
  std::vector<IntervalBox> halves;  ///< none where it is decided
  std::optional<ProvenSolution> solution;
  std::optional<Box> undecided;
  SubdivisionCounters work;
};

class Visitor {
 public:
  Visitor(const IntervalEquations& system, const KrawczykTest& test, Reduction reduction, double size,
          IntervalBox box)
      : system_(system), test_(test), reduction_(reduction), size_(size), box_(std::move(box)) {}

  Visit run() {
    visit_.work.boxes = 1;
    bool is_open = true;
    for (double before = widths() * 2; is_open && widths() < worth_a_round * before;) {
      before = widths();
      is_open = narrow();
    }
    if (is_open) halve();
    return std::move(visit_);
  }

 private:
  double widths() const {
    double sum = 0;
    for (std::size_t i = 0; i < box_.size(); ++i)
      if (system_.is_nonlinear[i]) sum += box_[i].width();
    return sum;
  }

  /// False where the box is decided.
  bool narrow() {
    std::vector<Interval> forms;
    if (reduction_ == Reduction::none) {
      forms = forms_over(system_, box_);
      if (are_contradictory(system_, forms)) return false;
    } else {
      auto narrowed = narrow_by_equations(system_, box_);
      if (!narrowed) return false;
      forms = std::move(*narrowed);
    }
    if (!pass_krawczyk()) return false;
    if (reduction_ != Reduction::linear) return true;
    LinearWork work;
    const bool is_possible = narrow_linearly(system_, forms, box_, work);
    visit_.work.linear_programs += work.programs;
    visit_.work.pivots += work.pivots;
    return is_possible;
  }

  bool pass_krawczyk() {
    const Box box = as_box(box_);
    ++visit_.work.krawczyk_tests;
    const auto image = test_.image(box);
    if (!image) return true;
    if (image->misses(box.radius)) return false;
    if (is_regular(*image, box)) {
      auto solution = test_.only_solution_around(box, visit_.work.newton_iterations);
      ++visit_.work.krawczyk_tests;
      if (solution) {
        const Box& proven = solution->enclosure;
        const Eigen::ArrayXd apart = (proven.mid - box.mid).cwiseAbs().array() * (1 - 0x1p-50);
        if ((apart <= (proven.radius + box.radius).array()).all()) visit_.solution = std::move(solution);
        return false;
      }
    }
    return intersect(*image, box);
  }

  /// Whether Krawczyk's operator contracts the box, but for what is no wider than rounding.
  bool is_regular(const KrawczykImage<double>& image, const Box& box) const {
    for (Eigen::Index i = 0; i < box.radius.size(); ++i)
      if (box.radius[i] > finest * size_ && !(image.spread[i] < box.radius[i])) return false;
    return true;
  }

  bool intersect(const KrawczykImage<double>& image, const Box& box) {
    for (Eigen::Index i = 0; i < box.mid.size(); ++i) {
      Interval& side = box_[static_cast<std::size_t>(i)];
      const Interval values = exact_interval(box.mid[i]) - exact_interval(image.move[i]) +
                              interval_around_zero(image.spread[i] + 0x1p-50 * std::abs(image.move[i]));
      if (values.is_finite()) side = intersection(side, values);
      if (side.is_empty()) return false;
    }
    return true;
  }

  /// How far from linear the equations are where each unknown is: of every product that it is in, the width of
  /// the other form, by which its derivative varies in the box.
  std::vector<double> variations() const {
    std::vector<double> result(box_.size(), 0);
    const std::vector<Interval> forms = forms_over(system_, box_);
    const auto add = [&](int form, int other) {
      for (const auto& [unknown, coefficient] : system_.forms[static_cast<std::size_t>(form)].terms)
        result[static_cast<std::size_t>(unknown)] +=
            coefficient.interval.magnitude() * forms[static_cast<std::size_t>(other)].width();
    };
    for (const IntervalEquation& equation : system_.equations)
      for (const IntervalProduct& product : equation.products) {
        add(product.left, product.right);
        if (!product.is_square()) add(product.right, product.left);
      }
    return result;
  }

  double widest() const {
    double width = 0;
    for (std::size_t i = 0; i < box_.size(); ++i)
      if (system_.is_nonlinear[i]) width = std::max(width, box_[i].width());
    return width;
  }

  /// Where the derivatives vary most, among the widest unknowns: what is left of an equation is off from its
  /// linear part by both.
  std::size_t side_to_halve() const {
    const double least = comparable * widest();
    const std::vector<double> variation = variations();
    std::size_t best = box_.size();
    for (std::size_t i = 0; i < box_.size(); ++i)
      if (system_.is_nonlinear[i] && box_[i].width() > least &&
          (best == box_.size() || variation[i] > variation[best]))
        best = i;
    return best;
  }

  void halve() {
    if (!(widest() > finest * size_)) {
      visit_.undecided = as_box(box_);
      return;
    }
    visit_.work.bisections = 1;
    const std::size_t side = side_to_halve();
    const double middle = box_[side].middle();
    visit_.halves = {box_, box_};
    visit_.halves[0][side].low = middle;
    visit_.halves[1][side].high = middle;
  }

  const IntervalEquations& system_;
  const KrawczykTest& test_;
  Reduction reduction_;
  double size_;
  IntervalBox box_;
  Visit visit_;
};

void add(const SubdivisionCounters& more, SubdivisionCounters& work) {
  work.boxes += more.boxes;
  work.bisections += more.bisections;
  work.krawczyk_tests += more.krawczyk_tests;
  work.linear_programs += more.linear_programs;
  work.pivots += more.pivots;
  work.newton_iterations += more.newton_iterations;
}

/// Depth first, so that few boxes wait.
class Subdivision {
 public:
  Subdivision(const IntervalEquations& system, const IntervalBox& box, double size,
              const SubdivisionMeans& means)
      : system_(system), size_(size), means_(means), test_(system, size), waiting_{box} {}

  SubdivisionOutcome run() {
    while (!waiting_.empty()) {
      if (means_.stop.stop_requested()) return end_early(SubdivisionOutcome::End::stopped);
      if (outcome_.work.boxes >= means_.max_boxes) return end_early(SubdivisionOutcome::End::too_many_boxes);
      if (outcome_.undecided.size() > most_undecided)
        return end_early(SubdivisionOutcome::End::too_many_undecided);
      for (Visit& visit : visit_last()) take(std::move(visit));
      if (means_.monitor != nullptr) means_.monitor->progress("subdividing", -1);
    }
    return std::move(outcome_);
  }

 private:
  SubdivisionOutcome end_early(SubdivisionOutcome::End end) {
    outcome_.end = end;
    outcome_.left = static_cast<std::int64_t>(waiting_.size());
    return std::move(outcome_);
  }

  std::vector<Visit> visit_last() {
    const std::int64_t allowed = means_.max_boxes - outcome_.work.boxes;
    const std::size_t count = std::min({batch, waiting_.size(), static_cast<std::size_t>(allowed)});
    const std::size_t first = waiting_.size() - count;
    std::vector<Visit> visits(count);
    share_on_threads(count, means_.threads, [&](std::size_t i) {
      visits[i] = Visitor(system_, test_, means_.reduction, size_, std::move(waiting_[first + i])).run();
    });
    waiting_.resize(first);
    return visits;
  }

  void take(Visit visit) {
    add(visit.work, outcome_.work);
    for (IntervalBox& half : visit.halves) waiting_.push_back(std::move(half));
    if (visit.solution) outcome_.solutions.push_back(std::move(*visit.solution));
    if (visit.undecided) outcome_.undecided.push_back(std::move(*visit.undecided));
  }

  const IntervalEquations& system_;
  double size_;
  const SubdivisionMeans& means_;
  KrawczykTest test_;
  std::vector<IntervalBox> waiting_;
  SubdivisionOutcome outcome_;
};

}  // namespace

SubdivisionOutcome subdivide(const IntervalEquations& system, const IntervalBox& box, double size,
                             const SubdivisionMeans& means) {
  return Subdivision(system, box, size, means).run();
}

}  // namespace gcs
