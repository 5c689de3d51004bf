#include "solvers/homotopies/endgame.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr double radius_ratio = 1.0 / 8;   // of one circle to the next
constexpr double pole_ratio = 1.0 / 2;     // of one that reads a pole to the next: doubles lose what grows
constexpr double smallest_radius = 1e-13;  // of σ; the arithmetic of higher precision resolves it
constexpr int corners = 8;                 // samples of a round
constexpr int most_rounds = 8;             // winding numbers beyond are left to smaller circles
constexpr double direct_step = 1e-7;       // of the last tenth; a pole not much further from the way is near
constexpr std::size_t batch = 4096;        // paths between two reports of progress: seconds

/// Circles that enclose other branch points are long and say nothing: a path is walked around once it grows
/// by a steady power of σ, where the radius is so small that waiting has not helped, or so far away that doubles soon do not
/// tell it: there they hold its squared lengths to 1e-6, in units of the scene.
constexpr double steady_power = 0.12;  // change of the power from one radius to the next
constexpr double waiting_ends = 1e-4;
constexpr double far_away = 1e5;

/// Relative to the largest |x_i| on the circle.
constexpr double closed = 1e-8;  // start and end of a walk are one point
constexpr double absent =
    1e-9;  // a term of the series: rounding and the powers beyond the samples; also beside the end
constexpr double dominant = 0.5;      // the leading term of a pole, so that its power is not mistaken
constexpr double agreed_pole = 1e-4;  // two circles' leading coefficients
constexpr double agreed_end = 1e-8;   // two circles' constant terms
/// A pole so near σ = 0 is at it, as far as lengths in doubles tell: their rounding moves it by as much.
constexpr double at_the_end = 1e-15;
/// A pole that is off in σ^(1/w), which no rounding of lengths explains, must leave the end at least this far
/// away, where solutions in doubles are not told from infinity.
constexpr double beyond_doubles = 1e14;

/// σ along a straight line. The way is the difference of the rounded ends, exactly where these are near each
/// other: near a singular end a sum that misses `end` by rounding would be far from it on the path.
Route segment(const ComplexVectorX& from, const ComplexVectorX& to, Complex first, Complex last) {
  Route route;
  for (std::size_t e = 0; e < to.size(); ++e) {
    const Complex way = from[e] - to[e];
    const Complex begin = to[e] + first * way;
    const Complex end = to[e] + last * way;
    route.coefficients[0].push_back(begin);
    route.coefficients[1].push_back(end - begin);
    route.coefficients[2].push_back(0);
    route.coefficients[3].push_back(0);
    route.end.push_back(end);
  }
  return route;
}

/// Sum of samples[k]·e^(−2πi k p/M)/M: the term of power p/w times radius^(p/w).
ComplexVectorX fourier(const std::vector<ComplexVectorX>& samples, int power) {
  const int m = static_cast<int>(samples.size());
  ComplexVectorX sum(samples.front().size());
  for (int k = 0; k < m; ++k) {
    const Complex factor = std::polar(1.0 / m, -2 * std::numbers::pi * ((k * power) % m) / m);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * samples[k][i];
  }
  return sum;
}

/// What one circle says about a path.
struct CircleReading {
  enum class Kind { finite, pole, unclear };
  Kind kind = Kind::unclear;
  int winding_number = 1;
  int pole_order = 0;        ///< of σ^(−1/w)
  double pole_shift = 0;     ///< how far from σ = 0 the pole may lie
  double pole_offset = 0;    ///< the same in σ^(1/w), beside that shift
  ComplexVectorX leading{};  ///< coefficient of the pole's term, or the constant term

  /// Of a pole: whether it is at σ = 0, to rounding.
  bool is_at_infinity() const {
    return pole_shift <= at_the_end && beyond_doubles * std::pow(pole_offset, pole_order) <= largest(leading);
  }
};

double largest_sample(const std::vector<ComplexVectorX>& samples) {
  double scale = 0;
  for (const ComplexVectorX& sample : samples) scale = std::max(scale, largest(sample));
  return scale;
}

/// A pole at σ = −ε in the place of 0 has the terms of lower powers of σ, which fall by a factor ε/radius
/// each; one at τ = δ, τ = σ^(1/w), has all lower powers of τ, which fall by δ/τ.
CircleReading read_circle(const std::vector<ComplexVectorX>& samples, double radius) {
  CircleReading reading;
  const int m = static_cast<int>(samples.size()), w = m / corners;
  reading.winding_number = w;
  const double scale = largest_sample(samples), tau = std::pow(radius, 1.0 / w);
  std::vector<double> lower;  // sizes of the powers below, from −m/2 on
  for (int power = -m / 2; power < 0; ++power) {
    ComplexVectorX term = fourier(samples, power);
    const double size = largest(term);
    if (size >= dominant * scale) {
      reading.kind = CircleReading::Kind::pole;
      reading.pole_order = -power;
      for (std::size_t i = 0; i < lower.size(); ++i) {
        const bool is_shift = (static_cast<int>(lower.size() - i) % w) == 0;
        double& offset = is_shift ? reading.pole_shift : reading.pole_offset;
        offset = std::max(offset, (is_shift ? radius : tau) * lower[i] / size);
      }
      for (Complex& value : term) value *= std::pow(tau, -power);
      reading.leading = std::move(term);
      return reading;
    }
    lower.push_back(size);
  }
  ComplexVectorX constant = fourier(samples, 0);
  const double least = absent * std::min(scale, 1 + largest(constant));
  if (!lower.empty() && *std::max_element(lower.begin(), lower.end()) > least) return reading;
  reading.kind = CircleReading::Kind::finite;
  reading.leading = std::move(constant);
  return reading;
}

/// The end is regular where Newton's method settles and a pivoting factorisation is regular. `value_at`, `jacobian_at`:
/// functions of x, the one with the factor that the other has.
template <class Value, class Jacobian>
void settle_one(const Value& value_at, const Jacobian& jacobian_at, PathEnd& end) {
  constexpr int most_iterations = 6;
  constexpr double settled = 1e-13,
                   least_rcond = 1e-10;  // relative to 1 + the largest |x_i|; reciprocal condition
  using Rows = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(end.x.size());
  ComplexVectorX x = end.x;
  for (int i = 0; i < most_iterations; ++i) {
    const ComplexVectorX jacobian = jacobian_at(x), value = value_at(x);
    const Eigen::PartialPivLU<Rows> factors(Eigen::Map<const Rows>(jacobian.data(), n, n));
    const Eigen::VectorXcd change = factors.solve(Eigen::Map<const Eigen::VectorXcd>(value.data(), n));
    for (Eigen::Index v = 0; v < n; ++v) x[static_cast<std::size_t>(v)] -= change[v];
    if (!(factors.rcond() > least_rcond) || !change.allFinite()) return;
    if (change.cwiseAbs().maxCoeff() > settled * (1 + largest(x))) continue;
    end.kind = PathEnd::Kind::regular;
    end.x = x;
    return;
  }
}

bool may_be_regular(const PathEnd& end) {
  return end.kind == PathEnd::Kind::singular && end.winding_number == 1;
}

struct ActivePath {
  std::size_t number = 0;
  ComplexVectorX x;         ///< at σ = the current radius
  ComplexVectorX before{};  ///< at the first one
  std::vector<ComplexVectorX> samples{};
  std::optional<CircleReading> last{};
  /// The last one that two circles agreed on, of an end that is no zero.
  std::optional<CircleReading> between{};
  double power = std::numeric_limits<double>::infinity();  ///< x grew like σ^(−power) lately
  bool is_steady = false;
  bool is_closed = false;
  bool is_lost = false;
};

using Paths = std::vector<ActivePath>;

class Endgame {
 public:
  Endgame(LegTracking& tracking, const ComplexVectorX& from, const ComplexVectorX& to,
          const std::function<bool(const ComplexVectorX&)>& is_zero, const std::function<bool()>& stopped,
          WorkCounters& work)
      : tracking_(tracking), from_(from), to_(to), is_zero_(is_zero), stopped_(stopped), work_(work) {}

  /// Those that simply arrive. While a batch goes on to its ends, the next one is on its way to the last tenth.
  void approach_ends(std::span<const ComplexVectorX> starts, const std::function<void()>& progress) {
    const Route there = segment(from_, to_, 1, first_radius), rest = segment(from_, to_, first_radius, 0);
    std::size_t begun = 0;
    const auto begin_next = [&]() -> std::optional<Paths> {
      if (begun == starts.size()) return std::nullopt;
      Paths paths;
      for (const std::size_t last = std::min(begun + batch, starts.size()); begun < last; ++begun)
        paths.push_back({begun, starts[begun]});
      tracking_.add(legs_of(pointers(paths), there, 0));
      return paths;
    };
    ends_.resize(starts.size());
    std::optional<Paths> moving = begin_next(), arriving;
    while (moving || arriving) {
      std::optional<Paths> next = begin_next();
      if (moving) {
        sort_advanced(*moving, tracking_.take(stopped_, work_), 1, first_radius);
        tracking_.add(legs_of(pointers(*moving), rest, direct_step));
      }
      if (arriving) {
        sort_arrived(*arriving, tracking_.take(stopped_, work_));
        for (ActivePath& path : *arriving) path.before = path.x;
        std::ranges::move(*arriving, std::back_inserter(paths_));
        approached_ = std::min(approached_ + batch, starts.size());
        progress();
      }
      arriving = std::exchange(moving, std::move(next));
    }
  }

  /// The others, all together: their legs are so short that few at once would leave threads and processes without any.
  std::vector<PathEnd> walk_around_ends(const std::function<void()>& progress) {
    for (double radius = first_radius; !paths_.empty() && !stopped_(); radius *= radius_ratio) {
      if (radius < smallest_radius) {
        sort_arrived(paths_, follow(pointers(paths_), radius, 0));
        drop(paths_, "the circles around its end did not agree");
        break;
      }
      walk(paths_, radius);
      decide(paths_, radius);
      confirm_poles(paths_, radius);
      arrive_at_regular_ends();
      progress();
      advance(paths_, radius, radius * radius_ratio);
    }
    progress();
    if (stopped_())
      for (const ActivePath& path : paths_)
        ends_[path.number] = {PathEnd::Kind::stopped, path.x, 1, 0, true, "stopped on the way"};
    return std::move(ends_);
  }

  /// Of the whole way. A path that does not simply arrive is halfway when it comes to the last tenth.
  double done() const {
    const std::size_t ended = approached_ - paths_.size();
    return 0.5 * static_cast<double>(approached_ + ended) / static_cast<double>(ends_.size());
  }

 private:
  std::vector<LegResult> follow(const std::vector<ActivePath*>& paths, Complex first, Complex last) {
    const Route route = segment(from_, to_, first, last);
    return tracking_.follow(legs_of(paths, route, 0), stopped_, work_);
  }

  static std::vector<Leg> legs_of(const std::vector<ActivePath*>& paths, const Route& route,
                                  double shortest_step) {
    std::vector<Leg> legs;
    for (const ActivePath* path : paths) legs.push_back({path->x.data(), &route, shortest_step});
    return legs;
  }

  static std::vector<ActivePath*> pointers(Paths& paths) {
    std::vector<ActivePath*> result;
    for (ActivePath& path : paths) result.push_back(&path);
    return result;
  }

  /// All paths from one σ to another; what is lost on the way has failed.
  void advance(Paths& paths, double first, double last) {
    sort_advanced(paths, follow(pointers(paths), first, last), first, last);
  }

  void sort_advanced(Paths& paths, const std::vector<LegResult>& results, double first, double last) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      paths[i].is_lost = results[i].state.end != LegEnd::arrived;
      if (paths[i].is_lost) continue;
      const double power = std::log(largest(results[i].x) / largest(paths[i].x)) / std::log(first / last);
      paths[i].is_steady = std::abs(power - paths[i].power) <= steady_power || last <= waiting_ends ||
                           largest(results[i].x) >= far_away;
      paths[i].power = power;
      paths[i].x = results[i].x;
    }
    if (!stopped_()) remove_lost(paths, "its steps became too small");
  }

  void remove_lost(Paths& paths, const std::string& cause) {
    std::erase_if(paths, [&](const ActivePath& path) {
      if (path.is_lost)
        ends_[path.number] = path.between
                                 ? singular_end(*path.between)
                                 : PathEnd{PathEnd::Kind::failed, path.x, 1, 0, false, cause, path.before};
      return path.is_lost;
    });
  }

  void drop(Paths& paths, const std::string& cause) {
    for (ActivePath& path : paths) path.is_lost = true;
    remove_lost(paths, cause);
  }

  /// Takes out the paths that simply arrived at σ = 0.
  void sort_arrived(Paths& paths, const std::vector<LegResult>& results) {
    for (std::size_t i = 0; i < paths.size(); ++i)
      if (results[i].state.end == LegEnd::arrived)
        ends_[paths[i].number] = {PathEnd::Kind::regular, results[i].x, 1, 0, true, ""};
    remove_ended(paths);
  }

  /// Paths on rounds of σ = radius·e^(iφ): so many sides of them are done.
  struct Walkers {
    std::vector<ActivePath*> paths;
    int sides = 0;
  };

  /// Rounds until every steady path is back at its start. While the legs of one half, or of one batch, are awaited, those of
  /// the others are followed.
  void walk(Paths& paths, double radius) {
    std::vector<ActivePath*> steady;
    for (ActivePath& path : paths) {
      path.samples.clear();
      path.is_closed = false;
      if (path.is_steady) steady.push_back(&path);
    }
    std::vector<ComplexVectorX> starts;
    for (const ActivePath& path : paths) starts.push_back(path.x);
    const std::size_t at_once = std::clamp<std::size_t>((steady.size() + 1) / 2, 1, batch);
    std::deque<Walkers> walking;
    for (std::size_t begun = 0; begun < steady.size(); begun += at_once) {
      const std::span<ActivePath*> some =
          std::span(steady).subspan(begun).first(std::min(at_once, steady.size() - begun));
      go_on({{some.begin(), some.end()}}, radius, walking);
    }
    while (!walking.empty()) {
      Walkers first = std::move(walking.front());
      walking.pop_front();
      take_side(first);
      go_on(std::move(first), radius, walking);
    }
    // A walk that did not close goes on from where it began.
    for (std::size_t i = 0; i < paths.size(); ++i) paths[i].x = starts[i];
    if (!stopped_()) remove_lost(paths, "its steps became too small around the end");
  }

  /// Along the next side, unless all have ended.
  void go_on(Walkers walkers, double radius, std::deque<Walkers>& walking) {
    if (walkers.paths.empty() || walkers.sides == corners * most_rounds || stopped_()) return;
    const auto place = [radius](int corner) {
      return corner % corners == 0 ? radius : std::polar(radius, 2 * std::numbers::pi * corner / corners);
    };
    const int corner = walkers.sides % corners;
    for (ActivePath* path : walkers.paths) path->samples.push_back(path->x);
    const Route side = segment(from_, to_, place(corner), place(corner + 1));
    tracking_.add(legs_of(walkers.paths, side, 0));
    walking.push_back(std::move(walkers));
  }

  /// Of those whose legs were added first.
  void take_side(Walkers& walkers) {
    std::vector<ActivePath*>& paths = walkers.paths;
    const std::vector<LegResult> results = tracking_.take(stopped_, work_);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      paths[i]->x = results[i].x;
      paths[i]->is_lost = results[i].state.end != LegEnd::arrived;
    }
    std::erase_if(paths, [](const ActivePath* path) { return path->is_lost; });
    if (++walkers.sides % corners != 0) return;
    for (ActivePath* path : paths)
      path->is_closed = distance(path->x, path->samples.front()) <= closed * largest(path->x);
    std::erase_if(paths, [](const ActivePath* path) { return path->is_closed; });
  }

  void decide(Paths& paths, double radius) {
    for (ActivePath& path : paths) {
      if (!path.is_closed) {
        path.last.reset();
        continue;
      }
      CircleReading reading = read_circle(path.samples, radius);
      if (path.last) conclude(path, *path.last, reading, radius);
      path.last = std::move(reading);
    }
    remove_ended(paths);
  }

  void remove_ended(Paths& paths) const {
    std::erase_if(paths,
                  [&](const ActivePath& path) { return ends_[path.number].kind != PathEnd::Kind::failed; });
  }

  /// Where a circle reads a pole, a second one next to it. A pole elsewhere, between the two or within, shows in lower powers.
  void confirm_poles(Paths& paths, double radius) {
    Paths poles;
    for (const ActivePath& path : paths)
      if (path.last && path.last->kind == CircleReading::Kind::pole) poles.push_back(path);
    for (ActivePath& pole : poles) pole.between.reset();
    advance(poles, radius, radius * pole_ratio);
    for (ActivePath& path : poles) path.is_steady = true;
    walk(poles, radius * pole_ratio);
    decide(poles, radius * pole_ratio);
    remove_ended(paths);
  }

  /// Of a circle that encloses the ends of several paths the constant term lies between these.
  bool may_lie_between(const CircleReading& reading, double radius) const {
    return reading.winding_number > 1 && radius * radius_ratio >= smallest_radius &&
           !is_zero_(reading.leading);
  }

  void conclude(ActivePath& path, const CircleReading& before, const CircleReading& now, double radius) {
    if (before.kind != now.kind || before.winding_number != now.winding_number ||
        before.pole_order != now.pole_order)
      return;
    const double change = distance(before.leading, now.leading) / largest(now.leading);
    if (now.kind == CircleReading::Kind::pole && now.is_at_infinity() && change <= agreed_pole)
      ends_[path.number] = {
          PathEnd::Kind::at_infinity, path.x, now.winding_number, now.pole_order, true, "", path.before};
    if (now.kind != CircleReading::Kind::finite || change > agreed_end) return;
    if (may_lie_between(now, radius))
      path.between = now;
    else
      ends_[path.number] = singular_end(now);
  }

  static PathEnd singular_end(const CircleReading& reading) {
    return {PathEnd::Kind::singular, reading.leading, reading.winding_number, 0, false, ""};
  }

  /// A path that closes after one round and has a constant term may end at a regular point, beside a pole.
  void arrive_at_regular_ends() {
    const Route there = segment(from_, to_, 0, 0);
    std::vector<std::size_t> numbers;
    std::vector<Leg> legs;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (ends_[i].kind != PathEnd::Kind::singular || ends_[i].winding_number > 1 || ends_[i].is_settled)
        continue;
      numbers.push_back(i);
      legs.push_back({ends_[i].x.data(), &there});
    }
    const std::vector<LegResult> results = tracking_.follow(legs, stopped_, work_);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      PathEnd& end = ends_[numbers[i]];
      end.is_settled = true;
      if (results[i].state.end != LegEnd::arrived) continue;
      end.kind = PathEnd::Kind::regular;
      end.x = results[i].x;
    }
  }

  LegTracking& tracking_;
  const ComplexVectorX& from_;
  const ComplexVectorX& to_;
  const std::function<bool(const ComplexVectorX&)>& is_zero_;
  const std::function<bool()>& stopped_;
  WorkCounters& work_;
  std::vector<PathEnd> ends_;
  Paths paths_;                 // that have not ended
  std::size_t approached_ = 0;  // of the starts
};

}  // namespace

std::vector<PathEnd> follow_to_end(LegTracking& tracking, const std::vector<ComplexVectorX>& starts,
                                   const ComplexVectorX& from, const ComplexVectorX& to,
                                   const std::function<bool(const ComplexVectorX&)>& is_zero,
                                   const std::function<bool()>& stopped,
                                   const std::function<void(double)>& progress, WorkCounters& work) {
  Endgame endgame(tracking, from, to, is_zero, stopped, work);
  const auto report = [&] { progress(endgame.done()); };
  progress(0);
  if (starts.empty()) return {};
  endgame.approach_ends(starts, report);
  return endgame.walk_around_ends(report);
}

std::vector<ComplexVectorX> follow_to_radius(LegTracking& tracking, std::vector<ComplexVectorX> starts,
                                             const ComplexVectorX& from, const ComplexVectorX& to,
                                             double radius, const std::function<bool()>& stopped,
                                             WorkCounters& work) {
  double last = 1;
  for (const double next : {std::max(first_radius, radius), radius}) {
    if (next >= last) continue;
    const Route route = segment(from, to, last, next);
    std::vector<Leg> legs;
    std::vector<ComplexVectorX*> moved;
    for (ComplexVectorX& x : starts) {
      if (x.empty()) continue;
      legs.push_back({x.data(), &route});
      moved.push_back(&x);
    }
    std::vector<LegResult> results = tracking.follow(legs, stopped, work);
    for (std::size_t i = 0; i < moved.size(); ++i)
      *moved[i] = results[i].state.end == LegEnd::arrived ? std::move(results[i].x) : ComplexVectorX();
    last = next;
  }
  return starts;
}

void settle(const MonomialSystem& system, const ComplexVectorX& coefficients, int threads,
            std::vector<PathEnd>& ends) {
  const auto value = [&](const ComplexVectorX& x) { return values_at(system, coefficients, x).value; };
  const auto jacobian = [&](const ComplexVectorX& x) { return jacobian_at(system, coefficients, x); };
  std::vector<PathEnd*> open;  // few, and often none
  for (PathEnd& end : ends)
    if (may_be_regular(end)) open.push_back(&end);
  share_on_threads(open.size(), threads, [&](std::size_t i) { settle_one(value, jacobian, *open[i]); });
}

void settle(const SquareSystem& system, const ComplexVectorX& squares, int threads,
            std::vector<PathEnd>& ends) {
  const auto value = [&](const ComplexVectorX& x) {
    ComplexVectorX off = squares_at(system, x);
    for (std::size_t e = 0; e < off.size(); ++e) off[e] = (off[e] - squares[e]) / 2.0;
    return off;
  };
  const auto jacobian = [&](const ComplexVectorX& x) { return jacobian_at(system, x); };
  share_on_threads(ends.size(), threads, [&](std::size_t i) {
    PathEnd& end = ends[i];
    const bool is_rough = end.kind == PathEnd::Kind::regular && !is_zero_at(system, squares, end.x);
    if (may_be_regular(end) || is_rough) settle_one(value, jacobian, end);
  });
}

}  // namespace gcs
