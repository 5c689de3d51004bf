#pragma once
/// The ends of paths to common tangents of four spheres, whatever the homotopy.

#include <complex>
#include <concepts>
#include <optional>
#include <random>
#include <stop_token>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tangents/found_tangents.hpp"
#include "solvers/tracking/path_tracker.hpp"

namespace gcs {

/// A homotopy whose zeros at t = 1 are lines, each with both directions, or at infinity.
template <class H>
concept HomotopyToTangents = Homotopy<H> && requires(const H& homotopy, const ComplexVector<H::unknowns>& x) {
  { homotopy.starts() } -> std::same_as<std::vector<ComplexVector<H::unknowns>>>;
  { homotopy.is_at_infinity(x) } -> std::same_as<bool>;
  { homotopy.line(x) } -> std::same_as<ComplexTangent>;
};

struct FollowedTangents {
  FoundTangents found;
  std::vector<PathRecord> paths;  ///< one for each start; `stopped` those that a stop left out
};

/// Takes ends one after the other, polished.
class TangentEnds {
 public:
  TangentEnds(const FourSpheres& spheres, WorkCounters& work) : spheres_(spheres), work_(work) {}

  PathRecord take_failed(const std::string& cause);
  PathRecord take_infinite(int winding_number);
  PathRecord take(const ComplexTangent& line, int winding_number);

  /// The simple line where the path ends, if it does so.
  const std::optional<ComplexTangent>& line_of_path(std::size_t path) const { return line_of_path_[path]; }

  /// A regular end is a simple line, however many paths end there; the multiplicity of a singular one is half
  /// the number of its paths. Of a singular line with a single end it is not known what it is: none of
  /// multiplicity 0 is kept. At infinity are half as many lines as paths.
  FoundTangents lines() const;

 private:
  template <class Scalar>
  bool refined(Tangent<Scalar>& line);
  bool take_simple(ComplexTangent line);
  bool take_multiple(const ComplexTangent& line);
  void add(const FoundTangent& line, int singular_ends);

  const FourSpheres& spheres_;
  WorkCounters& work_;
  FoundTangents found_;
  std::vector<int> singular_ends_;  ///< of each line
  std::vector<std::optional<ComplexTangent>> line_of_path_;
  int to_infinity_ = 0;
};

/// On the unit circle, uniformly distributed.
std::complex<double> random_phase(std::mt19937_64& random);

/// Follows all paths, or as many as there is time for before a stop. `monitor` may be null.
template <HomotopyToTangents H>
std::vector<PathRecord> follow_tangent_paths(const H& homotopy, TangentEnds& ends,
                                             const std::stop_token& stop, Monitor* monitor,
                                             WorkCounters& work) {
  using End = TrackingEnd<H::unknowns>;
  PathTracker<H> tracker(homotopy, work);
  const auto starts = homotopy.starts();
  std::vector<PathRecord> paths;
  for (const auto& start : starts) {
    if (monitor)
      monitor->progress("following paths",
                        static_cast<double>(paths.size()) / static_cast<double>(starts.size()));
    if (stop.stop_requested()) break;
    const End end = tracker.follow(start);
    if (end.kind == End::Kind::failed)
      paths.push_back(ends.take_failed(end.cause));
    else if (homotopy.is_at_infinity(end.x))
      paths.push_back(ends.take_infinite(end.winding_number));
    else
      paths.push_back(ends.take(homotopy.line(end.x), end.winding_number));
  }
  paths.resize(starts.size(), {PathRecord::End::stopped, "stopped on request", 0, {}});
  return paths;
}

}  // namespace gcs
