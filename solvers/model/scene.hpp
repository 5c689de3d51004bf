#pragma once
/// A problem made ready for solving: lengths in a unit that keeps them near 1, a frame, and the sketch moved
/// into it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solvers/model/interpolation.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Everything is in the scene's unit, a power of two of the file's unit, so that scaling a file by 2^k scales
/// the result and changes no bit of the computation.
class Scene {
 public:
  /// Throws InputError with "problem" for the file's name unless the problem is well posed (see
  /// require_well_posed) and nothing is wrong with its bends (see bend_defect). Precondition: names are unique,
  /// constraints are between two of the entities, and bends are of constraints.
  explicit Scene(ProblemStatement problem);
  /// The same without looking: of a problem that was read from a file or is a part of one, or that no figure need
  /// satisfy.
  static Scene unchecked(ProblemStatement problem);
  // Compiled once.
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();

  const ProblemStatement& problem() const { return problem_; }
  int dimension() const { return problem_.dimension; }
  int point_count() const { return static_cast<int>(problem_.points.size()); }
  int constraint_count() const { return static_cast<int>(problem_.constraints.size()); }
  bool has_lines() const { return !problem_.lines.empty(); }

  /// log2 of the scene's unit in the file's unit: file length = scene length · 2^unit_exponent.
  int unit_exponent() const { return unit_exponent_; }
  /// Target lengths a_so, one per constraint.
  const std::vector<double>& target_lengths() const { return target_lengths_; }
  /// Largest target length or coordinate of a fixed entity: the size to which errors are relative.
  double size() const { return size_; }

  const Reference& reference() const { return reference_; }
  /// As ProblemStatement::is_anchored.
  bool is_anchored() const { return anchored_; }
  /// The given position of a fixed point, or nothing.
  std::optional<Eigen::Vector3d> fixed_point(int point) const;
  /// The sketch in the frame, if the file gives one.
  const std::optional<Figure>& sketch() const { return sketch_; }
  /// a_i(t) of every constraint. Precondition: there is a sketch.
  const std::vector<LengthPath>& length_paths() const { return length_paths_; }

  /// `figure` moved by a rotation and a translation (no reflection): origin at 0, axis point with x ≥ 0 on
  /// the x-axis, plane point in the xy-plane with y ≥ 0. The identity when positions are fixed. For a complex
  /// figure see in_frame in complex_points.hpp.
  Figure in_frame(const Figure& figure) const { return in_frame(figure, reference_); }
  /// The same for another reference.
  Figure in_frame(const Figure& figure, const Reference& reference) const;
  /// As in_frame, then the mirror image that gcsbench-result/1 prescribes for a class (2D: first non-zero
  /// y > 0; 3D: first non-zero z > 0); "non-zero" means above 1e-9 of the scene's size.
  Figure representative(const Figure& figure) const;
  /// From the scene's unit to the file's, exactly (a power of two) unless it overflows; also from its frame to the file's
  /// where given positions leave motions.
  Figure in_file_unit(const Figure& figure) const;
  /// The way back.
  Figure in_scene_unit(const Figure& figure) const;

 private:
  struct Unchecked {};
  Scene(ProblemStatement problem, Unchecked);
  void bend(LengthPath& path, const std::vector<double>& coefficients) const;

  ProblemStatement problem_;
  int unit_exponent_ = 0;
  double size_ = 1;
  bool anchored_ = false;
  std::vector<double> target_lengths_;
  Reference reference_;
  std::optional<Figure> sketch_;
  std::vector<LengthPath> length_paths_;
};

}  // namespace gcs
