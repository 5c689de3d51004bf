#pragma once
/// Where a figure moves to when values of its constraints change: the solution that it becomes without a flip, or the fold
/// at which there is none any more.
///
///     gcs::Problem p(2);
///     p.points("a", "b", "c").distance("a", "b", 3).distance("b", "c", 4).distance("c", "a", 5);
///     p.sketch("a", {0, 0}).sketch("b", {3, 0}).sketch("c", {3, 4});
///     const gcs::Followed moved = gcs::follow(p, {{"a3", "6.5"}});

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/following/straight_path.hpp"
#include "solvers/solving/answer.hpp"
#include "solvers/solving/problem.hpp"

namespace gcs {

/// A constraint by its id, and its value in the form that the problem states: a length, its square, degrees or a cosine.
struct ChangedValue {
  std::string id;
  GivenNumber value;
};
using ChangedValues = std::vector<ChangedValue>;

struct FollowSettings {
  ArcSettings arc;
  bool beyond = true;  ///< at a fold: look for the solutions beyond
};

/// A value at a fold, between two numbers: a length or an offset in the file's unit, or a cosine.
struct FoldValue {
  std::string id;
  double low = 0, high = 0;
};

struct Followed {
  ArcEnd end = ArcEnd::undecided;
  std::string reason;        ///< unless reached or folds
  bool proven = false;       ///< by tubes, from the figure's decimals to those given
  std::string why_unproven;  ///< where that was asked for
  Figure figure;  ///< where the arc ends, in the scene's frame and the file's unit; if reached or folds
  std::optional<double> error;  ///< as StraightArc::error, in the file's unit
  TimeRange fold;  ///< the t of a fold, of the way from the figure's values (0) to the given ones (1)
  std::vector<FoldValue> values;  ///< of the constraints that were to change, at the fold
  /// At a fold: full-space on S from the figure to the same values, bent as the problem says so that it closes. Its
  /// crossings are the solutions that lie beyond, in the order met.
  std::optional<Answer> beyond;
  WorkCounters work;
};

/// The word of gcsbench-follow/1: "reached", "folds", …
std::string_view word(ArcEnd end);

/// The problem with that figure, in the file's unit, for its sketch, and with changed values. Throws InputError for a change
/// that is not allowed.
ProblemStatement with_changes(ProblemStatement problem, const Figure& from, const ChangedValues& changes);

/// `from`: a figure in the file's unit; its own values are where the arc begins. All values go straight to those of the
/// scene, changed as said. Throws InputError for a change that is not allowed.
Followed follow(const Scene& scene, const Figure& from, const ChangedValues& changes,
                const FollowSettings& settings = {}, std::stop_token stop = {});

/// The same from the sketch. Precondition: the scene has one.
Followed follow(const Scene& scene, const ChangedValues& changes, const FollowSettings& settings = {},
                std::stop_token stop = {});

/// Along a polyline of values: from each vertex that is reached on to the next. One for each vertex up to the first that is
/// not reached.
std::vector<Followed> follow_polyline(const Scene& scene, const Figure& from,
                                      const std::vector<ChangedValues>& vertices,
                                      const FollowSettings& settings = {}, std::stop_token stop = {});

}  // namespace gcs
