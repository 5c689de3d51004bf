#pragma once
/// What the strategies for all complex solutions share: their settings, the scene's equations with a tracker
/// for them, and the way from the solutions at random lengths, which serve all lengths of a graph, to those
/// at the given ones. Where positions are given beside a line the scene is restated without
/// (model/released_scene.hpp), and the solutions are carried back.

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "solvers/homotopies/general_start.hpp"
#include "solvers/homotopies/homotopy_settings.hpp"
#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {

/// Predictions that are rough or fine, of low and of high order.
std::vector<OptionMap> tracking_accuracy_settings();

/// How many classes there are at generic lengths, exactly or at most.
struct ClassCount {
  std::uint64_t classes = 0;
  bool is_exact = false;
};

/// Nothing where nobody knows, or where no list could be that long. Takes seconds at most.
using ClassLimit = std::function<std::optional<ClassCount>()>;

inline bool is_met(const ClassLimit& limit, std::size_t classes) {
  const std::optional<ClassCount> count = limit();
  return count && count->classes == classes;
}

/// The equations of a scene and their solutions at random lengths. Not to be moved: trackers refer to the
/// system.
class GenericStart {
 public:
  GenericStart(const Scene& scene, std::uint64_t seed, const TrackingSetup& setup);
  virtual ~GenericStart() = default;
  GenericStart(const GenericStart&) = delete;
  GenericStart& operator=(const GenericStart&) = delete;

  /// The squared lengths, one per constraint.
  virtual const ComplexVectorX& squares() const = 0;
  /// Regular, distinct up to reflections, in the coordinates of the frame.
  virtual const std::vector<ComplexVectorX>& solutions() const = 0;
  /// What may keep them from being all, in words; empty when nothing does.
  virtual std::string missing() const = 0;
  /// Whether something is missing because the search was stopped on request.
  virtual bool is_stopped() const = 0;
  /// How they were found.
  virtual std::vector<Particular> particulars() const = 0;

  std::mt19937_64 random;
  DistanceSystem coordinates;
  SquareSystem system;
  Elimination elimination;
  LegTracking tracking;
  WorkCounters work;
};

class ComplexStrategy : public Strategy {
 public:
  std::optional<std::string> why_unsupported(const SolveRequest& request) const final;
  void prepare(const SolveRequest& request) final;
  SolveReport solve(const SolveRequest& request) final;

 protected:
  /// Throws OptionError for instructions that this machine does not have.
  explicit ComplexStrategy(const HomotopySettings& settings);

  /// Whether on the way to random lengths mirror images are followed too: many times the work, as a measure
  /// of what dividing them out saves.
  bool follows_mirror_images() const { return follows_mirror_images_; }

  /// With the threads and the journal of the request.
  TrackingSetup setup_for(const SolveRequest& request) const;
  static void report_progress(const SolveRequest& request, std::string_view stage, double fraction);

 private:
  /// The scene has no given positions; `limit` is called while the request lives.
  virtual std::unique_ptr<GenericStart> solve_at_random_lengths(const SolveRequest& request,
                                                                const ClassLimit& limit) const = 0;
  /// Why it does not find the solutions of general scenes; nothing where it does.
  virtual std::optional<std::string> why_no_general_scenes() const = 0;
  /// Finds a member of the scene's family with its solutions. Precondition: !why_no_general_scenes().
  virtual void solve_random_member(const SolveRequest& request, const ClassLimit& limit,
                                   GeneralStart& start) const = 0;
  std::unique_ptr<GeneralStart> general_start(const SolveRequest& request,
                                              const GeneralEquations& equations) const;
  SolveReport solve_general(const SolveRequest& request) const;
  SolveReport solve_free(const SolveRequest& request, const ClassLimit& limit) const;
  bool is_prepared_for(const Scene& scene) const;

  TrackingSetup setup_;
  bool follows_mirror_images_;
  std::unique_ptr<GenericStart> prepared_;
  std::unique_ptr<GeneralStart> prepared_general_;
};

}  // namespace gcs
