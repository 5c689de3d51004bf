#include "solvers/reduction/placed_product.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gcs {
namespace {

/// Of one step's places, each a matter of a millisecond.
constexpr std::int64_t most_solves = 20'000;

}  // namespace

PlacedProduct::PlacedProduct(const Scene& scene, const ElementOrder& order, const SceneSystem& system,
                             const GeneralEquations& equations, std::vector<PlacedStep>& steps,
                             const std::stop_token& stop, WorkCounters& work)
    : to_frame_(scene, order.scene),
      order_(order),
      system_(system),
      equations_(equations),
      steps_(steps),
      stop_(stop),
      work_(work),
      x_(static_cast<std::size_t>(equations.system.unknowns)),
      choices_(steps.size()),
      ways_(steps.size()),
      solved_for_(steps.size()) {}

bool PlacedProduct::is_exhausted() const { return solves_ > most_solves || stop_.stop_requested(); }

bool PlacedProduct::is_real_before(int step) const {
  const auto& after = order_.steps[static_cast<std::size_t>(step)].after;
  return std::ranges::all_of(after, [&](int other) {
    const auto i = static_cast<std::size_t>(other);
    return (steps_[i].given ? *steps_[i].given : ways_[i])[choices_[i]].way.is_real;
  });
}

/// Precondition: what the step depends on is chosen.
const std::vector<PlacedWay>& PlacedProduct::ways(int step) {
  const auto i = static_cast<std::size_t>(step);
  if (steps_[i].given) return *steps_[i].given;
  std::vector<std::size_t> now;
  for (const int other : order_.steps[i].after) now.push_back(choices_[static_cast<std::size_t>(other)]);
  if (solved_for_[i] == now) return ways_[i];
  solved_for_[i] = std::move(now);
  ways_[i].clear();
  ++solves_;
  for (StepWay& way : steps_[i].solver->ways(x_, is_real_before(step), work_))
    ways_[i].push_back({std::move(way)});
  return ways_[i];
}

void PlacedProduct::choose(int step, std::size_t number) {
  const auto i = static_cast<std::size_t>(step);
  choices_[i] = number;
  const ComplexVectorX& values = ways(step)[number].way.values;
  for (std::size_t k = 0; k < values.size(); ++k)
    x_[static_cast<std::size_t>(order_.steps[i].unknowns[k])] = values[k];
}

// ---- counting

std::optional<Natural> PlacedProduct::count(bool only_real) {
  solves_ = 0;
  std::vector<int> all(steps_.size());
  std::iota(all.begin(), all.end(), 0);
  const Natural number = weigh(all, only_real);
  return is_exhausted() ? std::nullopt : std::optional(number);
}

Natural PlacedProduct::weigh(const std::vector<int>& open, bool only_real) {
  Natural product = 1;
  for (const std::vector<int>& together : connected(open)) {
    product = product * weigh_connected(together, only_real);
    if (product.is_zero()) break;
  }
  return product;
}

/// The first of `open` depends on nothing that is open.
Natural PlacedProduct::weigh_connected(const std::vector<int>& open, bool only_real) {
  if (is_exhausted()) return 0;
  if (const auto& totals = steps_[static_cast<std::size_t>(open.front())].totals)
    return (only_real ? totals->real : totals->complex).value_or(Natural(0));
  const std::vector<PlacedWay>& found = ways(open.front());
  const auto counts = [only_real](const PlacedWay& way) { return !only_real || way.way.is_real; };
  if (open.size() == 1) return Natural(static_cast<std::uint64_t>(std::ranges::count_if(found, counts)));
  const std::vector<int> rest(open.begin() + 1, open.end());
  Natural sum;
  for (std::size_t number = 0; number < found.size(); ++number) {
    if (!counts(found[number])) continue;
    choose(open.front(), number);
    sum += weigh(rest, only_real);
  }
  return sum;
}

/// Steps that depend on each other, also by way of others that are open.
std::vector<std::vector<int>> PlacedProduct::connected(const std::vector<int>& open) const {
  std::vector<std::vector<int>> groups;
  for (const int step : open) {
    std::vector<int> group;
    const auto& after = order_.steps[static_cast<std::size_t>(step)].after;
    std::erase_if(groups, [&](const std::vector<int>& other) {
      if (std::ranges::find_first_of(other, after) == other.end()) return false;
      group.insert(group.end(), other.begin(), other.end());
      return true;
    });
    group.push_back(step);
    std::ranges::sort(group);
    groups.push_back(std::move(group));
  }
  return groups;
}

// ---- listing

std::vector<Candidate> PlacedProduct::list(bool only_real, std::size_t limit) {
  only_real_ = only_real;
  limit_ = limit;
  list_from(0);
  return std::move(listed_);
}

void PlacedProduct::list_from(int step) {
  if (listed_.size() >= limit_ || stop_.stop_requested()) return;
  if (step == static_cast<int>(steps_.size())) return listed_.push_back(candidate());
  for (std::size_t number = 0; number < ways(step).size(); ++number) {
    if (only_real_ && !ways(step)[number].way.is_real) continue;
    choose(step, number);
    list_from(step + 1);
  }
}

/// Nearer to a zero, whether or not Newton's method settles there.
ComplexVectorX PlacedProduct::polished(const ComplexVectorX& x) const {
  const auto misfit = [&](const ComplexVectorX& at) {
    return largest(values_at(equations_.system, equations_.coefficients, at).value);
  };
  ComplexVectorX result = x;
  newton(equations_.system, equations_.coefficients, result);
  return misfit(result) <= misfit(x) ? result : x;
}

/// Ways that were followed are polished together with all that they hang on.
Candidate PlacedProduct::candidate() const {
  Candidate result;
  bool is_real = true, is_polished = true;
  result.error = 0;
  const auto take = [&](const PlacedWay& placed) {
    is_real = is_real && placed.way.is_real;
    is_polished = is_polished && placed.way.multiplicity == 1;
    result.multiplicity *= placed.way.multiplicity;
    result.error = std::max(result.error, placed.error);
  };
  bool is_followed = false;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    is_followed = is_followed || steps_[i].solver;
    take((steps_[i].given ? *steps_[i].given : ways_[i])[choices_[i]]);
  }
  const ComplexVectorX x = is_followed && is_polished ? polished(x_) : x_;
  result.figure = to_frame_(system_.figure(x, is_real), is_polished);
  if (to_frame_.moves_bodies()) result.error = std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace gcs
