#include "solvers/construction/derive.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace gcs {
namespace {

constexpr int exact_limit = 20;  // 2^20 sets of points; beyond, the table would outgrow the solve

struct Neighbour {
  int point;
  int constraint;
};

using Adjacency = std::vector<std::vector<Neighbour>>;

Adjacency adjacency_of(const ProblemStatement& problem) {
  Adjacency adjacency(problem.points.size());
  for (std::size_t c = 0; c < problem.constraints.size(); ++c) {
    const auto [a, b] = problem.constraints[c].between;
    if (!problem.is_point(a) || !problem.is_point(b)) continue;
    adjacency[a].push_back({b, static_cast<int>(c)});
    adjacency[b].push_back({a, static_cast<int>(c)});
  }
  return adjacency;
}

/// Which points have a given distance from a line.
std::vector<bool> points_beside_lines(const ProblemStatement& problem) {
  std::vector<bool> beside(problem.points.size());
  for (const DistanceConstraint& c : problem.constraints)
    for (const std::size_t end : {0, 1})
      if (!problem.is_point(c.between[1 - end])) beside[c.between[end]] = true;
  return beside;
}

/// The order in which points are placed: which set is placed already, and what the next point costs.
class Ordering {
 public:
  Ordering(const Scene& scene, const Adjacency& adjacency)
      : scene_(scene),
        adjacency_(adjacency),
        dimension_(scene.dimension()),
        anchored_(scene.is_anchored()),
        beside_line_(points_beside_lines(scene.problem())) {
    for (int p = 0; p < scene.point_count(); ++p) placed_.push_back(scene.fixed_point(p).has_value());
  }

  /// Empty where there is none.
  std::vector<int> best() const {
    const auto [cost, order] = greedy();
    if (cost >= impossible) return {};
    return count() <= exact_limit ? exact(cost) : order;
  }
  /// Coordinates that the frame leaves to the next point when `placed` are there.
  int need(int placed) const {
    if (scene_.has_lines()) return placed == 0 ? 1 : dimension_;
    return anchored_ ? dimension_ : std::min(placed, dimension_);
  }

 private:
  static constexpr std::int64_t impossible = std::numeric_limits<std::int64_t>::max() / 4;
  static constexpr int most_shortness = 4096;  ///< more than that of a frame, which has three edges
  int count() const { return static_cast<int>(placed_.size()); }

  /// Of the point p when `placed` are there. Driving parameters first, then how many instructions lie
  /// downstream of them, then how much shorter than the scene the frame is.
  template <class IsPlaced>
  std::int64_t cost(int p, int placed, const IsPlaced& is_placed) const {
    const int wanted = need(placed);
    int known = 0;
    std::int64_t shortness = 0;
    for (const Neighbour& n : adjacency_[p]) {
      if (!is_placed(n.point)) continue;
      ++known;
      if (wanted < dimension_) shortness += shortness_of(n.constraint);
    }
    const bool hangs_on_line = scene_.has_lines() && placed == 0 && beside_line_[p];
    if (wanted > 0 && known == 0 && !hangs_on_line) return impossible;
    if (beside_line_[p]) ++known;
    const std::int64_t driven = std::max(0, wanted - known);
    return (driven * 1'000'000 + driven * (count() - placed)) * most_shortness + shortness;
  }

  /// In powers of two, from 1/8 of the scene's size on: a frame on so short an edge turns by the edge's
  /// rounding.
  std::int64_t shortness_of(int constraint) const {
    constexpr int harmless = 3, most = most_shortness / 4;
    const double length = scene_.target_lengths()[static_cast<std::size_t>(constraint)];
    if (!(length > 0)) return most;
    return std::clamp(std::ilogb(scene_.size() / length) - harmless, 0, most);
  }

  /// Over all sets of placed points that cost no more than `bound`, what some order costs.
  std::vector<int> exact(std::int64_t bound) const {
    std::uint32_t start = 0;
    for (int p = 0; p < count(); ++p) start |= static_cast<std::uint32_t>(placed_[p]) << p;
    const std::uint32_t all = (std::uint32_t{1} << count()) - 1;
    std::vector<std::int64_t> best(std::size_t{all} + 1, impossible);
    std::vector<std::int8_t> last(std::size_t{all} + 1, -1);
    best[start] = 0;
    for (std::uint32_t set = start; set < all; ++set) {
      if (best[set] > bound || best[set] >= impossible) continue;
      const int placed = std::popcount(set);
      for (int p = 0; p < count(); ++p) {
        if (set >> p & 1U) continue;
        const auto is_placed = [set](int point) { return (set >> point & 1U) != 0; };
        const std::int64_t total = best[set] + cost(p, placed, is_placed);
        const std::uint32_t next = set | std::uint32_t{1} << p;
        if (total >= best[next]) continue;
        best[next] = total;
        last[next] = static_cast<std::int8_t>(p);
      }
    }
    std::vector<int> order;
    for (std::uint32_t set = all; set != start; set &= ~(std::uint32_t{1} << order.back()))
      order.push_back(last[set]);
    std::reverse(order.begin(), order.end());
    return order;
  }

  std::pair<std::int64_t, std::vector<int>> greedy_from(int first) const {
    std::vector<bool> placed = placed_;
    std::vector<int> order;
    std::int64_t total = 0;
    int number = static_cast<int>(std::count(placed.begin(), placed.end(), true));
    const int open = count() - number;
    for (int i = 0; i < open; ++i, ++number) {
      int choice = i == 0 && first >= 0 ? first : -1;
      std::int64_t cheapest = choice < 0 ? impossible : 0;
      for (int p = 0; p < count() && !(i == 0 && first >= 0); ++p) {
        if (placed[p]) continue;
        const std::int64_t c = cost(p, number, [&placed](int point) { return placed[point]; });
        if (c < cheapest) {
          cheapest = c;
          choice = p;
        }
      }
      if (choice < 0) return {impossible, {}};
      total += cheapest;
      placed[choice] = true;
      order.push_back(choice);
    }
    return {total, order};
  }

  std::pair<std::int64_t, std::vector<int>> greedy() const {
    if (anchored_) return greedy_from(-1);
    std::pair<std::int64_t, std::vector<int>> best{impossible, {}};
    for (int first = 0; first < count(); ++first)
      if (!scene_.has_lines() || beside_line_[first]) best = std::min(best, greedy_from(first));
    return best;
  }

  const Scene& scene_;
  const Adjacency& adjacency_;
  int dimension_;
  bool anchored_;
  std::vector<bool> beside_line_;
  std::vector<bool> placed_;
};

/// Tries every ordered choice of spheres with the driven ones last and keeps the best.
class SphereChoice {
 public:
  SphereChoice(Instruction instruction, std::vector<Neighbour> known, std::vector<int> copies,
               const ExchangeRule& rule, const Eigen::Matrix3Xd& points)
      : instruction_(std::move(instruction)),
        known_(std::move(known)),
        copies_(std::move(copies)),
        rule_(rule),
        points_(points),
        given_(std::min(instruction_.count, static_cast<int>(known_.size()))) {}

  Instruction best() {
    choose(0);
    return best_;
  }

 private:
  void choose(int slot) {
    if (slot == instruction_.count) {
      const double value = boundary_distance(instruction_, rule_, points_);
      if (value <= best_value_) return;
      best_value_ = value;
      best_ = instruction_;
      return;
    }
    if (slot < given_) {
      for (const Neighbour& n : known_) try_sphere(slot, {n.point, n.constraint, Eigen::Vector3d::Zero()});
    } else {
      for (int copy : copies_) try_sphere(slot, {copy, -1, Eigen::Vector3d(points_.col(copy))});
    }
  }

  void try_sphere(int slot, const PlanSphere& sphere) {
    for (int earlier = 0; earlier < slot; ++earlier)
      if (instruction_.spheres[earlier].center == sphere.center) return;
    instruction_.spheres[slot] = sphere;
    choose(slot + 1);
  }

  Instruction instruction_;
  std::vector<Neighbour> known_;
  std::vector<int> copies_;
  const ExchangeRule& rule_;
  const Eigen::Matrix3Xd& points_;
  int given_;
  Instruction best_;
  double best_value_ = -1;
};

}  // namespace

Figure in_plan_frame(const Scene& scene, const Plan& plan, const Figure& figure) {
  return scene.in_frame(figure, plan.frame());
}

std::vector<int> placing_order(const Scene& scene) {
  const Adjacency adjacency = adjacency_of(scene.problem());
  return Ordering(scene, adjacency).best();
}

Plan derive_plan(const Scene& scene, const Figure& figure, const ExchangeRule& rule) {
  const Adjacency adjacency = adjacency_of(scene.problem());
  const Ordering ordering(scene, adjacency);
  const std::vector<int> order = ordering.best();

  std::vector<Instruction> skeleton;
  std::vector<int> placed;
  for (int p = 0; p < scene.point_count(); ++p)
    if (scene.fixed_point(p)) placed.push_back(p);
  for (int p : order) {
    Instruction instruction;
    instruction.place = p;
    instruction.count = ordering.need(static_cast<int>(placed.size()));
    skeleton.push_back(instruction);
    placed.push_back(p);
  }
  placed.resize(placed.size() - order.size());

  const Figure moved = in_plan_frame(scene, Plan(scene.dimension(), 0, skeleton), figure);
  std::vector<Instruction> instructions;
  for (const Instruction& instruction : skeleton) {
    std::vector<Neighbour> known;
    for (const Neighbour& n : adjacency[instruction.place])
      if (std::find(placed.begin(), placed.end(), n.point) != placed.end()) known.push_back(n);
    instructions.push_back(SphereChoice(instruction, known, placed, rule, moved.points).best());
    placed.push_back(instruction.place);
  }
  return Plan(scene.dimension(), scene.constraint_count(), std::move(instructions));
}

Plan given_plan(const Scene& scene, const Figure& figure) {
  std::vector<Instruction> instructions;
  std::vector<bool> placed;
  for (int p = 0; p < scene.point_count(); ++p) placed.push_back(scene.fixed_point(p).has_value());
  for (const PlanStep& step : scene.problem().construction) {
    // The first term may name the origin without placing it.
    for (const PlanStep::Radius& radius : step.from)
      if (!placed[radius.from]) {
        placed[radius.from] = true;
        Instruction origin;
        origin.place = radius.from;
        instructions.push_back(origin);
      }
    Instruction instruction;
    instruction.place = step.place;
    instruction.count = static_cast<int>(step.from.size());
    for (int i = 0; i < instruction.count; ++i) {
      instruction.spheres[i].center = step.from[i].from;
      instruction.spheres[i].constraint = step.from[i].constraint;
    }
    // Driving parameters come last within an instruction ([I] §2.3.3, condition (i)).
    std::stable_partition(instruction.spheres.begin(), instruction.spheres.begin() + instruction.count,
                          [](const PlanSphere& s) { return !s.is_driven(); });
    placed[step.place] = true;
    instructions.push_back(instruction);
  }
  Plan plan(scene.dimension(), scene.constraint_count(), std::move(instructions));
  const Figure moved = in_plan_frame(scene, plan, figure);
  for (Instruction& instruction : plan.instructions())
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven())
        instruction.spheres[i].reference = moved.points.col(instruction.spheres[i].center);
  return plan;
}

Plan first_plan(const Scene& scene, const ExchangeRule& rule) {
  return scene.problem().construction.empty() ? derive_plan(scene, *scene.sketch(), rule)
                                              : given_plan(scene, *scene.sketch());
}

std::optional<std::string> why_no_plan(const Scene& scene) {
  if (!scene.is_anchored()) return std::nullopt;
  int fixed = 0;
  for (int p = 0; p < scene.point_count(); ++p) fixed += scene.fixed_point(p).has_value() ? 1 : 0;
  if (fixed >= scene.dimension()) return std::nullopt;
  return "a construction plan builds on " + std::to_string(scene.dimension()) +
         " fixed points or on none, and the instance fixes " + std::to_string(fixed);
}

std::vector<std::string> describe_plan(const Scene& scene, const Plan& plan) {
  static constexpr std::array<const char*, 4> plane_names{"origin", "interCL", "interCC", "interCC"};
  static constexpr std::array<const char*, 4> space_names{"origin", "interSL", "interSSP", "interSSS"};
  std::vector<std::string> instructions;
  int driving = 0;
  for (const Instruction& instruction : plan.instructions()) {
    std::ostringstream text;
    text << scene.problem().points[instruction.place] << " = "
         << (plan.dimension() == 2 ? plane_names : space_names)[instruction.count];
    for (int i = 0; i < instruction.count; ++i) {
      const PlanSphere& sphere = instruction.spheres[i];
      text << (i == 0 ? "(" : ", ") << scene.problem().points[sphere.center];
      if (sphere.is_driven())
        text << "', k" << ++driving;
      else
        text << ", " << scene.problem().constraints[sphere.constraint].id;
    }
    if (instruction.count > 0) text << ")";
    instructions.push_back(text.str());
  }
  return instructions;
}

}  // namespace gcs
