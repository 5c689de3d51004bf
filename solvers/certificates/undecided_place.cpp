#include "solvers/certificates/undecided_place.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "solvers/certificates/ball_cluster.hpp"
#include "solvers/certificates/coincidences.hpp"
#include "solvers/certificates/near_solutions.hpp"

namespace gcs {
namespace {

constexpr slong bits = 256;
constexpr double rounded_out = 1 + 0x1p-50;

/// Of unknowns of order 1: mirror images that are further from each other are not of one place.
constexpr double one_place = 1e-3;

using Point = std::vector<std::complex<double>>;

void widen(Box& hull, const Eigen::VectorXd& mid, const Eigen::VectorXd& radius) {
  const Eigen::VectorXd reach = ((mid - hull.mid).cwiseAbs() + radius) * rounded_out;
  hull.radius = hull.radius.cwiseMax(reach);
}

/// Where a real solution is.
Box real_box(const Enclosure& enclosure) {
  const auto n = static_cast<Eigen::Index>(enclosure.mid.size());
  Box box{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    box.mid[i] = enclosure.mid[static_cast<std::size_t>(i)].real();
    box.radius[i] = enclosure.radius[static_cast<std::size_t>(i)].real();
  }
  return box;
}

/// A solution at the place.
struct Zero {
  Certificate proof;
  std::size_t of_class = 0;
  double distance = 0;

  int count() const { return proof.is_proven ? 1 : proof.cluster; }
};

class Place {
 public:
  Place(const QuadraticSystem& system, const Box& box)
      : system_(system),
        balls_(system, bits),
        box_(box),
        x_(box.mid.begin(), box.mid.end()),
        no_mirror_(std::vector<SignMask>(x_.size(), 0)) {}

  std::optional<std::vector<CountedSolution>> real_solutions(const std::stop_token& stop) const {
    std::vector<double> reach(box_.radius.begin(), box_.radius.end());
    const int expected = solutions_about(balls_, BallKrawczyk::vector(x_), reach);
    if (expected == 0) return std::nullopt;
    std::map<std::size_t, CountedSolution> classes;
    int left = expected;
    for (const Zero& zero : nearest_first(proven(expected, stop))) {
      if (left <= 0) break;
      left -= zero.count();
      for (std::size_t i = 0; i < reach.size(); ++i)
        reach[i] = std::max(reach[i], zero.proof.offset(i, x_[i]));
      if (zero.proof.realness == Certificate::Realness::real) classes.emplace(zero.of_class, counted(zero));
    }
    if (left != 0 || solutions_about(balls_, BallKrawczyk::vector(x_), reach) != expected)
      return std::nullopt;
    std::vector<CountedSolution> list;
    for (auto& [number, solution] : classes) list.push_back(std::move(solution));
    return list;
  }

 private:
  /// What balls find of so many solutions.
  std::vector<Certificate> proven(int expected, const std::stop_token& stop) const {
    NearSolutions near = solutions_near(system_, {{x_, expected}}, expected, stop);
    std::vector<Certificate> list = std::move(near.simple);
    if (near.multiple.empty()) return list;
    const Certifier certifier(system_);
    for (const MultipleSolution& multiple : near.multiple) {
      Certificate certificate = certifier.certify(multiple.x);
      if (certificate.is_multiple) list.push_back(std::move(certificate));
    }
    return list;
  }

  /// Of a multiple one images that meet are one: the least fractions of an interval about 0 are 0.
  CountedSolution counted(const Zero& zero) const {
    const Enclosure& enclosure = zero.proof.enclosure;
    CountedSolution solution{real_box(enclosure), std::max(0.0, enclosure.unique)};
    if (zero.proof.is_proven) return solution;
    const int images = meeting_images(enclosure, system_.mirror);
    solution.multiplicity = (zero.count() + images - 1) / images;
    return solution;
  }

  std::vector<Zero> nearest_first(const std::vector<Certificate>& classes) const {
    std::vector<Zero> zeros;
    for (std::size_t number = 0; number < classes.size(); ++number)
      add_images(classes[number], number, zeros);
    std::sort(zeros.begin(), zeros.end(), [](const Zero& a, const Zero& b) {
      return std::pair(a.distance, a.of_class) < std::pair(b.distance, b.of_class);
    });
    return zeros;
  }

  /// The image that is nearest, and those of it by generators that move it by little; each that is proven to be another one.
  void add_images(const Certificate& proof, std::size_t number, std::vector<Zero>& zeros) const {
    std::vector<Certificate> images{turned(proof, signs_of_nearest(proof))};
    const SignMask generators = generators_of(system_.mirror);
    for (SignMask generator = 1; generator != 0 && generator <= generators; generator <<= 1U) {
      const Eigen::VectorXd signs = signs_by(system_.mirror, generator);
      const Certificate image = turned(images.front(), signs);
      if (!(largest_difference(image.enclosure.mid, images.front().enclosure.mid) <= one_place)) continue;
      for (std::size_t i = 0, known = images.size(); i < known; ++i)
        images.push_back(turned(images[i], signs));
    }
    for (Certificate& image : images) {
      const auto may_be = [&](const Zero& zero) {
        return !coincidences({image.enclosure, zero.proof.enclosure}, no_mirror_).empty();
      };
      if (std::none_of(zeros.begin(), zeros.end(), may_be))
        zeros.push_back({image, number, largest_difference(image.enclosure.mid, x_)});
    }
  }

  Eigen::VectorXd signs_of_nearest(const Certificate& proof) const {
    return signs_towards(system_.mirror, generators_of(system_.mirror), real_box(proof.enclosure).mid,
                         box_.mid);
  }

  static Certificate turned(Certificate proof, const Eigen::VectorXd& signs) {
    for (std::size_t i = 0; i < proof.enclosure.mid.size(); ++i)
      proof.enclosure.mid[i] *= signs[static_cast<Eigen::Index>(i)];
    return proof;
  }

  const QuadraticSystem& system_;
  BallKrawczyk balls_;
  const Box& box_;
  Point x_;
  SignMasks no_mirror_;
};

}  // namespace

std::vector<UndecidedPlace> undecided_places(const std::vector<Box>& boxes, const SignMasks& mirror,
                                             double reach) {
  std::vector<UndecidedPlace> places;
  for (std::size_t number = 0; number < boxes.size(); ++number) {
    const Box& box = boxes[number];
    const auto near = [&](const UndecidedPlace& place) {
      return (turned_towards(mirror, box.mid, place.hull.mid) - place.hull.mid).cwiseAbs().maxCoeff() <=
             reach;
    };
    const auto place = std::find_if(places.begin(), places.end(), near);
    if (place == places.end()) {
      places.push_back({box, {number}});
    } else {
      widen(place->hull, turned_towards(mirror, box.mid, place->hull.mid), box.radius);
      place->members.push_back(number);
    }
  }
  return places;
}

std::optional<std::vector<CountedSolution>> real_solutions_in(const QuadraticSystem& system, const Box& box,
                                                              const std::stop_token& stop) {
  return Place(system, box).real_solutions(stop);
}

}  // namespace gcs
