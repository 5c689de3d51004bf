#include "solvers/tangents/squeezed_tangents.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "solvers/tangents/squeeze_homotopy.hpp"
#include "solvers/tangents/strip_refinement.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// Of the distances from the axis at the two ends of a stretch, at most.
constexpr double stretch_ratio = 8;

/// Of the perturbations, relative to the distances from the axis, and of squares to those of lengths.
constexpr double perturbation = 0.5;

/// With other perturbations each: a path that was lost once is not lost again as a rule.
constexpr int most_attempts = 4;

/// With the argument uniform, of modulus `perturbation`.
Complex random_perturbation(std::mt19937_64& random) {
  return std::polar(perturbation, 2 * std::numbers::pi * static_cast<double>(random() >> 11U) * 0x1p-53);
}

struct Stop {
  double width = 1;  ///< relative to the widened spheres
  ComplexSpheres spheres;
};

/// The spheres with their distances from the axis multiplied by `factor`.
ComplexSpheres complex_spheres(const FourSpheres& spheres, const Strip& strip, double factor) {
  ComplexSpheres result;
  for (int i = 0; i < 3; ++i) {
    result.centers.col(i) = narrowed(strip.centers()[i]);
    result.squares[i] = spheres[i + 1].square.value();
  }
  result.centers.bottomRows<2>() *= factor;
  result.first_square = spheres[0].square.value();
  return result;
}

/// From the widened spheres to the given ones; those in between perturbed.
std::vector<Stop> stops_of(const FourSpheres& spheres, const Strip& strip, std::mt19937_64& random) {
  const double widening = strip.widening();
  const int stretches =
      std::max(2, static_cast<int>(std::ceil(std::log(widening) / std::log(stretch_ratio))));
  ComplexSpheres shift;
  for (int i = 0; i < 3; ++i) {
    shift.centers.col(i) << 0, random_perturbation(random), random_perturbation(random);
    shift.squares[i] = random_perturbation(random);
  }
  shift.first_square = random_perturbation(random);
  std::vector<Stop> stops;
  for (int i = 0; i <= stretches; ++i) {
    const double width = std::pow(widening, -static_cast<double>(i) / stretches);
    Stop stop{width, complex_spheres(spheres, strip, widening * width)};
    if (i > 0 && i < stretches) {
      stop.spheres.centers += width * shift.centers;
      stop.spheres.squares += width * shift.squares;
      stop.spheres.first_square += width * shift.first_square;
    }
    stops.push_back(std::move(stop));
  }
  return stops;
}

class Squeeze {
 public:
  Squeeze(const FourSpheres& spheres, const Strip& strip, WorkCounters& work)
      : lines(strip), spheres_(spheres), strip_(strip), work_(work) {}

  void perturb(std::mt19937_64& random) { stops_ = stops_of(spheres_, strip_, random); }

  /// Whether the line's path has a regular end. The line is `found` if Newton's method converges there.
  bool take(const ComplexTangent& wide) {
    ScaledLine line = ScaledLine::of(strip_, wide);
    for (std::size_t i = 1; i + 1 < stops_.size(); ++i)
      if (!follow(stops_[i - 1], stops_[i], line)) return false;
    const bool is_regular = follow(stops_[stops_.size() - 2], stops_.back(), line);
    return take_end(line) && is_regular;
  }

  TangentsInStrip lines;

 private:
  bool follow(const Stop& from, const Stop& to, ScaledLine& line) {
    const double b = line.balancing_rotation(1 / from.width);
    const ScaledLine start = line.turned(b).normalised();
    const SqueezeHomotopy homotopy(from.spheres.turned(b), to.spheres.turned(b), start);
    SqueezeHomotopy::Vector x;
    x << start.direction, start.scaled_point;
    const auto end = PathTracker<SqueezeHomotopy>(homotopy, work_).follow(x);
    line = ScaledLine{end.x.head<3>(), end.x.tail<3>()}.turned(1 / b);
    return end.kind == TrackingEnd<6>::Kind::regular;
  }

  bool take_end(const ScaledLine& line) {
    const auto refined = refined_in_strip(spheres_, strip_, line, work_);
    if (refined) lines.take(*refined);
    return refined.has_value();
  }

  const FourSpheres& spheres_;
  const Strip& strip_;
  std::vector<Stop> stops_;
  WorkCounters& work_;
};

}  // namespace

SqueezedTangents squeezed_tangents(const FourSpheres& spheres, const Strip& strip, const FoundTangents& wide,
                                   std::mt19937_64& random, WorkCounters& work) {
  Squeeze squeeze(spheres, strip, work);
  squeeze.lines.found.at_infinity = wide.at_infinity;
  std::vector<bool> has_end(wide.lines.size(), false);
  const auto is_done = [&] {
    return squeeze.lines.found.accounted_for() == wide.accounted_for() &&
           std::find(has_end.begin(), has_end.end(), false) == has_end.end();
  };
  for (int attempt = 0; attempt < most_attempts && !is_done(); ++attempt) {
    squeeze.perturb(random);
    for (std::size_t i = 0; i < wide.lines.size(); ++i)
      if (wide.lines[i].multiplicity == 1 && squeeze.take(wide.lines[i].line)) has_end[i] = true;
  }
  return {std::move(squeeze.lines.found), std::move(has_end)};
}

}  // namespace gcs
