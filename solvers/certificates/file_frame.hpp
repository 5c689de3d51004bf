#pragma once
/// Where a scene lies in its file, in balls.

#include <optional>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/balls.hpp"

namespace gcs {

/// x ↦ T x + s, from the scene's frame to that of the file, in the file's unit, where given positions leave motions; otherwise
/// the identity.
class FileFrame {
 public:
  FileFrame(const Scene& scene, slong bits);

  /// A column of three. x ↦ T x + s, and x ↦ T x.
  void place(BallMatrix& point) const;
  void turn(BallMatrix& direction) const;
  /// The point nearest to the file's origin of a line through a point that is placed, in a direction that is turned.
  void move_to_foot(BallMatrix& point, const BallMatrix& direction) const;
  /// The offset of a plane whose normal is turned.
  void shift(acb_ptr offset, const BallMatrix& normal) const;

 private:
  bool is_moved_;
  slong bits_;
  BallMatrix turn_, shift_;
};

}  // namespace gcs
