#pragma once
/// S of any scene as it is proven: points near it with their series, in floating point, and what holds exactly.

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "solvers/proven_paths/path_data.hpp"
#include "solvers/proven_paths/path_equations.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

/// Of which curve a proof speaks.
struct ProvableEquations {
  PathEquations equations;
  PathData data;
  SignMasks turnings{};    ///< of the unknowns, as StartImages has them
  TimeRange far{};         ///< S is given up beyond it
  std::string no_start{};  ///< why it is not known where S begins; empty: it is
};

class ProvableCurve {
 public:
  explicit ProvableCurve(ProvableEquations exact) : exact_(std::move(exact)) {}
  virtual ~ProvableCurve() = default;
  /// As SeriesCurve says.
  virtual bool start(int orientation, ArcSeries& series) = 0;
  virtual bool advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series) = 0;
  virtual WorkCounters& work() = 0;
  /// The figure of a point, in the frame.
  virtual Figure figure(const Eigen::VectorXd& y) const = 0;

  const ProvableEquations& exact() const { return exact_; }
  Eigen::Index coordinates() const { return exact_.equations.coordinates(); }

 private:
  ProvableEquations exact_;
};

/// By a curve that the series tracker could follow.
template <class Curve>
class FollowedCurve final : public ProvableCurve {
 public:
  using FigureOf = std::function<Figure(const Eigen::VectorXd&)>;

  FollowedCurve(ProvableEquations exact, Curve curve, FigureOf figure_of)
      : ProvableCurve(std::move(exact)), curve_(std::move(curve)), figure_of_(std::move(figure_of)) {}

  bool start(int orientation, ArcSeries& series) override { return curve_.start(orientation, series); }
  bool advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series) override {
    return curve_.advance(y, tangent, series, false);
  }
  WorkCounters& work() override { return curve_.work(); }
  Figure figure(const Eigen::VectorXd& y) const override { return figure_of_(y); }

 private:
  Curve curve_;
  FigureOf figure_of_;
};

/// Precondition: see why_not_proven of certified_tracker.hpp. The scene outlives the curve.
std::unique_ptr<ProvableCurve> provable_curve(const Scene& scene, int order, double tolerance);

/// The same in the unknowns of SceneSystem, which knows lines and given positions too. Preconditions: there is a sketch, and
/// !why_no_system(scene). The scene outlives the curve.
std::unique_ptr<ProvableCurve> provable_curve_of_elements(const Scene& scene, int order, double tolerance);

}  // namespace gcs
