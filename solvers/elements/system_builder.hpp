#pragma once
/// The unknowns and equations of a general scene while they are written: element kinds add the unknowns of elements,
/// constraint kinds the equations between them and what further unknowns these need.

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solvers/elements/element_forms.hpp"
#include "solvers/elements/placement.hpp"
#include "solvers/elements/scene_frame.hpp"

namespace gcs {

/// A line by a point and a direction, direction·direction = 1.
struct LineForms {
  VectorForm foot;
  VectorForm direction;
  SignMask turning = 0;  ///< of the direction's sign
  bool is_foot = true;   ///< foot·direction = 0
};

/// A point of a body, by its number in the problem.
struct BodyPoint {
  int point = -1;
  VectorForm at;
  VectorForm
      origin{};  ///< of a body that moves: `at` is origin + arm, and the arm is as long as the file says
  VectorForm arm{};
  std::vector<ExactNumber> numbers{};  ///< the file's coordinates; empty: the body does not move
};

/// normal·x = offset, normal·normal = 1.
struct PlaneForms {
  VectorForm normal;
  LinearForm offset;
  SignMask turning = 0;  ///< of the sign of both
};

/// A line or a plane of a body, by its number in the problem.
struct BodyLine {
  int line = -1;
  LineForms at;
};
struct BodyPlane {
  int plane = -1;
  PlaneForms at;
};

/// The vector from one point to another is length·direction, direction·direction = 1.
struct SegmentForms {
  LinearForm length;
  VectorForm direction;
  SignMask turning = 0;  ///< of the sign of both
};

/// One between two points of a body, the first numbered lower.
struct BodySegment {
  int from = -1, to = -1;
  SegmentForms at;
};

/// The elements of a body where its pose puts them, the segments that relations name, and unit vectors that were asked
/// for.
struct PlacedBody {
  std::vector<BodyPoint> points;
  std::vector<BodyLine> lines;
  std::vector<BodyPlane> planes;
  std::vector<BodySegment> segments;
  std::vector<VectorForm> directions{};
};

/// Unknowns by components.
struct NamedVector {
  std::string name;
  VectorForm forms;
};

using ComplexValues = std::vector<std::complex<double>>;

/// Which value of the problem stands on the right-hand side of an equation: that of a distance constraint or, counted on,
/// of a relation.
inline constexpr int no_value = -1;
/// Of an equation that closes a loop of joints, or says that a normal is another one or its opposite: no constraint gives
/// its right-hand side, and homotopies may take any other.
inline constexpr int gap_value = -2;

/// Who owns the equations by which a body joins those before it.
constexpr int owner_of_joints(int body) { return -2 - body; }
constexpr int body_of_joints(int owner) { return -2 - owner; }

/// The generators before it are reflections and half-turns that the frame leaves; from it on they turn elements over.
inline constexpr SignMask first_turning = 8;

class SystemBuilder {
 public:
  /// Without elements (see place_elements). Preconditions: !why_no_frame(scene); the scene outlives this.
  explicit SystemBuilder(const Scene& scene);
  // Compiled once.
  SystemBuilder(const SystemBuilder&);
  SystemBuilder(SystemBuilder&&) noexcept;
  ~SystemBuilder();

  const Scene& scene() const { return scene_; }
  const ProblemStatement& problem() const { return scene_.problem(); }
  int dimension() const { return scene_.dimension(); }

  // Unknowns. `turning`: of all components.
  LinearForm unknown(SignMask mask);
  VectorForm vector(SignMask turning = 0);
  /// Of what has another sign in a mirror image, such as a vector product.
  VectorForm pseudo_vector();
  /// A generator of its own, for what may be turned over.
  SignMask new_turning();

  // Equations.
  void add(QuadraticEquation equation, int value = no_value);
  /// Equations that are added from now on are those of a constraint: numbered as values are.
  void begin(int owner) { owner_ = owner; }
  /// What a description calls unknowns that are no element's.
  void name(NamedVector vector) { named_.push_back(std::move(vector)); }
  /// How the unknowns that were added since the last call follow from a placement and from earlier unknowns: their values,
  /// one each.
  void define(std::function<ComplexValues(const Placement&, const ComplexValues&)> values);

  // Elements, by their numbers among points, lines or planes.
  void put_point(int point, VectorForm at) { points_[static_cast<std::size_t>(point)] = std::move(at); }
  void put_arm(const BodyPoint& point) { arms_.emplace(point.point, point); }
  void put_line(int line, LineForms at) { lines_[static_cast<std::size_t>(line)] = std::move(at); }
  void put_plane(int plane, PlaneForms at) { planes_[static_cast<std::size_t>(plane)] = std::move(at); }
  void put_segment(const BodySegment& segment) {
    segments_.emplace(std::pair(segment.from, segment.to), segment.at);
  }
  const SceneFrame& frame() const { return frame_; }
  /// The generator that turns over a plane, with others perhaps; 0: it has a side.
  SignMask turning_of_plane(int plane);

  // Elements, by the numbers of the problem.
  const VectorForm& point(int entity) const { return points_[static_cast<std::size_t>(entity)]; }
  /// The same with the body that moves it; null where none does.
  const BodyPoint* arm(int entity) const {
    const auto found = arms_.find(entity);
    return found == arms_.end() ? nullptr : &found->second;
  }
  const LineForms& line(int entity) const {
    return lines_[static_cast<std::size_t>(problem().line_of(entity))];
  }
  const PlaneForms& plane(int entity) const {
    return planes_[static_cast<std::size_t>(problem().plane_of(entity))];
  }
  /// Unknowns for a segment that is in no body are added when it is first asked for.
  SegmentForms segment(const Operand& segment);
  /// Whether the length of a segment, and thus a distance constraint, is one of its equations.
  bool is_stated_by_segment(int constraint) const;

  // Lengths of the problem in the scene's unit, and squares of lengths. Precondition: decimals that are not 0 do not round
  // to it.
  ExactNumber length(const Decimal& given) const;
  ExactNumber square(const Decimal& given, bool is_squared) const;

  // What was written.
  const QuadraticSystem& system() const { return system_; }
  const std::vector<int>& value_of() const { return value_of_; }
  const std::vector<int>& owner_of() const { return owner_of_; }
  const std::vector<NamedVector>& named() const { return named_; }
  ComplexValues values(const Placement& placement) const;
  Placement placement(const ComplexValues& x) const;
  std::vector<bool> turned_planes() const;

 private:
  /// Whether the frame puts the normal of a plane of that set along its first axis, and so turns the set over with it.
  bool is_along_first_axis(int set) const;

  const Scene& scene_;
  SceneFrame frame_;
  Turnings turnings_;
  SignMask next_turning_;
  std::map<int, SignMask> turning_of_set_;       // of planes
  std::map<int, SignMask> turning_of_segments_;  // of segments
  QuadraticSystem system_;
  std::vector<int> value_of_;
  std::vector<int> owner_of_;
  int owner_ = no_value;
  std::vector<std::function<ComplexValues(const Placement&, const ComplexValues&)>> definitions_;
  std::vector<NamedVector> named_;
  std::vector<VectorForm> points_;
  std::map<int, BodyPoint> arms_;
  std::vector<LineForms> lines_;
  std::vector<PlaneForms> planes_;
  std::map<std::pair<int, int>, SegmentForms> segments_;
};

/// The forms at x.
Eigen::Vector3cd vector_at(const VectorForm& forms, const ComplexValues& x);
/// The components of a vector that a scene of that dimension has.
ComplexValues components(const Eigen::Vector3cd& vector, int dimension);
/// v/√(v·v).
Eigen::Vector3cd unit_vector(const Eigen::Vector3cd& v);

}  // namespace gcs
