#include "solvers/certificates/box_search.hpp"

#include <Eigen/SVD>
#include <algorithm>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Narrowing to less than this is worth another look at the same part before halving it.
constexpr double worth_a_pass = 0.5;

/// Of the coordinates' rounding: a shorter part is not told from its neighbours.
constexpr double narrowest = 16 * epsilon;

class SearchedDistances {
 public:
  SearchedDistances(const DistanceSystem& system, const std::vector<DoubleDouble>& squares)
      : system_(system), squares_(squares) {}

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd result(system_.equations(), system_.unknowns());
    system_.jacobian(system_.figure(x).points, result);
    return result;
  }
  std::optional<KrawczykImage<double>> image(const Eigen::MatrixXd& axes, const SkewBox& box) const {
    return krawczyk_image(system_, squares_, axes, box);
  }
  bool has_one_solution(const Box& box) const {
    return krawczyk(system_, squares_, box) == BoxContent::one_solution;
  }
  bool refine(Eigen::VectorXd& x) const { return gcs::refine(system_, squares_, x).converged; }

 private:
  const DistanceSystem& system_;
  const std::vector<DoubleDouble>& squares_;
};

class SearchedSystem {
 public:
  explicit SearchedSystem(const KrawczykTest& test) : test_(test) {}

  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const { return test_.jacobian(x); }
  std::optional<KrawczykImage<double>> image(const Eigen::MatrixXd& axes, const SkewBox& box) const {
    return test_.image(axes, box);
  }
  bool has_one_solution(const Box& box) const {
    const auto image = test_.image(box);
    return image && image->is_inside(box.radius);
  }
  bool refine(Eigen::VectorXd& x) const {
    std::int64_t iterations = 0;
    return test_.refine(x, iterations);
  }

 private:
  const KrawczykTest& test_;
};

/// Equations: one of the two above.
template <class Equations>
class BoxSearch {
 public:
  BoxSearch(const Equations& equations, const Box& box) : equations_(equations), box_(box) {
    axes_ = Eigen::JacobiSVD<Eigen::MatrixXd>(equations.jacobian(box.mid), Eigen::ComputeFullV).matrixV();
    const auto m = static_cast<double>(axes_.rows());
    const Eigen::MatrixXd products = axes_.transpose() * axes_;
    const Eigen::MatrixXd defect = products - Eigen::MatrixXd::Identity(axes_.rows(), axes_.rows());
    const Eigen::VectorXd row_sums = defect.cwiseAbs().rowwise().sum();
    skew_ = 2 * row_sums.maxCoeff() + 4 * m * m * epsilon;
  }

  std::optional<std::vector<Box>> run(int most_parts) {
    if (!axes_.allFinite() || !(skew_ < 0.5)) return std::nullopt;
    pending_.push_back({box_.mid, along_axes(box_.radius)});
    for (int parts = 0; !pending_.empty(); ++parts) {
      if (parts == most_parts) return std::nullopt;
      const SkewBox part = std::move(pending_.back());
      pending_.pop_back();
      if (!visit(part)) return std::nullopt;
    }
    return std::move(found_);
  }

 private:
  /// How far at most the vectors x with |x_i| ≤ reach_i go along the axes, which are orthogonal but for
  /// rounding.
  Eigen::VectorXd along_axes(const Eigen::VectorXd& reach) const {
    const Eigen::VectorXd along = axes_.cwiseAbs().transpose() * reach;
    return along * (1 + skew_) + Eigen::VectorXd::Constant(along.size(), skew_ * along.maxCoeff());
  }

  /// What rounding leaves open of a middle that was computed.
  Eigen::VectorXd rounding_of(const Eigen::VectorXd& mid) const {
    return along_axes(4 * epsilon * mid.cwiseAbs());
  }

  double size_of(const Eigen::VectorXd& x) const { return x.cwiseAbs().maxCoeff(); }

  /// False where the part cannot be decided.
  bool visit(const SkewBox& part) {
    const auto image = equations_.image(axes_, part);
    if (image && image->misses(part.radius)) return true;
    if (image && is_one_at_most(*image, part) && is_taken(part)) return true;
    if (!(part.radius.maxCoeff() > narrowest * size_of(part.mid))) return false;
    SkewBox left = image ? narrowed(*image, part) : part;
    if (left.radius.sum() < worth_a_pass * part.radius.sum())
      pending_.push_back(std::move(left));
    else
      halve(left);
    return true;
  }

  /// Whether the Jacobian is regular on the part.
  static bool is_one_at_most(const KrawczykImage<double>& image, const SkewBox& part) {
    return (image.spread.array() < part.radius.array()).all();
  }

  /// Whether a solution is proven to be the only one in a box around it and the part. That box needs room for
  /// the rounding of the solution, and as little as can be beside other solutions.
  bool is_taken(const SkewBox& part) {
    Eigen::VectorXd x = part.mid;
    if (!equations_.refine(x)) return false;
    const Eigen::VectorXd way = along_axes((x - part.mid).cwiseAbs());
    SkewBox around{x, (part.radius + way) * (1 + 4 * epsilon) + rounding_of(x)};
    // Hardly larger along the coordinates, and with room for a box along them.
    const double even = around.radius.maxCoeff() / (4 * static_cast<double>(x.size()));
    const auto is_kept = [&](double room) {
      around.radius = around.radius.cwiseMax(std::max(even, room * size_of(x)));
      const auto image = equations_.image(axes_, around);
      return image && image->is_inside(around.radius) && keep(around);
    };
    return is_kept(0) || is_kept(0x1p8 * epsilon) || is_kept(0x1p14 * epsilon);
  }

  /// The solution in `around`, by a box along the coordinates, unless that misses the box searched.
  bool keep(const SkewBox& around) {
    Box tight{around.mid, (axes_.cwiseAbs() * around.radius) * (1 + 4 * epsilon)};
    while (!equations_.has_one_solution(tight) || !holds(around, tight)) {
      tight.radius *= 0.125;
      if (!(size_of(tight.radius) > epsilon * size_of(tight.mid))) return false;
    }
    const Eigen::VectorXd apart = (tight.mid - box_.mid).cwiseAbs() * (1 - 4 * epsilon);
    if ((apart.array() <= (tight.radius + box_.radius).array()).all()) found_.push_back(std::move(tight));
    return true;
  }

  /// Whether `inner` of the same middle lies inside.
  bool holds(const SkewBox& around, const Box& inner) const {
    return (along_axes(inner.radius).array() <= around.radius.array()).all();
  }

  /// What of the part is in the image.
  SkewBox narrowed(const KrawczykImage<double>& image, const SkewBox& part) const {
    const Eigen::ArrayXd spread = image.spread.array() * (1 + 4 * epsilon);
    const Eigen::ArrayXd low = (-image.move.array() - spread).max(-part.radius.array());
    const Eigen::ArrayXd high = (-image.move.array() + spread).min(part.radius.array());
    return moved(part.mid, (low + high) / 2, ((high - low) / 2).max(0));
  }

  void halve(const SkewBox& part) {
    Eigen::Index longest = 0;
    part.radius.maxCoeff(&longest);
    Eigen::VectorXd radius = part.radius;
    radius[longest] /= 2;
    Eigen::VectorXd way = Eigen::VectorXd::Zero(radius.size());
    for (const double sign : {1.0, -1.0}) {
      way[longest] = sign * radius[longest];
      pending_.push_back(moved(part.mid, way, radius));
    }
  }

  SkewBox moved(const Eigen::VectorXd& mid, const Eigen::VectorXd& way, const Eigen::VectorXd& radius) const {
    const Eigen::VectorXd x = mid + axes_ * way;
    const Eigen::VectorXd rounding = rounding_of(x.cwiseAbs() + axes_.cwiseAbs() * way.cwiseAbs());
    return {x, radius * (1 + 4 * epsilon) + rounding};
  }

  const Equations& equations_;
  const Box& box_;
  Eigen::MatrixXd axes_;
  double skew_ = 0;  ///< bound on |axes⁻¹ − axesᵀ| by rows, relative to what axesᵀ gives
  std::vector<SkewBox> pending_;
  std::vector<Box> found_;
};

}  // namespace

std::optional<std::vector<Box>> solutions_in(const DistanceSystem& system,
                                             const std::vector<DoubleDouble>& squares, const Box& box,
                                             int most_parts) {
  const SearchedDistances equations(system, squares);
  return BoxSearch(equations, box).run(most_parts);
}

std::optional<std::vector<Box>> solutions_in(const KrawczykTest& test, const Box& box, int most_parts) {
  const SearchedSystem equations(test);
  return BoxSearch(equations, box).run(most_parts);
}

}  // namespace gcs
