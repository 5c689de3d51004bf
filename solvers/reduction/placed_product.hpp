#pragma once
/// The solutions of a scene in steps: for each way of every step before, the ways of a step.
///
/// They are counted without being listed: steps that do not depend on each other are multiplied (recursive
/// conditioning; Darwiche 2001). They are listed one after another, as far as asked for.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/numeric/natural.hpp"
#include "solvers/reduction/frame_change.hpp"
#include "solvers/reduction/step_solver.hpp"

namespace gcs {

/// A way as it was found.
struct PlacedWay {
  StepWay way;
  double error = std::numeric_limits<double>::infinity();  ///< see Candidate
};

/// The ways of a step: always the same ones, or those for what was placed before.
struct PlacedStep {
  std::optional<std::vector<PlacedWay>> given;
  std::optional<SolutionTotals>
      totals{};  ///< of given ways that are not all listed, on which no other step depends
  std::unique_ptr<StepSolver> solver;  ///< where they are not given
};

class PlacedProduct {
 public:
  /// `scene`: the one that is ordered, in its own frame. `steps`: one for each of the order's. Keeps references. Adds to
  /// `work`.
  PlacedProduct(const Scene& scene, const ElementOrder& order, const SceneSystem& system,
                const GeneralEquations& equations, std::vector<PlacedStep>& steps,
                const std::stop_token& stop, WorkCounters& work);

  /// How many there are, real ones or all; nothing where that takes too long, or on a stop.
  std::optional<Natural> count(bool only_real);
  /// At most so many of them, in the scene's unit.
  std::vector<Candidate> list(bool only_real, std::size_t limit);

 private:
  const std::vector<PlacedWay>& ways(int step);
  bool is_real_before(int step) const;
  Natural weigh(const std::vector<int>& open, bool only_real);
  Natural weigh_connected(const std::vector<int>& open, bool only_real);
  std::vector<std::vector<int>> connected(const std::vector<int>& open) const;
  void choose(int step, std::size_t number);
  void list_from(int step);
  Candidate candidate() const;
  ComplexVectorX polished(const ComplexVectorX& x) const;
  bool is_exhausted() const;

  FrameChange to_frame_;
  const ElementOrder& order_;
  const SceneSystem& system_;
  const GeneralEquations& equations_;
  std::vector<PlacedStep>& steps_;
  std::stop_token stop_;
  WorkCounters& work_;

  ComplexVectorX x_;                          ///< as chosen
  std::vector<std::size_t> choices_;          ///< of each step
  std::vector<std::vector<PlacedWay>> ways_;  ///< of each step that is solved: for `solved_for_`
  std::vector<std::optional<std::vector<std::size_t>>> solved_for_;
  std::int64_t solves_ = 0;
  bool only_real_ = false;
  std::size_t limit_ = 0;
  std::vector<Candidate> listed_;
};

}  // namespace gcs
