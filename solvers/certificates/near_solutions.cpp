#include "solvers/certificates/near_solutions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "solvers/certificates/ball_cluster.hpp"
#include "solvers/certificates/coincidences.hpp"

namespace gcs {
namespace {

using Point = std::vector<std::complex<double>>;

constexpr slong search_bits = 256;
/// Relative to the squared size of the unknowns. Newton's method has left less after its 120 steps, from a
/// solution that doubles found: a fourth of the residual is left after each step towards a double one, 1/e
/// towards one of high multiplicity.
constexpr double multiple_residual = 1e-60;
/// Corrections that are still below this close in on a solution by half of the way or less.
constexpr double slow_convergence = 1e-6;
constexpr int most_rounds = 3;  // of Newton's method, 40 steps each
/// Further away is another solution, which is not looked for here.
constexpr double furthest = 1e-3;
/// Of one multiple solution ends are so near to each other: 1e-7 and less.
constexpr double same_multiple = 1e-6;

constexpr std::array<double, 6> reaches{1e-8, 1e-6, 1e-7, 1e-5, 1e-9, 1e-4};
constexpr std::size_t directions = 3;

Point middle_of(const BallMatrix& x) {
  Point result;
  for (slong i = 0; i < x.rows(); ++i) result.push_back(rounded_midpoint(x(i, 0)));
  return result;
}

/// The largest |x_i|, at least 1.
double size_of(const Point& x) {
  double size = 1;
  for (const auto& value : x) size = std::max(size, std::abs(value));
  return size;
}

/// The point itself, and others around it in opposite pairs.
std::vector<Point> starts_around(const Point& x) {
  std::mt19937_64 random(1);  // any directions will do
  const auto number = [&] { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; };
  std::vector<Point> starts{x};
  for (std::size_t pair = 0; pair < directions * reaches.size(); ++pair) {
    const double reach = reaches[pair % reaches.size()] * size_of(x);
    Point there = x, opposite = x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double re = number(), im = number();
      there[i] += reach * std::complex(re, im);
      opposite[i] -= reach * std::complex(re, im);
    }
    starts.push_back(std::move(there));
    starts.push_back(std::move(opposite));
  }
  return starts;
}

BallMatrix real_part(BallMatrix x) {
  for (slong i = 0; i < x.rows(); ++i) arb_zero(acb_imagref(x(i, 0)));
  return x;
}

/// What Newton's method came to.
struct Visit {
  Point end;
  std::optional<Certificate> simple;
  std::optional<MultipleSolution> multiple;
};

class Search {
 public:
  Search(const QuadraticSystem& system, const std::stop_token& stop)
      : system_(system, search_bits), mirror_(system.mirror), stop_(stop) {}

  /// Adds what is next to a point, up to `wanted` solutions; nothing when stopped.
  void visit(const NearlySingular& point, int wanted, NearSolutions& settled) const {
    if (auto meeting = meeting_at(point)) return add(*std::move(meeting), settled.multiple);
    std::vector<Certificate> found;
    std::optional<MultipleSolution> multiple;
    int multiple_ends = 0;
    for (const Point& start : starts_around(point.x)) {
      if (stop_.stop_requested()) return;
      Visit visit = visit_from(start);
      if (!(largest_difference(visit.end, point.x) <= furthest * size_of(point.x))) continue;
      if (visit.simple) add_new(*visit.simple, found);
      if (visit.multiple) ++multiple_ends;
      if (visit.multiple && (!multiple || visit.multiple->is_real)) multiple = std::move(visit.multiple);
      // A multiple solution that two starts opposite to each other lead to as well is alone.
      if (static_cast<int>(found.size()) >= wanted || (found.empty() && multiple_ends == 3)) break;
    }
    for (const Certificate& simple : found) add_new(simple, settled.simple);
    if (!found.empty() || !multiple) return;
    multiple->multiplicity = point.solutions;
    add(std::move(*multiple), settled.multiple);
  }

 private:
  /// Where more than two meet: Newton's method from around them would go astray.
  std::optional<MultipleSolution> meeting_at(const NearlySingular& point) const {
    if (point.solutions <= 2 || stop_.stop_requested()) return std::nullopt;
    const auto x = meeting_point(system_, point.x, point.solutions);
    if (!x || !(largest_difference(middle_of(*x), point.x) <= furthest * size_of(point.x)))
      return std::nullopt;
    std::optional<MultipleSolution> multiple = multiple_at(*x);
    if (multiple) multiple->multiplicity = point.solutions;
    return multiple;
  }

  Visit visit_from(const Point& start) const {
    BallKrawczyk::Newton newton = system_.refined(BallKrawczyk::vector(start));
    for (int round = 1; round < most_rounds && !newton.converged && !newton.is_singular; ++round)
      if (newton.correction <= slow_convergence) newton = system_.refined(newton.x);
    Visit visit{middle_of(newton.x), std::nullopt, std::nullopt};
    const auto proof = newton.converged ? system_.prove(newton.x) : std::nullopt;
    if (!proof)
      visit.multiple = multiple_at(newton.x);
    else
      visit.simple = certificate_of(newton.x, *proof);
    return visit;
  }

  /// What doubles round is moved further than another solution may be away: there a proof in the reals says that it is
  /// real.
  std::optional<Certificate> certificate_of(const BallMatrix& x, const BallKrawczyk::Proof& proof) const {
    Certificate certificate;
    certificate.is_proven = true;
    certificate.bits = static_cast<int>(search_bits);
    certificate.enclosure = enclosure_of(proof);
    certificate.realness = realness(certificate.enclosure);
    if (certificate.realness != Certificate::Realness::undecided) return certificate;
    const auto in_reals = system_.prove(real_part(x));
    if (!in_reals) return std::nullopt;
    certificate.enclosure = enclosure_of(*in_reals);
    certificate.realness = realness(certificate.enclosure);
    return certificate.realness == Certificate::Realness::real ? std::optional(certificate) : std::nullopt;
  }

  bool satisfies(const BallMatrix& x) const {
    const double size = size_of(middle_of(x));
    const BallMatrix value = system_.value(x);
    for (slong e = 0; e < value.rows(); ++e)
      if (!(magnitude(value(e, 0)) <= multiple_residual * size * size)) return false;
    return true;
  }

  std::optional<MultipleSolution> multiple_at(const BallMatrix& x) const {
    if (!satisfies(x)) return std::nullopt;
    const BallMatrix real = real_part(x);
    const bool is_real = satisfies(real);
    return MultipleSolution{middle_of(is_real ? real : x), is_real};
  }

  /// Unless it is not proven to be different from one of them.
  void add_new(const Certificate& solution, std::vector<Certificate>& list) const {
    const auto may_be_same = [&](const Certificate& other) {
      return !coincidences({solution.enclosure, other.enclosure}, mirror_).empty();
    };
    if (std::none_of(list.begin(), list.end(), may_be_same)) list.push_back(solution);
  }

  static void add(MultipleSolution solution, std::vector<MultipleSolution>& list) {
    const auto known = std::find_if(list.begin(), list.end(), [&](const MultipleSolution& other) {
      return largest_difference(other.x, solution.x) <= same_multiple * size_of(other.x);
    });
    if (known == list.end())
      list.push_back(std::move(solution));
    else
      known->multiplicity += solution.multiplicity;
  }

  BallKrawczyk system_;
  SignMasks mirror_;
  const std::stop_token& stop_;
};

}  // namespace

double largest_difference(const Point& a, const Point& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

int NearSolutions::count() const {
  int sum = static_cast<int>(simple.size());
  for (const MultipleSolution& solution : multiple) sum += solution.multiplicity;
  return sum;
}

NearSolutions solutions_near(const QuadraticSystem& system, const std::vector<NearlySingular>& points,
                             int expected, const std::stop_token& stop) {
  const Search search(system, stop);
  NearSolutions settled;
  for (const bool all : {false, true}) {
    if (all && settled.count() >= expected) break;
    settled = {};
    for (const NearlySingular& point : points) search.visit(point, all ? expected : point.solutions, settled);
  }
  return settled;
}

}  // namespace gcs
