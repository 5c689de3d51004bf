#include "solvers/homotopies/trace_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "solvers/homotopies/precise_zero.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// In E, at random; more cost time, and a few random ones are generic enough.
constexpr int most_coordinates = 6;

/// Last ε, of the search's: either s or E is of this order, the other one is not. At 0 pivots vanish.
constexpr double almost_zero = 1e-9;

/// Sets of unknowns whose signs change together, and with no others, in all that the equations say.
class SignComponents {
 public:
  explicit SignComponents(const SquareSystem& system) : root_(static_cast<std::size_t>(system.unknowns) + 1) {
    std::iota(root_.begin(), root_.end(), 0);
    for (const Difference& d : system.differences) {
      if (d.subtrahend >= 0) join(d.minuend, d.subtrahend);
      if (d.constant != 0) join(d.minuend, none());
    }
  }

  /// One unknown of each component whose signs can be changed.
  std::vector<int> representatives() {
    std::vector<int> first;
    for (int unknown = 0; unknown < none(); ++unknown)
      if (find(unknown) == unknown && find(none()) != unknown) first.push_back(unknown);
    return first;
  }

 private:
  /// Stands for the constants, whose signs do not change.
  int none() const { return static_cast<int>(root_.size()) - 1; }
  int find(int i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(int a, int b) { root_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

  std::vector<int> root_;
};

/// The system for (x, s, q_a, E, −E, i·s, i·E) with the squares q_a of E. The product s·E is
/// 1/4 of (s + E)² − (s − E)², which is (s − (−E))² + (i·s − i·E)².
class TraceSystem {
 public:
  TraceSystem(const SquareSystem& lengths, const std::vector<int>& mirror_axes, std::mt19937_64& random)
      : lengths_(lengths), direction_(random_complex_vector(lengths.equations(), random)) {
    choose_squares(mirror_axes, random);
    weights_ = random_complex_vector(static_cast<int>(squares_.size()), random);
    offset_ = random_complex_vector(1, random).front();
    const int n = lengths.unknowns, k = static_cast<int>(squares_.size());
    s_ = n;
    square_ = n + 1;
    e_ = n + 1 + k;
    system_.unknowns = n + k + 5;
    add_lengths();
    for (int i = 0; i < k; ++i) system_.add_equation({squares_[i]}, {{square_ + i, -1}}, 0);
    add_weighted_sum();
    system_.add_equation({}, {{e_, 1}, {e_ + 1, 1}}, 0);
    system_.add_equation({}, {{s_, Complex(0, 1)}, {e_ + 2, -1}}, 0);
    system_.add_equation({}, {{e_, Complex(0, 1)}, {e_ + 3, -1}}, 0);
    system_.add_equation({{s_, e_ + 1, 0}, {e_ + 2, e_ + 3, 0}}, {}, 0);
  }

  const SquareSystem& system() const { return system_; }
  TraceProblem problem(SignMasks signs) const {
    std::vector<Monomial> terms{{s_, -1}};
    for (std::size_t i = 0; i < squares_.size(); ++i) terms.push_back({square_ + static_cast<int>(i), -1});
    return {family(std::move(signs)), s_, system_.equations() - 1, std::move(terms),
            [this](const ComplexVectorX& squares, const ComplexVectorX& x) {
              return precise_zero(system_, squares, x);
            }};
  }

 private:
  HomotopyFamily family(SignMasks signs) const {
    while (signs.size() < static_cast<std::size_t>(system_.unknowns)) signs.push_back(0);
    std::vector<bool> is_free(system_.given.size(), false);
    std::fill_n(is_free.begin(), lengths_.equations(), true);
    is_free.back() = true;
    return square_family(system_, std::move(signs), std::move(is_free),
                         [this](std::mt19937_64& random) { return random_point(random); });
  }

  /// Some coordinates at random, and what tells apart the images of a component that are not divided out:
  /// its distance from another one of the same axis or, where nothing is divided out, from a constant.
  void choose_squares(const std::vector<int>& mirror_axes, std::mt19937_64& random) {
    std::vector<int> order(static_cast<std::size_t>(lengths_.unknowns));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = 0; i < order.size(); ++i)
      std::swap(order[i], order[i + random() % (order.size() - i)]);
    order.resize(std::min<std::size_t>(order.size(), most_coordinates));
    for (const int unknown : order) squares_.push_back({unknown});
    std::uniform_real_distribution<double> constant(0.5, 1.5);
    std::array<int, 3> first_of_axis{-1, -1, -1};
    for (const int unknown : SignComponents(lengths_).representatives()) {
      const int axis = mirror_axes[unknown];
      if (axis < 0)
        squares_.push_back({unknown, -1, constant(random)});
      else if (first_of_axis[axis] >= 0)
        squares_.push_back({first_of_axis[axis], unknown});
      else
        first_of_axis[axis] = unknown;
    }
  }

  /// A(x) − s·V
  void add_lengths() {
    for (int e = 0; e < lengths_.equations(); ++e) {
      const auto begin = lengths_.differences.begin();
      system_.add_equation({begin + lengths_.first[e], begin + lengths_.first[e + 1]}, {{s_, -direction_[e]}},
                           lengths_.given[e]);
    }
  }

  void add_weighted_sum() {
    std::vector<LinearTerm> terms{{e_, -1}};
    for (std::size_t i = 0; i < squares_.size(); ++i)
      terms.push_back({square_ + static_cast<int>(i), weights_[i]});
    system_.add_equation({}, terms, 0);
  }

  ComplexVectorX random_point(std::mt19937_64& random) const {
    ComplexVectorX x = random_complex_vector(lengths_.unknowns + 1, random);
    Complex e = -offset_;
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      const Difference& d = squares_[i];
      const Complex difference = x[d.minuend] - (d.subtrahend < 0 ? Complex(d.constant) : x[d.subtrahend]);
      x.push_back(difference * difference);
      e += weights_[i] * x.back();
    }
    x.insert(x.end(), {e, -e, Complex(0, 1) * x[s_], Complex(0, 1) * e});
    return x;
  }

  const SquareSystem& lengths_;
  ComplexVectorX direction_;  // V
  std::vector<Difference> squares_;
  ComplexVectorX weights_;
  Complex offset_;
  SquareSystem system_;
  int s_ = 0;
  int square_ = 0;
  int e_ = 0;
};

/// Points with one ε.
struct Fibre {
  ComplexVectorX parameters;
  std::vector<ComplexVectorX> points;
};

/// All points followed to another value of the product's right-hand side; nothing where one was lost.
std::optional<Fibre> moved(LegTracking& tracking, const GenericSolutions& fibre, int parameter,
                           Complex factor, const std::function<bool()>& stopped, WorkCounters& work) {
  const ComplexVectorX zero(fibre.squares.size());
  Route route{{fibre.squares, zero, zero, zero}, fibre.squares};
  route.coefficients[1][parameter] = (factor - 1.0) * fibre.squares[parameter];
  route.end[parameter] *= factor;
  std::vector<Leg> legs;
  for (const ComplexVectorX& x : fibre.solutions) legs.push_back({x.data(), &route});
  Fibre end{route.end, {}};
  for (LegResult& result : tracking.follow(legs, stopped, work)) {
    if (result.state.end != LegEnd::arrived) return std::nullopt;
    end.points.push_back(std::move(result.x));
  }
  return end;
}

/// The test of one fibre, found by a search.
class FibreTest {
 public:
  FibreTest(const TraceProblem& problem, LegTracking& tracking, std::mt19937_64& random,
            const std::function<bool()>& stopped, WorkCounters& work)
      : problem_(problem),
        tracking_(tracking),
        weights_(random_complex_vector(static_cast<int>(problem.terms.size()), random)),
        stopped_(stopped),
        work_(work) {}

  /// Of the sums S at three values of ε, 1 + i/2, 1 and 1 − i/2 times the search's: (S_1 − S_0)(ε_2 − ε_0) −
  /// (S_2 − S_0)(ε_1 − ε_0), relative to the same of their terms; nothing where a path was lost. Precondition: the points
  /// of the last call come first.
  std::optional<double> defect(const GenericSolutions& fibre) {
    GenericSolutions added;
    added.squares = fibre.squares;
    added.solutions.assign(fibre.solutions.begin() + summed_, fibre.solutions.end());
    if (!add(added)) return std::nullopt;
    summed_ = std::ssize(fibre.solutions);
    return size_ > 0 ? std::abs(rounded_midpoint(sum_)) / size_ : 1;
  }

  /// How many of the points have s = 0 when ε is 0.
  std::optional<std::int64_t> count_solutions(const GenericSolutions& fibre) const {
    const auto end = at(fibre, almost_zero);
    if (!end) return std::nullopt;
    return std::ranges::count_if(end->points, [&](const ComplexVectorX& x) {
      return std::abs(x[problem_.s]) <= std::sqrt(almost_zero);
    });
  }

 private:
  /// The terms of these points; false, and none, where a path was lost.
  bool add(const GenericSolutions& fibre) {
    const Complex aside(0, 0.5);
    const auto ahead = at(fibre, 1.0 + aside), behind = at(fibre, 1.0 - aside);
    if (!ahead || !behind) return false;
    const auto middle = phi({fibre.squares, fibre.solutions}), first = phi(*ahead), last = phi(*behind);
    if (!middle || !first || !last) return false;
    const BallMatrix forward = step(fibre, *ahead), back = step(fibre, *behind);
    Ball term, difference;
    for (slong i = 0; i < middle->rows(); ++i) {
      acb_sub(term, (*first)(i, 0), (*middle)(i, 0), precise_bits_of_zeros);
      acb_mul(term, term, back(0, 0), precise_bits_of_zeros);
      acb_sub(difference, (*middle)(i, 0), (*last)(i, 0), precise_bits_of_zeros);
      acb_addmul(term, difference, forward(0, 0), precise_bits_of_zeros);
      acb_add(sum_, sum_, term, precise_bits_of_zeros);
      size_ += std::abs(rounded_midpoint(term));
    }
    return true;
  }

  std::optional<Fibre> at(const GenericSolutions& fibre, Complex factor) const {
    return moved(tracking_, fibre, problem_.product, factor, stopped_, work_);
  }

  /// Of ε, exactly.
  BallMatrix step(const GenericSolutions& from, const Fibre& to) const {
    BallMatrix difference(1, 1);
    add_monomial(difference(0, 0), to.parameters[problem_.product], {}, difference);
    add_monomial(difference(0, 0), -from.squares[problem_.product], {}, difference);
    return difference;
  }

  /// Of each point.
  std::optional<BallMatrix> phi(const Fibre& fibre) const {
    BallMatrix values(static_cast<slong>(fibre.points.size()), 1);
    for (std::size_t i = 0; i < fibre.points.size(); ++i) {
      const std::optional<BallMatrix> zero = problem_.zero(fibre.parameters, fibre.points[i]);
      if (!zero) return std::nullopt;
      for (std::size_t k = 0; k < weights_.size(); ++k)
        add_monomial(values(static_cast<slong>(i), 0), weights_[k], problem_.terms[k], *zero);
    }
    return values;
  }

  const TraceProblem& problem_;
  LegTracking& tracking_;
  ComplexVectorX weights_;
  const std::function<bool()>& stopped_;
  WorkCounters& work_;
  std::ptrdiff_t summed_ = 0;  ///< points
  Ball sum_;
  double size_ = 0;
};

}  // namespace

TraceTest test_trace(const TraceProblem& problem, LegTracking& tracking, const MonodromyOptions& options,
                     std::mt19937_64& random, const std::function<bool()>& stopped,
                     const std::function<void(int)>& progress, WorkCounters& work) {
  FibreTest fibre_test(problem, tracking, random, stopped, work);
  TraceTest test;
  std::size_t tested = 0;  // points: a search only adds to them
  const auto sums_are_affine = [&](const GenericSolutions& fibre) {
    if (fibre.solutions.size() != std::exchange(tested, fibre.solutions.size()))
      test.defect = fibre_test.defect(fibre).value_or(1);
    return test.is_affine();
  };
  const GenericSolutions fibre = search_by_monodromy(
      problem.family, tracking, {std::nullopt, sums_are_affine}, options, random, stopped, progress, work);
  test.end = fibre.end;
  test.points = static_cast<std::int64_t>(fibre.solutions.size());
  if (test.passed()) test.solutions = fibre_test.count_solutions(fibre).value_or(0);
  return test;
}

TraceTest test_trace(const SquareSystem& system, const std::vector<int>& mirror_axes,
                     const TrackingSetup& setup, const MonodromyOptions& options, std::mt19937_64& random,
                     const std::function<bool()>& stopped, const std::function<void(int)>& progress,
                     WorkCounters& work) {
  const TraceSystem trace(system, mirror_axes, random);
  const Elimination elimination = order_elimination(trace.system(), random);
  LegTracking tracking(trace.system(), elimination, setup);
  return test_trace(trace.problem(mirror_axes), tracking, options, random, stopped, progress, work);
}

}  // namespace gcs
