#pragma once
/// Solutions of a scene that were found in another frame of it.

#include <memory>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/homotopies/general_family.hpp"
#include "solvers/numeric/double_double.hpp"

namespace gcs {

class FrameChange {
 public:
  /// `other`: the same but for its frame. Keeps a reference to `scene`.
  FrameChange(const Scene& scene, const Scene& other);

  /// Whether figures of a general scene are moved.
  bool moves_bodies() const { return system_ != nullptr; }
  /// A figure in the frame of the other, moved into that of the scene, by a complex motion where it is not real. It is
  /// polished where it `is_simple`: a complex rotation has entries of any size and costs accuracy.
  Figure operator()(const Figure& figure, bool is_simple) const;

 private:
  Figure moved(const Figure& figure) const;
  Figure at_zero(const Figure& figure) const;

  const Scene& scene_;
  std::vector<DoubleDouble> squares_;    ///< of the lengths, where only points and a line are turned
  std::unique_ptr<SceneSystem> system_;  ///< of a general scene in another frame
  GeneralEquations equations_;
};

}  // namespace gcs
