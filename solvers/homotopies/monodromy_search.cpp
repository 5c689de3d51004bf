#include "solvers/homotopies/monodromy_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <utility>

#include "solvers/homotopies/distinct_ends.hpp"

namespace gcs {
namespace {

/// The solutions known for one choice of lengths, and where each arc leads from them.
struct Node {
  ComplexVectorX squares;
  SolutionSet solutions;
  std::vector<std::vector<int>> images{};  ///< [arc][solution]: of the other node, or a mark below
  std::vector<int> next{};                 ///< [arc]: solutions before this one have been followed

  static constexpr int open = -1, followed = -2;
};

/// How many of the legs along an arc that were followed lately led to new solutions.
struct Yield {
  double tried = 0;
  double fresh = 0;
};

/// A leg from solution `solution` of node `node` along arc `arc`.
struct Task {
  int node = 0;
  int arc = 0;
  int solution = 0;
};

bool is_homogeneous(const SquareSystem& system) {
  return system.linear.empty() &&
         std::all_of(system.differences.begin(), system.differences.end(),
                     [](const Difference& d) { return d.constant == 0; }) &&
         std::all_of(system.given.begin(), system.given.end(), [](double given) { return given == 0; });
}

/// While the ends of the first are sorted in, or the last of its legs is waited for, legs of the others are followed: one that
/// doubles cannot follow takes as long as many others.
constexpr std::size_t blocks_at_once = 8;

/// Two arcs lead to nearly all solutions, a third to most of the rest. What is missing then has its branch points far from
/// where arcs of the usual bend run: further ones are longer, and seldom followed from every solution.
constexpr int near_arcs = 3;
constexpr double far_bend = 10;

/// Solutions may fall into blocks, the more of them the more solutions there are, that single arcs do not leave.
int first_arcs(const MonodromyOptions& options, const std::optional<std::uint64_t>& count) {
  const int arcs = count ? 2 + static_cast<int>(std::bit_width(*count)) / 3 : 0;
  return std::min(std::max(options.first_arcs, arcs), options.arcs);
}

std::complex<double> random_turn(double least, double most, std::mt19937_64& random) {
  return std::polar(1.0, std::uniform_real_distribution<double>(least, most)(random));
}

/// γ, whose square turns real lengths away from others: branch points of the way crowd where γ² is real. Of 5° to 85° these
/// take the fewest steps, a half to a third of those at either end.
std::complex<double> turn_from_the_real(std::mt19937_64& random) {
  return random_turn(std::numbers::pi / 8, std::numbers::pi / 4, random);
}

ComplexVectorX scaled(ComplexVectorX x, std::complex<double> factor) {
  for (std::complex<double>& value : x) value *= factor;
  return x;
}

class Search {
 public:
  Search(const HomotopyFamily& family, const Completeness& completeness, const MonodromyOptions& options,
         std::mt19937_64& random)
      : family_(family), completeness_(completeness), options_(options), random_(random) {
    const FamilyMember start = (is_real() ? family.real_member : family.random_member)(random);
    const FamilyMember other = family.random_member(random);
    for (const FamilyMember& member : {start, other})
      nodes_.push_back({member.parameters, SolutionSet(family.signs, random)});
    if (is_real()) turn_ = turn_from_the_real(random);
    add(0, start.x, 0);
    while (arcs() < first_arcs(options, completeness.count)) add_arc();
  }

  GenericSolutions run(LegTracking& tracking, const std::function<bool()>& stopped,
                       const std::function<void(int)>& progress, WorkCounters& work) {
    while (!is_over() && !stopped()) {
      while (legs_under_way() < legs_at_once() && hand_out(tracking)) continue;
      if (followed_.empty()) {
        if (is_quiet_and_done()) break;
        add_arc();
        continue;
      }
      sort_in(tracking.take(stopped, work));
      progress(nodes_[0].solutions.size());
    }
    tracking.give_up();
    nodes_.pop_back();  // what is returned may be large
    return found();
  }

 private:
  std::uint64_t size() const { return static_cast<std::uint64_t>(nodes_[0].solutions.size()); }

  bool is_over() {
    const std::optional<std::uint64_t>& count = completeness_.count;
    if (!consistent_ || (count && size() > *count))
      found_.end = SearchEnd::inconsistent;
    else if (count && size() == *count)
      found_.end = SearchEnd::complete;
    return found_.end != SearchEnd::stopped;
  }

  /// Precondition: nothing is left to follow.
  bool is_quiet_and_done() {
    if (completeness_.test && completeness_.test(found()))
      found_.end = SearchEnd::complete;
    else if (arcs() == options_.arcs)
      found_.end = SearchEnd::quiet;
    return found_.end != SearchEnd::stopped;
  }

  GenericSolutions found() const {
    GenericSolutions found = found_;
    found.squares = scaled(nodes_[0].squares, turn_ * turn_);
    for (const ComplexVectorX& x : nodes_[0].solutions.solutions())
      found.solutions.push_back(scaled(x, turn_));
    found.arcs_used = arcs();
    return found;
  }

  int arcs() const { return static_cast<int>(gammas_.size()); }
  bool is_real() const { return static_cast<bool>(family_.real_member); }

  /// The more are known, the more, so that threads and processes seldom wait for each other's last legs: but those that are
  /// handed out when the last solution is found are followed in vain, and those before know less of what is new.
  std::size_t legs_at_once() const {
    constexpr std::size_t fewest = 8;  // the lanes of one thread
    return std::max<std::size_t>(size() / 32, fewest);
  }

  std::size_t legs_under_way() const {
    std::size_t legs = 0;
    for (const std::vector<Task>& tasks : followed_) legs += tasks.size();
    return legs;
  }

  std::size_t legs_of_block() const {
    constexpr std::size_t fewest = 4;
    return std::max(legs_at_once() / blocks_at_once, fewest);
  }

  /// The next legs to follow, at most `most`, along the first arcs of which something new is to be expected. None, where the
  /// results of such arcs are awaited; where there are none, along one more arc, or whatever is left.
  std::vector<Task> next_tasks(std::size_t most) {
    std::vector<Task> tasks;
    bool are_dull = true;
    for (int arc = 0; arc < arcs(); ++arc) {
      if (is_dull(arc)) continue;
      are_dull = false;
      take_tasks(arc, most, tasks);
    }
    if (!tasks.empty() || (!are_dull && !followed_.empty())) return tasks;
    if (completeness_.count && arcs() < options_.arcs) add_arc();
    for (int arc = arcs() - 1; arc >= 0; --arc) take_tasks(arc, most, tasks);
    return tasks;
  }

  /// The share of solutions that are not known, of the count.
  double missing() const {
    const double count = static_cast<double>(*completeness_.count);
    return std::max(1.0, count - static_cast<double>(size())) / count;
  }

  /// Whether an arc that permutes solutions at random would have led to many more new ones. In the first four expected ones
  /// none is new by such chance one time in fifty.
  bool is_dull(int arc) const {
    if (!completeness_.count) return false;
    const Yield& yield = yields_[arc];
    const double expected = yield.tried * missing();
    return expected >= expected_at_least && yield.fresh < expected / 4;
  }

  /// False where there is nothing to follow.
  bool hand_out(LegTracking& tracking) {
    std::vector<Task> tasks = next_tasks(legs_of_block());
    if (tasks.empty()) return false;
    std::vector<ComplexVectorX> starts;
    for (const Task& task : tasks) starts.push_back(start_of(task));
    std::vector<Leg> legs;
    for (std::size_t i = 0; i < tasks.size(); ++i)
      legs.push_back({starts[i].data(), &routes_[2 * tasks[i].arc + tasks[i].node]});
    tracking.add(legs);
    found_.legs += static_cast<std::int64_t>(tasks.size());
    followed_.push_back(std::move(tasks));
    return true;
  }

  /// Of the tasks that were handed out first.
  void sort_in(const std::vector<LegResult>& results) {
    const std::vector<Task> tasks = std::move(followed_.front());
    followed_.pop_front();
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (results[i].state.end == LegEnd::arrived)
        arrive(tasks[i], results[i].x, results[i].state.last_correction);
      else
        ++found_.lost_legs;
    }
  }

  ComplexVectorX start_of(const Task& task) const {
    const ComplexVectorX& x = nodes_[task.node].solutions[task.solution];
    return task.node == 0 ? x : scaled(x, gammas_[task.arc]);
  }

  /// Sorts in the end of the task's leg.
  void arrive(const Task& task, const ComplexVectorX& end, double uncertainty) {
    const int other = 1 - task.node, before = nodes_[other].solutions.size();
    const int number = add(other, other == 1 ? scaled(end, 1.0 / gammas_[task.arc]) : end, uncertainty);
    count_in(nodes_[other].solutions.size() > before, yields_[task.arc]);
    int& back = nodes_[other].images[task.arc][number];
    if (back >= 0 && back != task.solution) consistent_ = false;
    back = task.solution;
    nodes_[task.node].images[task.arc][task.solution] = number;
  }

  /// What was long ago counts less and less.
  void count_in(bool is_fresh, Yield& yield) const {
    yield.tried += 1;
    yield.fresh += is_fresh ? 1 : 0;
    if (!completeness_.count || yield.tried * missing() < 2 * expected_at_least) return;
    yield.tried /= 2;
    yield.fresh /= 2;
  }

  void add_arc() {
    const std::complex<double> gamma =
        family_.is_homogeneous ? random_turn(0, 2 * std::numbers::pi, random_) : 1.0;
    const bool is_far = arcs() >= near_arcs;
    const double size = is_far ? far_bend * options_.bend : options_.bend;
    const ComplexVectorX first = random_bend(size),
                         second = is_far || options_.has_two_bends ? random_bend(size) : first;
    gammas_.push_back(gamma);
    yields_.emplace_back();
    routes_.push_back(route(nodes_[0].squares, scaled(nodes_[1].squares, gamma * gamma), first, second));
    routes_.push_back(route(scaled(nodes_[1].squares, gamma * gamma), nodes_[0].squares, second, first));
    for (Node& node : nodes_) {
      node.images.emplace_back(node.solutions.size(), Node::open);
      node.next.push_back(0);
    }
  }

  /// `relative`: to the lengths.
  ComplexVectorX random_bend(double relative) {
    ComplexVectorX bend = random_complex_vector(static_cast<int>(family_.is_free.size()), random_);
    for (std::size_t e = 0; e < bend.size(); ++e) {
      const double size = std::sqrt(std::abs(nodes_[0].squares[e]) * std::abs(nodes_[1].squares[e]));
      bend[e] *= family_.is_free[e] ? relative * size : 0;
    }
    return bend;
  }

  /// (1 − s) from + s to + s(1 − s)((1 − s) first + s second)
  static Route route(const ComplexVectorX& from, const ComplexVectorX& to, const ComplexVectorX& first,
                     const ComplexVectorX& second) {
    Route route;
    route.end = to;
    for (std::size_t e = 0; e < from.size(); ++e) {
      const std::complex<double> turn = second[e] - first[e];
      route.coefficients[0].push_back(from[e]);
      route.coefficients[1].push_back(to[e] - from[e] + first[e]);
      route.coefficients[2].push_back(turn - first[e]);
      route.coefficients[3].push_back(first[e] - second[e]);
    }
    return route;
  }

  /// With its conjugate, where that is one for the same lengths.
  int add(int node, const ComplexVectorX& x, double uncertainty) {
    SolutionSet& solutions = nodes_[node].solutions;
    const int before = solutions.size(), number = solutions.insert(x, uncertainty);
    if (node == 0 && is_real() && solutions.size() > before) solutions.insert(conjugate(x), uncertainty);
    for (std::vector<int>& images : nodes_[node].images)
      images.resize(static_cast<std::size_t>(solutions.size()), Node::open);
    return number;
  }

  /// From the solutions of one node; where it has none left, from those of the other, so that legs and their reverses are
  /// seldom followed at once.
  void take_tasks(int arc, std::size_t most, std::vector<Task>& tasks) {
    const std::size_t before = tasks.size();
    for (int node = 0; node < 2 && tasks.size() == before; ++node) take_tasks(node, arc, most, tasks);
  }

  void take_tasks(int node, int arc, std::size_t most, std::vector<Task>& tasks) {
    int& next = nodes_[node].next[arc];
    for (; tasks.size() < most && next < nodes_[node].solutions.size(); ++next) {
      int& image = nodes_[node].images[arc][next];
      if (image != Node::open) continue;
      image = Node::followed;
      tasks.push_back({node, arc, next});
    }
  }

  static constexpr double expected_at_least = 4;  ///< new solutions, before an arc is judged

  const HomotopyFamily& family_;
  const Completeness& completeness_;
  const MonodromyOptions options_;
  std::mt19937_64& random_;
  std::vector<Node> nodes_;
  std::complex<double> turn_ = 1;           // of what is returned
  ComplexVectorX gammas_;                   // of each arc
  std::vector<Yield> yields_;               // of each arc
  std::vector<Route> routes_;               // of each arc: from node 0, then from node 1
  std::deque<std::vector<Task>> followed_;  // in the order in which they were handed out
  bool consistent_ = true;
  GenericSolutions found_;  ///< but for the lengths, solutions and arcs
};

/// Of points at random, real but for their coordinates along the first axis of a frame in space, which are imaginary.
FamilyMember member_of_real_squares(const SquareSystem& system, const SignMasks& signs,
                                    std::mt19937_64& random) {
  constexpr SignMask first_axis = 1;
  const bool is_in_space = signs.rank() == 3;
  ComplexVectorX x = random_complex_vector(system.unknowns, random);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = is_in_space && signs[i] == first_axis ? std::complex<double>(0, x[i].real()) : x[i].real();
  ComplexVectorX squares = squares_at(system, x);
  return {std::move(x), std::move(squares)};
}

/// Solutions next to lengths that are nearly 0 are nearly double.
constexpr int draws_of_real_squares = 16;

/// The smallest of some squares over the largest.
double smallest_share(const ComplexVectorX& squares) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const std::complex<double>& square : squares) {
    least = std::min(least, std::abs(square));
    most = std::max(most, std::abs(square));
  }
  return least / most;
}

}  // namespace

HomotopyFamily square_family(const SquareSystem& system, SignMasks signs, std::vector<bool> is_free,
                             std::function<ComplexVectorX(std::mt19937_64&)> random_point) {
  return {std::move(signs), std::move(is_free), is_homogeneous(system),
          [&system, random_point = std::move(random_point)](std::mt19937_64& random) {
            ComplexVectorX x = random_point(random);
            ComplexVectorX parameters = squares_at(system, x);
            return FamilyMember{std::move(x), std::move(parameters)};
          }};
}

HomotopyFamily all_lengths(const SquareSystem& system, SignMasks signs) {
  HomotopyFamily family = square_family(
      system, std::move(signs), std::vector<bool>(system.given.size(), true),
      [n = system.unknowns](std::mt19937_64& random) { return random_complex_vector(n, random); });
  if (!family.is_homogeneous) return family;
  family.real_member = [&system, signs = family.signs](std::mt19937_64& random) {
    FamilyMember member = member_of_real_squares(system, signs, random);
    for (int draw = 1; draw < draws_of_real_squares; ++draw) {
      FamilyMember other = member_of_real_squares(system, signs, random);
      if (smallest_share(other.parameters) > smallest_share(member.parameters)) member = std::move(other);
    }
    return member;
  };
  return family;
}

GenericSolutions search_by_monodromy(const HomotopyFamily& family, LegTracking& tracking,
                                     const Completeness& completeness, const MonodromyOptions& options,
                                     std::mt19937_64& random, const std::function<bool()>& stopped,
                                     const std::function<void(int)>& progress, WorkCounters& work) {
  return Search(family, completeness, options, random).run(tracking, stopped, progress, work);
}

}  // namespace gcs
