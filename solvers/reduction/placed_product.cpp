#include "solvers/reduction/placed_product.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solvers/figures/complex_distances.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

/// Of one step's places, each a matter of a millisecond.
constexpr std::int64_t most_solves = 20'000;

}  // namespace

PlacedProduct::PlacedProduct(const Scene& scene, const ElementOrder& order, const SceneSystem& system,
                             const GeneralEquations& equations, std::vector<PlacedWay> core,
                             std::vector<PlacedStep>& steps, const std::stop_token& stop, WorkCounters& work)
    : scene_(scene),
      squares_(target_squares(scene)),
      order_(order),
      system_(system),
      equations_(equations),
      core_(std::move(core)),
      steps_(steps),
      stop_(stop),
      work_(work),
      choices_(steps.size()),
      ways_(steps.size()),
      solved_for_(steps.size()) {}

bool PlacedProduct::is_exhausted() const { return solves_ > most_solves || stop_.stop_requested(); }

bool PlacedProduct::is_real_before(int step) const {
  const auto& after = order_.steps[static_cast<std::size_t>(step)].after;
  return core_[core_choice_].way.is_real && std::ranges::all_of(after, [&](int other) {
           const auto i = static_cast<std::size_t>(other);
           return (steps_[i].given ? *steps_[i].given : ways_[i])[choices_[i]].way.is_real;
         });
}

/// Precondition: what the step depends on is chosen.
const std::vector<PlacedWay>& PlacedProduct::ways(int step) {
  const auto i = static_cast<std::size_t>(step);
  if (steps_[i].given) return *steps_[i].given;
  std::vector<std::size_t> now{core_choice_};
  for (const int other : order_.steps[i].after) now.push_back(choices_[static_cast<std::size_t>(other)]);
  if (now == solved_for_[i]) return ways_[i];
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
  Natural sum;
  for (core_choice_ = 0; core_choice_ < core_.size(); ++core_choice_) {
    x_ = core_[core_choice_].way.values;
    if (!only_real || core_[core_choice_].way.is_real) sum += weigh(all, only_real);
  }
  return is_exhausted() ? std::nullopt : std::optional(sum);
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
  for (core_choice_ = 0; core_choice_ < core_.size(); ++core_choice_) {
    x_ = core_[core_choice_].way.values;
    if (!only_real || core_[core_choice_].way.is_real) list_from(0);
  }
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

/// In the scene's own frame: of a line, where the equations are in one of points.
Figure PlacedProduct::framed(const Figure& figure) const {
  if (figure.is_real() || scene_.is_anchored() || scene_.problem().is_general()) return figure;
  return polished(scene_, squares_, scene_.in_frame(figure));
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
  take(core_[core_choice_]);
  bool is_followed = false;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    is_followed = is_followed || steps_[i].solver;
    take((steps_[i].given ? *steps_[i].given : ways_[i])[choices_[i]]);
  }
  ComplexVectorX x = x_;
  if (is_followed && is_polished && !newton(equations_.system, equations_.coefficients, x)) x = x_;
  result.figure = framed(system_.figure(x, is_real));
  return result;
}

}  // namespace gcs
