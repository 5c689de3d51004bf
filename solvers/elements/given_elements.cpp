#include "solvers/elements/given_elements.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>

#include "solvers/elements/body_motion.hpp"
#include "solvers/elements/exact_coordinates.hpp"
#include "solvers/model/frame_choice.hpp"

namespace gcs {
namespace {

/// The numbers of given positions, exactly as they are known.
class GivenNumbers {
 public:
  explicit GivenNumbers(const ProblemStatement& problem) : problem_(problem) {}

  std::vector<Decimal> of(int entity) const {
    const auto row = fixed_text_row(problem_, entity);
    std::vector<Decimal> numbers;
    if (problem_.is_point(entity)) {
      append(problem_.fixed_points[static_cast<std::size_t>(entity)]->head(problem_.dimension), row, numbers);
    } else if (problem_.is_line(entity)) {
      const LinePosition& line = *problem_.fixed_lines[static_cast<std::size_t>(problem_.line_of(entity))];
      append(line.point.head(problem_.dimension), row, numbers);
      append(line.direction.head(problem_.dimension), row + 1, numbers);
    } else {
      const PlanePosition& plane =
          *problem_.fixed_planes[static_cast<std::size_t>(problem_.plane_of(entity))];
      append(plane.normal, row, numbers);
      append(Eigen::Matrix<double, 1, 1>(plane.offset), row + 1, numbers);
    }
    return numbers;
  }

 private:
  void append(const Eigen::VectorXd& values, std::size_t row, std::vector<Decimal>& numbers) const {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const std::string text =
          row < problem_.fixed_texts.size() ? problem_.fixed_texts[row][static_cast<std::size_t>(i)] : "";
      numbers.push_back({text.empty() ? values[i] : std::strtod(text.c_str(), nullptr), text});
    }
  }

  const ProblemStatement& problem_;
};

RationalVector times(const Rational& factor, const RationalVector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// What v has across a direction.
RationalVector part_across(const RationalVector& v, const RationalVector& direction) {
  return v - times(dot(v, direction) / dot(direction, direction), direction);
}

/// The first of the axes along which the vector is shortest.
RationalVector least_along(const RationalVector& v) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if ((v[i] * v[i] - v[least] * v[least]).sign() < 0) least = i;
  RationalVector axis;
  axis[least] = Rational(1);
  return axis;
}

/// What a GivenAxis says, in a unit of 2^−exponent of the file's.
class FrameReader {
 public:
  FrameReader(const ProblemStatement& problem, const std::vector<BodyElement>& elements, int exponent)
      : given_(given_axis(problem)), problem_(problem), elements_(elements), exponent_(exponent) {}

  GivenFrame run() const {
    GivenFrame frame;
    frame.leaves_shift = given_.leaves_shift();
    frame.x = first_axis();
    frame.origin = first_point(frame.x);
    const bool is_flat = problem_.dimension == 2;
    if (is_flat)
      frame.z[2] = Rational(1);
    else
      frame.z = cross(frame.x, frame.leaves_shift ? way_across(0, frame.x) : least_along(frame.x));
    frame.y = cross(frame.z, frame.x);
    if (!frame.leaves_shift) return frame;
    RationalVector& last = is_flat ? frame.y : frame.z;
    if (dot(last, way_across(is_flat ? 0 : 1, frame.x)).sign() < 0) {
      frame.x = times(Rational(-1), frame.x);
      last = times(Rational(-1), last);
    }
    return frame;
  }

 private:
  const BodyElement& element(int entity) const {
    return *std::ranges::find(elements_, entity, &BodyElement::entity);
  }
  RationalVector point(int entity) const {
    return rational_vector(element(entity), 0, problem_.dimension, exponent_);
  }
  RationalVector direction(int entity) const {
    return rational_vector(element(entity), problem_.is_line(entity) ? problem_.dimension : 0,
                           problem_.dimension, 0);
  }
  Rational offset(int plane) const { return rational_vector(element(plane), 3, 1, exponent_)[0]; }

  RationalVector first_axis() const {
    if (given_.axis >= 0)
      return problem_.is_point(given_.axis) ? point(given_.axis) - point(given_.origin)
                                            : direction(given_.axis);
    if (given_.leaves_shift()) return cross(direction(given_.across[0]), direction(given_.across[1]));
    return {Rational(1), {}, {}};
  }

  /// Without a point on a line and then on a plane across it, or at h n/(n·n) of a plane, or of two that cross along d = n × m
  /// at (h m × d + k d × n)/(d·d).
  RationalVector first_point(const RationalVector& d) const {
    if (given_.origin >= 0) return point(given_.origin);
    if (given_.line >= 0) {
      const RationalVector at = point(given_.line), along = direction(given_.line);
      if (!given_.leaves_turn_about_line()) return at;
      return at - times((dot(d, at) - offset(given_.axis)) / dot(d, along), along);
    }
    if (given_.axis >= 0) return times(offset(given_.axis) / dot(d, d), d);
    const RationalVector n = direction(given_.across[0]), m = direction(given_.across[1]);
    return times(Rational(1) / dot(d, d),
                 times(offset(given_.across[0]), cross(m, d)) - times(offset(given_.across[1]), cross(n, d)));
  }

  /// The normal of a plane, or the way from the first line to another one, across the first axis.
  RationalVector way_across(std::size_t which, const RationalVector& axis) const {
    const int entity = given_.across[which];
    return part_across(problem_.is_plane(entity) ? direction(entity) : point(entity) - point(given_.line),
                       axis);
  }

  GivenAxis given_;
  const ProblemStatement& problem_;
  const std::vector<BodyElement>& elements_;
  int exponent_;
};

/// Chooses what a shift's axes across it are told by: what is said by the most, so that rounding does not say it.
class AcrossShift {
 public:
  AcrossShift(const ProblemStatement& problem, const std::vector<BodyElement>& given) : problem_(problem) {
    for (const BodyElement& element : given) {
      const ElementPosition position = position_in_body(problem, element);
      if (const auto* line = std::get_if<LinePosition>(&position)) add(element.entity, *line);
      if (const auto* plane = std::get_if<PlanePosition>(&position))
        ways_.emplace_back(element.entity, plane->normal);
    }
    for (auto& [entity, way] : ways_)
      if (problem.is_line(entity) && longest_ > 0) way /= longest_;
  }

  std::array<int, 2> run() const {
    const auto plane =
        std::ranges::find_if(ways_, [&](const auto& way) { return problem_.is_plane(way.first); });
    const auto& first =
        plane != ways_.end() ? *plane : *most([](const Eigen::Vector3d& way) { return way.norm(); });
    return {first.first,
            most([&](const Eigen::Vector3d& way) { return first.second.cross(way).norm(); })->first};
  }

 private:
  using Ways = std::vector<std::pair<int, Eigen::Vector3d>>;

  void add(int entity, const LinePosition& line) {
    if (!first_) first_ = line;
    const Eigen::Vector3d way = line.point - first_->point;
    ways_.emplace_back(entity, way - way.dot(first_->direction) * first_->direction);
    longest_ = std::max(longest_, ways_.back().second.stableNorm());
  }

  template <class Size>
  Ways::const_iterator most(const Size& size) const {
    return std::ranges::max_element(ways_, {}, [&](const auto& way) { return size(way.second); });
  }

  const ProblemStatement& problem_;
  std::optional<LinePosition> first_;
  double longest_ = 0;
  Ways ways_;
};

/// Of what leaves one motion and has no point: whether planes across the line leave a turn.
bool is_turn_about(const ProblemStatement& problem, const BodyElement& line, const BodyElement& plane) {
  const Eigen::Vector3d along = std::get<LinePosition>(position_in_body(problem, line)).direction;
  return std::abs(std::get<PlanePosition>(position_in_body(problem, plane)).normal.dot(along)) > 0.5;
}

}  // namespace

std::vector<BodyElement> given_elements(const ProblemStatement& problem) {
  const GivenNumbers numbers(problem);
  std::vector<BodyElement> elements;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (problem.is_fixed(entity)) elements.push_back({entity, numbers.of(entity)});
  return elements;
}

int motions_left_by_given(const ProblemStatement& problem) {
  std::vector<ElementPosition> positions;
  for (const BodyElement& element : given_elements(problem))
    positions.push_back(position_in_body(problem, element));
  return motions_left(positions, problem.dimension);
}

GivenAxis given_axis(const ProblemStatement& problem) {
  const std::vector<BodyElement> given = given_elements(problem);
  const auto first = [&](const auto& is_wanted) -> const BodyElement* {
    const auto found = std::ranges::find_if(given, is_wanted, &BodyElement::entity);
    return found == given.end() ? nullptr : &*found;
  };
  const auto entity_of = [](const BodyElement* element) { return element == nullptr ? -1 : element->entity; };
  const BodyElement* const point = first([&](int entity) { return problem.is_point(entity); });
  const BodyElement* const line = first([&](int entity) { return problem.is_line(entity); });
  const BodyElement* const plane = first([&](int entity) { return problem.is_plane(entity); });
  GivenAxis axis;
  axis.origin = entity_of(point);
  if (point == nullptr) axis.line = entity_of(line);
  const BodyElement* const other =
      first([&](int entity) { return problem.is_point(entity) && entity != axis.origin; });
  const bool is_alone = given.size() == 1 || point != nullptr || motions_left_by_given(problem) != 1 ||
                        (line != nullptr && plane != nullptr && is_turn_about(problem, *line, *plane));
  if (is_alone) {
    axis.axis = entity_of(other != nullptr ? other : plane != nullptr ? plane : line);
  } else {
    axis.axis = axis.line;
    axis.across = AcrossShift(problem, given).run();
  }
  return axis;
}

ExactFrame exact_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements) {
  const GivenFrame frame = FrameReader(problem, elements, 0).run();
  return {{unit_numbers(frame.x), unit_numbers(frame.y), unit_numbers(frame.z)}, exact_numbers(frame.origin)};
}

FramePose axial_frame(const ProblemStatement& problem, const std::vector<BodyElement>& elements) {
  const ExactFrame exact = exact_frame(problem, elements);
  FramePose frame;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    frame.origin[axis] = rounded_to_double(exact.origin[i]).real();
    for (std::size_t k = 0; k < 3; ++k)
      frame.axes(axis, static_cast<Eigen::Index>(k)) = rounded_to_double(exact.axes[i][k]).real();
  }
  return frame;
}

GivenCoordinates::GivenCoordinates(const Scene& scene)
    : problem_(scene.problem()),
      exponent_(-scene.unit_exponent()),
      frame_(FrameReader(problem_, given_elements(problem_), exponent_).run()) {}

// The elements have no other coordinates than these, to rounding: points are on the first axis, and lines and planes along it
// or across it.
std::vector<ExactNumber> GivenCoordinates::place(const BodyElement& element) const {
  const RationalVector way = rational_vector(element, 0, problem_.dimension, exponent_) - frame_.origin;
  const auto along = [&](const RationalVector& axis) {
    return over_norm(dot(way, axis), {axis.begin(), axis.end()});
  };
  if (frame_.leaves_shift) return {ExactNumber(), along(frame_.y), along(frame_.z)};
  return {problem_.is_point(element.entity) ? along(frame_.x) : ExactNumber(), {}, {}};
}

std::vector<ExactNumber> GivenCoordinates::direction(const BodyElement& element) const {
  if (problem_.is_line(element.entity)) return {exactly(1), {}, {}};
  const RationalVector normal = rational_vector(element, 0, 3, 0);
  if (frame_.leaves_shift)
    return ExactBasis(frame_.x, frame_.y).coordinates(part_across(normal, frame_.x), true);
  return {exactly(dot(normal, frame_.x).sign()), {}, {}};
}

std::vector<ExactNumber> GivenCoordinates::direction(const BodyElement& from, const BodyElement& to) const {
  return {exactly(along(from, to).sign()), {}, {}};
}

ExactNumber GivenCoordinates::distance(const BodyElement& from, const BodyElement& to) const {
  const Rational way = along(from, to);
  return over_norm(way.sign() < 0 ? Rational(0) - way : way, {frame_.x.begin(), frame_.x.end()});
}

ExactNumber GivenCoordinates::offset(const BodyElement& plane) const {
  return offset_from(frame_.origin, plane, exponent_);
}

bool GivenCoordinates::are_kept(const std::array<bool, 3>& turned_over) const {
  const auto stays = [&](const std::vector<ExactNumber>& components) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (turned_over[axis] && !components[axis].is_zero()) return false;
    return true;
  };
  return std::ranges::all_of(given_elements(problem_), [&](const BodyElement& element) {
    return problem_.is_plane(element.entity) ? stays(direction(element)) : stays(place(element));
  });
}

Rational GivenCoordinates::along(const BodyElement& from, const BodyElement& to) const {
  const auto at = [&](const BodyElement& point) {
    return rational_vector(point, 0, problem_.dimension, exponent_);
  };
  return dot(at(to) - at(from), frame_.x);
}

bool has_given_shape(const ProblemStatement& problem) {
  return problem.file_frame && problem.reference_body < 0 && given_elements(problem).size() > 1;
}

bool rest_in_frame(const ProblemStatement& problem) {
  if (problem.reference_body >= 0) return false;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (rests_in_frame(problem, entity)) return true;
  return false;
}

ProblemStatement with_given_body(ProblemStatement problem) {
  if (!rest_in_frame(problem)) return problem;
  RigidBody given{"fixed", given_elements(problem)};
  for (RigidBody& body : problem.bodies)
    if (std::ranges::all_of(
            body.elements, [&](int entity) { return problem.is_fixed(entity); }, &BodyElement::entity))
      body.elements.clear();
  problem.reference_body = static_cast<int>(problem.bodies.size());
  problem.bodies.push_back(std::move(given));
  return problem;
}

bool has_element_equations(const ProblemStatement& problem) {
  return problem.is_general() ||
         std::ranges::any_of(problem.fixed_lines, [](const auto& line) { return line.has_value(); });
}

}  // namespace gcs
