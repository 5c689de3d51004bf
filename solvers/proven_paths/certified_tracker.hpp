#pragma once
/// Follows S by a chain of tubes, each proven to hold exactly one arc (proven_paths/path_tube.hpp).
///
/// Links. The end of the part used of a tube's arc is enclosed in a tiny box, and the box is shown to lie in
/// the next tube: since S meets that tube in one arc only, it is a point of that arc. The tangents of both
/// arcs there, which span the same line, are shown to make an acute angle, so that both are followed in the
/// same direction. The first tube is shown to hold the sketch in the same way.
///
/// Closing. In every tube it is decided whether the sketch lies on the part used of its arc, in general scenes with lines
/// and planes perhaps turned over (proven_paths/start_images.hpp). A regular curve followed in one direction is closed
/// where it first meets its start.
///
/// Crossings. On every part used, all crossings of t = 1 are proven (proven_paths/tube_crossings.hpp).
///
/// So a path that is closed is S, all of it, followed once; S is regular ([I] (h1)), and the number and order
/// of its crossings are theorems for the exact decimals of the file (see proven_paths/path_data.hpp and
/// general_path_data.hpp). As S is regular, no length vanishes on it, so that in squared lengths it is the same
/// component as in lengths.
///
/// Infinity. S of a general scene may not close. Where a coordinate is beyond a given size the path ends, and what is
/// proven is the piece up to there, with its crossings.
///
/// Folds. A tracker that is to stop there proves in every tube that t grows along the part used, from the sketch on, to the
/// crossing of t = 1 or to a point shortly beyond which t is proven to fall.
///
/// Steps. The next centre is tried well beyond the end of the last tube, so that tubes reach to both sides of
/// their centre; where a tube is not proven, not linked, or leaves a crossing undecided, the next one is
/// tried nearer and shorter. Below the smallest step the tracker gives up with the last reason: S is singular
/// there, or passes a singularity or another arc too closely, or touches t = 1.

#include <memory>
#include <optional>
#include <string>

#include "solvers/proven_paths/path_tube.hpp"
#include "solvers/proven_paths/provable_curve.hpp"
#include "solvers/proven_paths/proven_path.hpp"
#include "solvers/proven_paths/start_images.hpp"
#include "solvers/proven_paths/tube_crossings.hpp"
#include "solvers/tracking/series_tracker.hpp"
#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

/// Why S cannot be proven in this scene, or nothing; of a general scene whose equations are as many as its unknowns.
std::optional<std::string> why_not_proven(const Scene& scene);

class CertifiedTracker {
 public:
  /// `options.tolerance` and the largest steps of `options` bound the first trial of a step only; nothing that is proven
  /// depends on them. Precondition: see why_not_proven.
  CertifiedTracker(const Scene& scene, const SeriesTrackerOptions& options, const TrackerContext& context);

  /// On another curve, which has a start. The times beyond which it is given up are those of the curve.
  CertifiedTracker(std::unique_ptr<ProvableCurve> curve, const SeriesTrackerOptions& options,
                   const TrackerContext& context);

  /// To be called before run: arcs() then holds all of S that was proven.
  void keep_arcs() { keeps_arcs_ = true; }
  TrackedPath run();
  const std::vector<ProvenArc>& arcs() const { return arcs_; }
  /// Encloses the crossing or the fold at which t was proven to stop growing. Precondition: the path is proven so.
  const PointBox& end_of_rise() const { return *stretch_.end_of_rise; }
  /// The figure of a crossing's point, in the frame.
  Figure figure(const Eigen::VectorXd& y) const { return curve_->figure(y); }

 private:
  /// Why a tube was not taken, in the order of the tests.
  enum class Failure { none, corrector, proof, link, direction, closing, crossing, growth };

  /// The part of a tube's arc that the path uses.
  struct Stretch {
    ParameterRange entry, exit;
    bool closes = false;
    std::vector<TubeCrossing> crossings;
    std::optional<PointBox> end_of_rise;  ///< the crossing or, without one, the fold
  };

  Failure first_tube(double half_length);
  Failure next_tube(double ahead);
  Failure prove(PathTube& tube, const ArcSeries& series, double needed, double most);
  Failure link(const PathTube& tube, Stretch& stretch) const;
  Failure end_stretch(const PathTube& tube, bool is_first, Stretch& stretch) const;
  Failure rise(const PathTube& tube, Stretch& stretch) const;
  Failure end_of_rise(const PathTube& tube, double until, Stretch& stretch) const;
  TrackedPath finish_rise();
  bool advance();
  void take();
  std::string cause(Failure failure) const;
  TrackedPath finish(TrackedPath::End end, std::string cause);

  SeriesTrackerOptions options_;
  TrackerContext context_;
  std::unique_ptr<ProvableCurve> curve_;
  StartImages start_;
  PathTube here_, there_;  ///< the last tube taken, and the one being tried
  ArcSeries series_;
  Stretch stretch_;    ///< of there_ while it is tried, then of here_
  ArcPoint exit_;      ///< where the used part of here_ ends
  double exit_s_ = 0;  ///< on here_
  double ahead_ = 0;   ///< how far beyond it the next centre is tried first
  bool keeps_arcs_ = false;
  std::vector<ProvenArc> arcs_;
  TrackedPath path_;
};

}  // namespace gcs
