#include "harness/sweeps/follow_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <random>

#include "solvers/solving/solve.hpp"

namespace gcs {
namespace {

/// Figures nearer than this part of the scene's size are one.
constexpr double same_within = 1e-6;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; }

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A new value of a constraint that has `given`, in the form in which it has it.
GivenNumber changed(double given, bool is_squared, double factor) {
  return given * (is_squared ? factor * factor : factor);
}

/// An angle that would leave its range stays.
bool may_change(const Relation& relation, double factor) {
  if (relation.form == Relation::Form::none) return false;
  const double given = std::abs(relation.given.value * factor);
  if (relation.form == Relation::Form::degrees) return given < 90;
  return relation.form != Relation::Form::cosine || given < 1;
}

ChangedValues random_changes(const ProblemStatement& problem, double part, std::mt19937_64& random) {
  ChangedValues changes;
  for (const DistanceConstraint& constraint : problem.constraints) {
    const double factor = 1 + part * uniform(random);
    changes.push_back({constraint.id, changed(constraint.given.value, constraint.is_squared, factor)});
  }
  for (const Relation& relation : problem.relations) {
    const double factor = 1 + part * uniform(random);
    if (may_change(relation, factor))
      changes.push_back(
          {relation.id, changed(relation.given.value, relation.form == Relation::Form::squared, factor)});
  }
  return changes;
}

/// Twice the area of three points or six times the volume of four, for all of them.
std::vector<double> orientations(const Figure& figure, int dimension) {
  std::vector<double> all;
  const Eigen::Matrix3Xd& p = figure.points;
  for (Eigen::Index a = 0; a < p.cols(); ++a)
    for (Eigen::Index b = a + 1; b < p.cols(); ++b)
      for (Eigen::Index c = b + 1; c < p.cols(); ++c) {
        const Eigen::Vector3d normal = (p.col(b) - p.col(a)).cross(p.col(c) - p.col(a));
        if (dimension == 2) all.push_back(normal.z());
        for (Eigen::Index d = c + 1; d < p.cols() && dimension == 3; ++d)
          all.push_back(normal.dot(p.col(d) - p.col(a)));
      }
  return all;
}

/// Whether the orientation of some points is certainly another one, the whole perhaps mirrored.
bool is_flipped(const Figure& a, const Figure& b, int dimension, double size) {
  const std::vector<double> of_a = orientations(a, dimension), of_b = orientations(b, dimension);
  const double flat = same_within * std::pow(size, dimension);
  bool agrees = false, differs = false;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (std::min(std::abs(of_a[i]), std::abs(of_b[i])) <= flat) continue;
    (of_a[i] * of_b[i] > 0 ? agrees : differs) = true;
  }
  return agrees && differs;
}

/// One change, and everything that is asked about it.
class Trial {
 public:
  Trial(const Instance& instance, const Figure& from, const ChangedValues& changes, FollowTally& tally)
      : scene_(instance), from_(from), changes_(changes), tally_(tally) {}

  void run() {
    const Followed proven = timed(true, tally_.proof_s), tracked = timed(false, tally_.track_s);
    ++tally_.changes;
    if (!proven.proven) {
      ++tally_.undecided;
      return;
    }
    if (tracked.end != proven.end ||
        (proven.end == ArcEnd::reached && !is_same(proven.figure, tracked.figure)))
      ++tally_.differs;
    const std::optional<Figure> newton = by_newton();
    if (proven.end == ArcEnd::folds) {
      ++tally_.folds;
      tally_.silent += newton ? 1 : 0;
      return;
    }
    ++tally_.reached;
    if (!newton)
      ++tally_.fails;
    else if (!is_same(proven.figure, *newton))
      ++(is_flipped(representative(proven.figure), *newton, scene_.dimension(), file_size())
             ? tally_.flips
             : tally_.elsewhere);
  }

 private:
  Followed timed(bool proves, double& seconds) const {
    FollowSettings settings;
    settings.arc.prove = proves;
    settings.beyond = false;
    const double start = processor_s();
    Followed followed = follow(scene_, from_, changes_, settings);
    seconds += processor_s() - start;
    return followed;
  }

  double file_size() const { return std::ldexp(scene_.size(), scene_.unit_exponent()); }

  Figure representative(const Figure& figure) const {
    return scene_.in_file_unit(scene_.representative(scene_.in_scene_unit(figure)));
  }

  bool is_same(const Figure& a, const Figure& b) const {
    const Eigen::Matrix3Xd offset = representative(a).points - representative(b).points;
    return offset.size() == 0 || offset.cwiseAbs().maxCoeff() <= same_within * file_size();
  }

  /// In the file's unit; nothing where it does not settle.
  std::optional<Figure> by_newton() const {
    const Answer answer =
        solve(Scene::unchecked(with_changes(scene_.problem(), from_, changes_)), "full-space",
              {{"mode", "newton"}, {"reduce", "off"}}, {.checks_counts = false});
    if (answer.solutions.empty() || answer.status != RunStatus::complete) return std::nullopt;
    return answer.solutions.front().placement();
  }

  const Scene scene_;
  const Figure& from_;
  const ChangedValues& changes_;
  FollowTally& tally_;
};

}  // namespace

std::vector<Figure> solutions_on_path(const Instance& instance) {
  std::vector<Figure> figures;
  if (!instance.problem.sketch) return figures;
  for (const AssessedSolution& solution : solve(instance, "full-space", {{"reduce", "off"}}).solutions)
    figures.push_back(solution.placement());
  return figures;
}

FollowTally tally_changes(const Instance& instance, const std::vector<Figure>& from, double part, int count,
                          std::uint64_t seed) {
  std::mt19937_64 random(seed);
  FollowTally tally;
  for (int i = 0; i < count; ++i) {
    const ChangedValues changes = random_changes(instance.problem, part, random);
    Trial(instance, from[static_cast<std::size_t>(i) % from.size()], changes, tally).run();
  }
  return tally;
}

}  // namespace gcs
