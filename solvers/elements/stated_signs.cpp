#include "solvers/elements/stated_signs.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/system_builder.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

using Segment = std::array<int, 2>;

bool is_angle_of_segments(const Relation& relation) {
  return value_kind(relation) == ConstraintType::Value::angle && relation.of[0].is_segment() &&
         relation.of[1].is_segment();
}

Segment sorted_ends(const Operand& segment) {
  const auto [first, second] = std::minmax(segment.entity, segment.end);
  return {first, second};
}

/// Whether its length is one of its equations, and not the square.
bool has_length(const ProblemStatement& problem, const Segment& segment) {
  return std::ranges::any_of(problem.constraints, [&](const DistanceConstraint& c) {
    const auto [a, b] = std::minmax(c.between[0], c.between[1]);
    return !c.is_squared && Segment{a, b} == segment;
  });
}

double cosine_of(const Relation& relation) { return rounded_to_double(given_cosine(relation, false)).real(); }

StatedSign sign_of_orientation(const Relation& relation, int number) {
  StatedSign stated{number, {}, true, relation.sign};
  for (std::size_t i = 1; i < relation.of.size(); ++i)
    stated.ways.push_back({relation.of[0].entity, relation.of[i].entity});
  return stated;
}

StatedSign sign_of_angle(const Relation& relation, int number) {
  StatedSign stated{number, {}, false, cosine_of(relation) > 0 ? 1 : -1};
  for (const Operand& of : relation.of) stated.ways.push_back({of.entity, of.end});
  return stated;
}

template <typename Scalar>
using Vector = std::array<Scalar, 3>;

template <typename Scalar>
Scalar inner_product(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Scalar>
Vector<Scalar> vector_product(const Vector<Scalar>& a, const Vector<Scalar>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What has the sign.
template <typename Scalar>
Scalar signed_value(const StatedSign& stated, const std::vector<Vector<Scalar>>& ways) {
  if (!stated.is_determinant) return inner_product(ways[0], ways[1]);
  const Vector<Scalar> area = vector_product(ways[0], ways[1]);
  return ways.size() == 2 ? area[2] : inner_product(area, ways[2]);
}

EnclosedPoint difference(const EnclosedPoint& a, const EnclosedPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Standing standing_of(const StatedSign& stated, const std::function<EnclosedPoint(int)>& at) {
  std::vector<EnclosedPoint> ways;
  for (const auto& [from, to] : stated.ways) ways.push_back(difference(at(to), at(from)));
  const Interval value = signed_value(stated, ways);
  // Not a number, where nothing is known, is on neither side.
  if (stated.sign > 0 ? value.low > 0 : value.high < 0) return Standing::as_stated;
  if (stated.sign > 0 ? value.high < 0 : value.low > 0) return Standing::not_as_stated;
  return Standing::undecided;
}

/// Signs of lengths, which spread along the angles from segments whose signs are known.
class SegmentSenses {
 public:
  SegmentSenses(const ProblemStatement& problem, const ComplexPoints& points) : points_(points) {
    for (const Relation& relation : problem.relations) {
      if (!is_angle_of_segments(relation)) continue;
      angles_.push_back(&relation);
      for (const Operand& of : relation.of) sense_.emplace(sorted_ends(of), 0);
    }
    for (auto& [segment, sense] : sense_)
      if (has_length(problem, segment)) sense = 1;
    spread();
    for (auto& [segment, sense] : sense_) {
      if (sense != 0) continue;
      sense = 1;
      spread();
    }
  }

  std::vector<Segment> turned() const {
    std::vector<Segment> result;
    for (const auto& [segment, sense] : sense_)
      if (sense < 0) result.push_back(segment);
    return result;
  }

 private:
  void spread() {
    for (bool is_new = true; is_new;) {
      is_new = false;
      for (const Relation* angle : angles_) {
        int &a = sense_.at(sorted_ends(angle->of[0])), &b = sense_.at(sorted_ends(angle->of[1]));
        if ((a == 0) == (b == 0)) continue;
        (a == 0 ? a : b) = (a + b) * agreement(*angle);
        is_new = true;
      }
    }
  }

  /// 1, or −1 where the cosine with one segment turned over is nearer to the given one.
  int agreement(const Relation& angle) const {
    const std::complex<double> cosine = bilinear_product(direction(angle.of[0]), direction(angle.of[1]));
    const double given = cosine_of(angle);
    return std::abs(cosine + given) < std::abs(cosine - given) ? -1 : 1;
  }

  /// With a length of positive real part.
  Eigen::Vector3cd direction(const Operand& segment) const {
    return unit_vector(points_.col(segment.end) - points_.col(segment.entity));
  }

  const ComplexPoints& points_;
  std::vector<const Relation*> angles_;
  std::map<Segment, int> sense_;  // 0: not known yet
};

}  // namespace

std::vector<StatedSign> stated_signs(const ProblemStatement& problem) {
  std::vector<StatedSign> signs;
  for (int i = 0; i < static_cast<int>(problem.relations.size()); ++i) {
    const Relation& relation = problem.relations[static_cast<std::size_t>(i)];
    if (relation.sign != 0) {
      signs.push_back(sign_of_orientation(relation, i));
    } else if (is_angle_of_segments(relation) && !std::ranges::all_of(relation.of, [&](const Operand& of) {
                 return has_length(problem, sorted_ends(of));
               })) {
      signs.push_back(sign_of_angle(relation, i));
    }
  }
  return signs;
}

std::optional<ProblemStatement> without_orientations(ProblemStatement problem) {
  const auto orientations = std::erase_if(problem.relations, [](const Relation& r) { return r.sign != 0; });
  return orientations > 0 ? std::optional(std::move(problem)) : std::nullopt;
}

SignVerdict verdict_on(const std::vector<StatedSign>& signs, const std::function<EnclosedPoint(int)>& at) {
  SignVerdict verdict;
  for (const StatedSign& stated : signs) {
    const Standing standing = standing_of(stated, at);
    if (standing == Standing::as_stated || standing < verdict.standing) continue;
    if (standing > verdict.standing) verdict = {standing, {}};
    verdict.relations.push_back(stated.relation);
  }
  return verdict;
}

SignVerdict verdict_on(const std::vector<StatedSign>& signs, const Figure& figure, double error) {
  return verdict_on(signs, [&](int point) {
    const Eigen::Vector3d at = figure.points.col(point);
    const Interval off = interval_around_zero(error);
    return EnclosedPoint{exact_interval(at.x()) + off, exact_interval(at.y()) + off,
                         exact_interval(at.z()) + off};
  });
}

std::vector<int> flat_orientations(const std::vector<StatedSign>& signs, const ComplexPoints& points) {
  constexpr double rounding = 1e-9;  // relative; what a singular value is that counts as 0
  std::vector<int> flat;
  for (const StatedSign& stated : signs) {
    if (!stated.is_determinant) continue;
    double size = 1;
    std::vector<Vector<std::complex<double>>> ways;
    for (const auto& [from, to] : stated.ways) {
      const Eigen::Vector3cd way = points.col(to) - points.col(from);
      size *= way.norm();
      ways.push_back({way.x(), way.y(), way.z()});
    }
    if (std::abs(signed_value(stated, ways)) <= rounding * size) flat.push_back(stated.relation);
  }
  return flat;
}

std::vector<std::array<int, 2>> turned_segments(const ProblemStatement& problem,
                                                const ComplexPoints& points) {
  return SegmentSenses(problem, points).turned();
}

}  // namespace gcs
