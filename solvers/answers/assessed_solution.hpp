#pragma once
/// One solution as answers list it.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/elements/stated_signs.hpp"
#include "solvers/model/figure_in_frame.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

struct DecimalFigure;

/// What a file calls the entities of a scene, its unit of length, and its frame where that is not the scene's; shared by
/// the scene's solutions.
struct FileTerms {
  int dimension = 3;
  std::vector<std::string> points;
  std::vector<std::string> lines;
  std::vector<std::string> planes;
  int unit_exponent = 0;  ///< see Scene::unit_exponent
  std::optional<FramePose> frame{};
};

std::shared_ptr<const FileTerms> file_terms(const Scene& scene);

/// One reflection class. Members are in the scene's unit of length, what functions return in the file's.
struct AssessedSolution {
  Figure figure;  ///< the class's representative in the instance's frame
  int multiplicity = 1;
  double residual = 0;                ///< relative_residual of the representative
  double condition = 0;               ///< jacobian_condition; infinity at a singular solution
  std::optional<double> error_bound;  ///< rigorous; empty: not certified
  bool certified = false;
  /// Of a certified one whose coordinates are so large that doubles do not hold the distances: with as many digits as do.
  std::shared_ptr<const DecimalFigure> decimals;
  /// Of a real solution of the equations; of a certified one by its enclosure.
  SignVerdict signs;
  std::shared_ptr<const FileTerms> terms = std::make_shared<const FileTerms>();

  bool is_real() const { return figure.is_real(); }
  /// Whether it is real and satisfies all constraints as stated, orientations and senses of angles included: one of those
  /// that are counted as real.
  bool is_as_stated() const { return is_real() && signs.standing == Standing::as_stated; }
  /// Where everything is.
  Figure placement() const { return in_file(figure, terms->unit_exponent, terms->frame); }
  /// How far from the exact solution that is at most, for every point; empty: not certified. Where the unit
  /// makes it so small that it is rounded, it is rounded up.
  std::optional<double> error() const;
  /// Where the point is: two coordinates in the plane, three in space. Throws std::out_of_range for a name that
  /// is no point's, and std::domain_error where the solution is not real.
  Eigen::VectorXd point(std::string_view name) const;
  /// The same of any solution.
  Eigen::VectorXcd complex_point(std::string_view name) const;
  /// Likewise a line, by a point on it and a direction of length 1. Throws as point() does.
  LinePosition line(std::string_view name) const;
  PlanePosition plane(std::string_view name) const;
};

}  // namespace gcs
