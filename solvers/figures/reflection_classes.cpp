#include "solvers/figures/reflection_classes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "solvers/figures/congruence.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// Numbers that are equal for two figures if and only if the figures are the same class; a small change of
/// the figure changes each by as little.
using Signature = std::vector<double>;

Eigen::Vector3d foot(const LinePosition& line, const Eigen::Vector3d& point) {
  return line.point + line.direction * line.direction.dot(point - line.point);
}

/// The points of the figure, then of every line the feet of the perpendiculars from all points.
std::vector<Eigen::Vector3d> points_and_feet(const Figure& figure) {
  std::vector<Eigen::Vector3d> result;
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i) result.push_back(figure.points.col(i));
  for (const LinePosition& line : figure.lines) {
    for (Eigen::Index i = 0; i < figure.points.cols(); ++i)
      result.push_back(foot(line, figure.points.col(i)));
  }
  return result;
}

/// Length of the chord between two unit vectors up to sign: unlike a cosine it feels small angles.
double chord(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return std::min((u - v).norm(), (u + v).norm());
}

Signature distances(const Figure& figure, double size) {
  Signature signature;
  const std::vector<Eigen::Vector3d> points = points_and_feet(figure);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) signature.push_back((points[i] - points[j]).norm());
  }
  for (std::size_t i = 0; i < figure.lines.size(); ++i) {
    for (std::size_t j = i + 1; j < figure.lines.size(); ++j) {
      signature.push_back(size * chord(figure.lines[i].direction, figure.lines[j].direction));
    }
  }
  return signature;
}

/// Of a line the point nearest to the origin and the products u_i u_j, which no sign of u changes.
Signature coordinates(const Figure& figure, double size) {
  Signature signature;
  const auto append = [&](const auto& values) {
    signature.insert(signature.end(), values.begin(), values.end());
  };
  append(figure.points.reshaped());
  for (const LinePosition& line : figure.lines) {
    append(foot(line, Eigen::Vector3d::Zero()));
    append((size * line.direction * line.direction.transpose()).eval().reshaped());
  }
  return signature;
}

/// As points_and_feet for a complex figure.
ComplexPoints complex_points_and_feet(const Figure& figure) {
  const ComplexPoints points = complex_points(figure);
  const std::vector<ComplexLine> lines = complex_lines(figure);
  const Eigen::Index n = points.cols();
  ComplexPoints result(3, n * (1 + static_cast<Eigen::Index>(lines.size())));
  result.leftCols(n) = points;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (Eigen::Index p = 0; p < n; ++p)
      result.col(n * (static_cast<Eigen::Index>(i) + 1) + p) = foot(lines[i], points.col(p));
  return result;
}

/// Of a complex figure with one line at most the squared distances, real and imaginary parts, over the size:
/// the group is that of complex rotations and reflections. Twice as many numbers as a real figure has, and so
/// never equal to one.
Signature squared_distances(const Figure& figure, double size) {
  Signature signature;
  const ComplexPoints points = complex_points_and_feet(figure);
  signature.reserve(static_cast<std::size_t>(points.cols() * (points.cols() - 1)));
  for (int a = 0; a < static_cast<int>(points.cols()); ++a) {
    for (int b = 0; b < a; ++b) {
      const std::complex<double> square = squared_distance(points, a, b) / size;
      signature.push_back(square.real());
      signature.push_back(square.imag());
    }
  }
  return signature;
}

/// As `coordinates`, real and imaginary parts: twice as many numbers as a real figure has.
Signature complex_coordinates(const Figure& figure, double size) {
  Signature signature;
  const auto append = [&](const auto& values) {
    for (const std::complex<double>& value : values)
      signature.insert(signature.end(), {value.real(), value.imag()});
  };
  append(complex_points(figure).reshaped());
  for (const ComplexLine& line : normalised(complex_lines(figure))) {
    append(line.point);
    append((size * line.direction * line.direction.transpose()).eval().reshaped());
  }
  return signature;
}

/// Of a line the feet of the perpendiculars.
ComplexPoints points_to_place(const Figure& figure) {
  if (!figure.is_real()) return complex_points_and_feet(figure);
  const std::vector<Eigen::Vector3d> real = points_and_feet(figure);
  ComplexPoints points(3, static_cast<Eigen::Index>(real.size()));
  for (std::size_t i = 0; i < real.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = real[i].cast<std::complex<double>>();
  return points;
}

Signature signature_of(const Scene& scene, const Figure& figure) {
  if (!figure.is_real())
    return scene.is_anchored() ? complex_coordinates(figure, scene.size())
                               : squared_distances(figure, scene.size());
  return scene.is_anchored() ? coordinates(figure, scene.size()) : distances(figure, scene.size());
}

bool equal(const Signature& a, const Signature& b, double tolerance) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [tolerance](double x, double y) { return std::abs(x - y) <= tolerance; });
}

/// Sums of every fourth number of a signature, from the first, second, third and fourth on.
struct SignatureSums {
  std::array<double, 4> sums{};
  double magnitude = 0;     ///< bounds all partial sums, to which rounding is relative
  std::size_t numbers = 0;  ///< of the signature

  SignatureSums() = default;
  explicit SignatureSums(const Signature& signature) : numbers(signature.size()) {
    for (std::size_t i = 0; i < signature.size(); ++i) {
      sums[i % 4] += signature[i];
      magnitude += std::abs(signature[i]);
    }
  }
  double total() const { return std::accumulate(sums.begin(), sums.end(), 0.0); }
};

std::vector<SignatureSums> sums_of(const Scene& scene, std::span<const Figure* const> figures, int threads) {
  std::vector<SignatureSums> sums(figures.size());
  share_on_threads(figures.size(), threads,
                   [&](std::size_t i) { sums[i] = SignatureSums(signature_of(scene, *figures[i])); });
  return sums;
}

/// How far apart sums may be of so many numbers that differ by the tolerance, or only in rounding of the last bits.
double window(std::size_t numbers, double tolerance, double magnitude) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * magnitude;
  return static_cast<double>(numbers) * (tolerance + rounding);
}

/// The first figures of the classes found so far, ordered by the sums of their signatures: equal figures have close
/// sums. Those of different tolerance, to a factor of ten, are kept apart, so that coarse ones do not widen
/// the search for all. Signatures are many times as long as figures, so they are made again, where all four sums
/// are close: of a million figures, hundreds have a total as close.
class ClassIndex {
 public:
  /// Of all figures.
  explicit ClassIndex(std::vector<SignatureSums> sums) : sums_(std::move(sums)) {}

  /// Whether a figure's sums are numbers: else they have no place in an order.
  bool is_ordered(int figure) const { return std::isfinite(sums_[figure].magnitude); }

  /// The first one for which `equals` holds, of those whose sums may be equal, or −1.
  template <typename Equals>
  int find(int figure, double tolerance, Equals equals) const {
    int found = -1;
    const SignatureSums& sums = sums_[figure];
    for (const auto& [bound, firsts] : by_tolerance_) {
      const double either = std::max(tolerance, bound);
      const double reach = window(sums.numbers, either, sums.magnitude);
      const double part_reach = window((sums.numbers + 3) / 4, either, sums.magnitude);
      const auto end = firsts.upper_bound(sums.total() + reach);
      for (auto entry = firsts.lower_bound(sums.total() - reach); entry != end; ++entry)
        if ((found < 0 || entry->second < found) &&
            are_close(sums.sums, sums_[entry->second].sums, part_reach) && equals(entry->second))
          found = entry->second;
    }
    return found;
  }

  void add(int figure, double tolerance) {
    by_tolerance_[next_power_of_ten(tolerance)].emplace(sums_[figure].total(), figure);
  }

 private:
  static bool are_close(const std::array<double, 4>& a, const std::array<double, 4>& b, double reach) {
    return std::ranges::equal(a, b, [reach](double x, double y) { return std::abs(x - y) <= reach; });
  }

  static double next_power_of_ten(double tolerance) {
    return tolerance > 0 ? std::max(tolerance, std::pow(10, std::ceil(std::log10(tolerance)))) : 0;
  }

  std::vector<SignatureSums> sums_;
  std::map<double, std::multimap<double, int>> by_tolerance_;
};

}  // namespace

ReflectionClasses reflection_classes(const Scene& scene, std::span<const Figure> figures, double tolerance,
                                     int threads) {
  std::vector<const Figure*> all;
  for (const Figure& figure : figures) all.push_back(&figure);
  return reflection_classes(scene, all, std::vector<ClassTolerance>(all.size(), {tolerance}), threads);
}

ReflectionClasses reflection_classes(const Scene& scene, std::span<const Figure* const> figures,
                                     std::span<const ClassTolerance> tolerances, int threads) {
  ReflectionClasses classes;
  ClassIndex index(sums_of(scene, figures, threads));
  for (int i = 0; i < static_cast<int>(figures.size()); ++i) {
    const double tolerance = tolerances[i].distances * scene.size();
    Signature signature;  // once a class may be the figure's
    const auto equals = [&](int first) {
      const double either = std::max(tolerances[i].distances, tolerances[first].distances) * scene.size();
      if (signature.empty()) signature = signature_of(scene, *figures[i]);
      if (!equal(signature, signature_of(scene, *figures[first]), either)) return false;
      const double places = std::max(tolerances[i].places, tolerances[first].places) * scene.size();
      return scene.is_anchored() || !std::isfinite(places) ||
             may_be_congruent(points_to_place(*figures[i]), points_to_place(*figures[first]), places);
    };
    const int first = index.is_ordered(i) ? index.find(i, tolerance, equals) : -1;
    classes.class_of.push_back(first < 0 ? classes.count() : classes.class_of[first]);
    if (first >= 0) continue;
    classes.first.push_back(i);
    if (index.is_ordered(i)) index.add(i, tolerance);
  }
  return classes;
}

}  // namespace gcs
