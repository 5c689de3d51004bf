#include "harness/sweeps/real_climb.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "solvers/figures/complex_distances.hpp"
#include "solvers/homotopies/start_store.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/solving/solve.hpp"

namespace gcs {
namespace {

/// The solutions at random lengths, which serve all lengths.
class KeptStart final : public StartStore {
 public:
  StartSystem read(const std::string&, const StartFamily& family) const override {
    if (!start_ || family.equations != equations_)
      throw std::runtime_error("other lengths have another frame");
    return *start_;
  }
  void reserve(const std::string&) override {}
  void write(const std::string&, const StartFamily& family, const StartSystem& start) override {
    equations_ = family.equations;
    start_ = start;
  }
  bool is_empty() const { return !start_; }

 private:
  std::vector<std::string> equations_;
  std::optional<StartSystem> start_;
};

/// Two solutions that meet at a fold: a pair of conjugate ones, of real ones, or one and its mirror image.
struct Pair {
  double square = 0;         ///< of their distance
  Eigen::VectorXd gradient;  ///< by the logarithms of the squared lengths

  /// How far away the fold is, to first order: the square of the distance of two solutions goes through 0 linearly.
  double nearness() const { return square / gradient.norm(); }
};

bool is_nearer(const Pair& a, const Pair& b) { return a.nearness() < b.nearness(); }

/// A solution in free coordinates, and its derivatives by the logarithms of the squared lengths.
struct Solution {
  Eigen::VectorXcd x;
  Eigen::MatrixXcd rates;
};

/// Solutions that are told apart by signs of whole axes are one.
std::vector<Eigen::VectorXd> axis_signs(const Scene& scene, const DistanceSystem& system) {
  const std::vector<int> axes = mirror_axes(scene, system);
  std::vector<Eigen::VectorXd> signs;
  for (int mask = 0; mask < 1 << system.dimension(); ++mask) {
    Eigen::VectorXd& sign = signs.emplace_back(system.unknowns());
    for (int i = 0; i < system.unknowns(); ++i)
      sign[i] = (mask >> axes[static_cast<std::size_t>(i)]) & 1 ? -1 : 1;
  }
  return signs;
}

/// All solutions at some lengths.
class Place {
 public:
  Place(ProblemStatement problem, const Answer& answer)
      : counted_{std::move(problem), 0, answer.solutions.size()} {
    const Scene scene(counted_.problem);
    const DistanceSystem system(scene);
    std::vector<Solution> real;
    for (const AssessedSolution& solution : answer.solutions) {
      const std::optional<Solution> here = differentiated(system, solution.placement());
      counted_.real += solution.is_real();
      if (!here) continue;
      if (solution.is_real())
        real.push_back(*here);
      else
        conjugates_.push_back(with_conjugate(*here));
    }
    find_meetings(real, axis_signs(scene, system));
    std::ranges::sort(conjugates_, is_nearer);
    std::ranges::sort(meetings_, is_nearer);
  }

  const CountedLengths& counted() const { return counted_; }
  /// Σ √(|Im z| / |z|): 0 where all are real, and steepest for those that almost are.
  double unreal() const {
    double sum = 0;
    for (const Pair& pair : conjugates_) sum += std::pow(pair.square, 0.25);
    return sum;
  }
  /// What may be led to 0: the pairs of conjugate solutions whose folds are the nearest, then a part of unreal().
  std::vector<Pair> aims() const {
    constexpr std::size_t most = 12;
    const auto count = static_cast<std::ptrdiff_t>(std::min(conjugates_.size(), most));
    std::vector<Pair> aims(conjugates_.begin(), conjugates_.begin() + count);
    aims.push_back(part_of_unreal());
    return aims;
  }
  /// Those of real ones that are the nearest.
  const std::vector<Pair>& meetings() const { return meetings_; }

 private:
  /// Nothing at a singular solution.
  std::optional<Solution> differentiated(const DistanceSystem& system, const Figure& figure) const {
    Solution solution;
    solution.x.resize(system.unknowns());
    solution.x.real() = system.coordinates({figure.points, {}, {}});
    solution.x.imag().setZero();
    if (!figure.is_real()) solution.x.imag() = system.coordinates({figure.imaginary, {}, {}});
    // The equations are halves of squared distances.
    Eigen::MatrixXcd halves = Eigen::MatrixXcd::Zero(system.equations(), system.equations());
    for (int e = 0; e < system.equations(); ++e) {
      const double length = counted_.problem.constraints[static_cast<std::size_t>(e)].length();
      halves(e, e) = length * length / 2;
    }
    const std::vector<DoubleDouble> unused;
    solution.rates = ComplexDistances(system, unused).jacobian(solution.x).partialPivLu().solve(halves);
    return solution.rates.allFinite() ? std::optional(solution) : std::nullopt;
  }

  Pair part_of_unreal() const {
    constexpr double part = 0.05;
    Pair sum{part * unreal(),
             Eigen::VectorXd::Zero(static_cast<Eigen::Index>(counted_.problem.constraints.size()))};
    for (const Pair& pair : conjugates_) sum.gradient += 0.25 * std::pow(pair.square, -0.75) * pair.gradient;
    return sum;
  }

  /// |Im z|² / |z|²: far solutions are not near to being real because they vary much.
  static Pair with_conjugate(const Solution& z) {
    const Eigen::VectorXd imaginary = z.x.imag();
    const double size = z.x.squaredNorm(), square = imaginary.squaredNorm() / size;
    const Eigen::VectorXd of_imaginary = z.rates.imag().transpose() * imaginary,
                          of_real = z.rates.real().transpose() * z.x.real();
    return {square, 2 / size * (of_imaginary - square * (of_imaginary + of_real))};
  }

  void find_meetings(const std::vector<Solution>& real, const std::vector<Eigen::VectorXd>& signs) {
    for (std::size_t i = 0; i < real.size(); ++i)
      for (std::size_t j = i; j < real.size(); ++j)
        for (const Eigen::VectorXd& sign : signs) {
          if (i == j && sign.minCoeff() > 0) continue;
          const Eigen::VectorXd difference = real[i].x.real() - sign.cwiseProduct(real[j].x.real());
          const Eigen::MatrixXd rates = real[i].rates.real() - sign.asDiagonal() * real[j].rates.real();
          meetings_.push_back({difference.squaredNorm(), 2 * rates.transpose() * difference});
        }
    const std::size_t kept = std::min<std::size_t>(meetings_.size(), 60);
    std::ranges::partial_sort(meetings_, meetings_.begin() + static_cast<std::ptrdiff_t>(kept), is_nearer);
    meetings_.resize(kept);
  }

  CountedLengths counted_;
  std::vector<Pair> conjugates_;
  std::vector<Pair> meetings_;
};

/// The shortest δ with a_k·δ ≥ b_k for all k, or near it where there is none: Hildreth's method, which projects on one
/// half-space after the other.
class HalfSpaces {
 public:
  void add(const Eigen::VectorXd& a, double b) {
    normals_.push_back(a.normalized());
    bounds_.push_back(b / a.norm());
  }

  Eigen::VectorXd shortest() const {
    constexpr int sweeps = 300;
    Eigen::VectorXd delta = Eigen::VectorXd::Zero(normals_.front().size());
    std::vector<double> multipliers(bounds_.size(), 0);
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t k = 0; k < bounds_.size(); ++k) {
        const double change = std::max(-multipliers[k], bounds_[k] - normals_[k].dot(delta));
        multipliers[k] += change;
        delta += change * normals_[k];
      }
    return delta;
  }

 private:
  std::vector<Eigen::VectorXd> normals_;
  std::vector<double> bounds_;
};

/// Of logarithms of squared lengths: across the fold of `pair`, and of what is left of others a part is kept.
Eigen::VectorXd step_across(const Pair& pair, const std::vector<Pair>& meetings) {
  constexpr double beyond = 1.3, lost = 0.4, longest = 0.05;
  HalfSpaces spaces;
  spaces.add(-pair.gradient, beyond * pair.square);
  for (const Pair& meeting : meetings) spaces.add(meeting.gradient, -lost * meeting.square);
  const Eigen::VectorXd step = spaces.shortest();
  return step * std::min(1.0, longest / step.cwiseAbs().maxCoeff());
}

ProblemStatement with_step(ProblemStatement problem, const Eigen::VectorXd& step) {
  for (std::size_t e = 0; e < problem.constraints.size(); ++e) {
    DistanceConstraint& distance = problem.constraints[e];
    const double square =
        distance.length() * distance.length() * std::exp(step[static_cast<Eigen::Index>(e)]);
    distance.given.text = fmt::format("{:.12g}", square);
    distance.given.value = std::stod(distance.given.text);
    distance.is_squared = true;
  }
  return problem;
}

class Climber {
 public:
  explicit Climber(const ClimbSettings& settings) : settings_(settings), random_(settings.seed) {}

  Climb run(const ProblemStatement& start) {
    std::optional<Place> place = at(start);
    if (!place) throw std::runtime_error("the solutions at the first lengths are not all found");
    climb_.real_at_start = place->counted().real;
    note(place->counted());
    while (climb_.top.real < climb_.top.all && !settings_.stopped()) {
      std::optional<Place> next = higher(*place);
      if (!next) next = beside(*place);
      if (next) place = std::move(next);
      note(place->counted());
    }
    return climb_;
  }

 private:
  std::optional<Place> at(const ProblemStatement& problem) {
    const OptionMap options{{starts_.is_empty() ? "save_start" : "start", "all"}, {"reduce", "off"}};
    SolveSurroundings surroundings;
    surroundings.starts = &starts_;
    const Answer answer = solve(Scene(problem), "monodromy", options, {}, surroundings);
    ++climb_.scenes;
    if (answer.status != RunStatus::complete) return std::nullopt;
    return Place(problem, answer);
  }

  void note(const CountedLengths& counted) {
    if (climb_.top.all > 0 && counted.real <= climb_.top.real) return;
    climb_.top = counted;
    settings_.progress(counted);
  }

  /// Towards one of the aims, in steps that shrink until one pays.
  std::optional<Place> higher(const Place& from) {
    constexpr int most_shorter = 4;
    for (const Pair& aim : from.aims()) {
      Eigen::VectorXd step = step_across(aim, from.meetings());
      for (int shorter = 0; shorter <= most_shorter && !settings_.stopped(); ++shorter, step /= 3)
        if (auto place = at(with_step(from.counted().problem, step)); place && pays(*place, from))
          return place;
    }
    return std::nullopt;
  }

  /// More are real, or as many and the others are nearer to it.
  static bool pays(const Place& place, const Place& from) {
    constexpr double nearer = 0.998;
    if (place.counted().real != from.counted().real) return place.counted().real > from.counted().real;
    return place.unreal() < nearer * from.unreal();
  }

  /// A random step that costs no more than one real solution.
  std::optional<Place> beside(const Place& from) {
    constexpr int most_tried = 20;
    constexpr double size = 0.02;
    std::normal_distribution<double> normal;
    for (int tried = 0; tried < most_tried && !settings_.stopped(); ++tried) {
      Eigen::VectorXd step(static_cast<Eigen::Index>(from.counted().problem.constraints.size()));
      for (double& change : step) change = size / (1 + tried) * normal(random_);
      auto place = at(with_step(from.counted().problem, step));
      if (place && place->counted().real + 1 >= from.counted().real) return place;
    }
    return std::nullopt;
  }

  const ClimbSettings& settings_;
  std::mt19937_64 random_;
  KeptStart starts_;
  Climb climb_;
};

}  // namespace

Climb climb_to_real(const ProblemStatement& start, const ClimbSettings& settings) {
  return Climber(settings).run(start);
}

}  // namespace gcs
