#pragma once
/// Where S is back at its start, which lines and planes may have left turned over.
///
/// A change of signs that turns elements over carries the equations of S into themselves where each equation's products all
/// keep their signs, or all change them and the equation has no value. Then the turned start is a point of the same set, the
/// same figure as the start, and S is closed there: no point of it is its own image, since a unit vector is turned, so that
/// S goes on from there as the image of what began at the start.

#include "solvers/elements/system_builder.hpp"
#include "solvers/proven_paths/path_tube.hpp"

namespace gcs {

class StartImages {
 public:
  /// `turnings`: of the unknowns, from first_turning on; empty where nothing can be turned over.
  StartImages(PathEquations equations, PathData data, SignMasks turnings);

  const PointBox& start() const { return data_.start; }
  /// Where in the tube the start is or that image of it that may be there. Unknown, too, where two of them may.
  PlaceInTube locate(const PathTube& tube) const;

 private:
  struct Possible {
    bool stays = true, turns = true;
  };
  Possible possible(SignMask generator, const Eigen::VectorXd& centre, const Eigen::VectorXd& extent) const;
  Eigen::VectorXd signs(SignMask turned) const;
  bool is_symmetric(const Eigen::VectorXd& signs) const;

  PathEquations equations_;
  PathData data_;
  SignMasks turnings_;
  std::vector<SignMask> generators_;
  Eigen::MatrixXd known_as_box_;  ///< the start's spread: none
};

}  // namespace gcs
