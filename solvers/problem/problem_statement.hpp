#pragma once
/// A point distance problem as a file states it: entities, given distances, and hints for path strategies.
/// Nothing here tells a solver which problem it is looking at.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace gcs {

/// A number with its decimal text: the text is exact, `value` is the nearest double.
/// Without a text `value` is exact.
struct Decimal {
  double value = 0;
  std::string text;
};

/// A line by a point on it and a direction of length 1.
struct LinePosition {
  Eigen::Vector3d point{0, 0, 0};
  Eigen::Vector3d direction{1, 0, 0};
};

/// A plane with a side: normal·x = offset, the normal of length 1.
struct PlanePosition {
  Eigen::Vector3d normal{0, 0, 1};
  double offset = 0;
};

/// A placement of all entities ("figure" in [I]): column i of `points` is point i; in the plane z = 0.
struct Figure {
  Eigen::Matrix3Xd points;
  std::vector<LinePosition> lines;
  Eigen::Matrix3Xd imaginary;  ///< imaginary parts of the points of a complex placement; empty: it is real
  /// Those of its lines, one for each; empty as well: it is real.
  std::vector<LinePosition> imaginary_lines;
  std::vector<PlanePosition> planes;
  std::vector<PlanePosition> imaginary_planes;  ///< likewise

  /// Compiled once.
  Figure();
  Figure(const Figure&);
  Figure(Figure&&) noexcept;
  Figure& operator=(const Figure&);
  Figure& operator=(Figure&&) noexcept;
  ~Figure();
  Figure(Eigen::Matrix3Xd points, std::vector<LinePosition> lines, Eigen::Matrix3Xd imaginary = {},
         std::vector<LinePosition> imaginary_lines = {}, std::vector<PlanePosition> planes = {},
         std::vector<PlanePosition> imaginary_planes = {});

  bool is_real() const {
    return imaginary.cols() == 0 && imaginary_lines.empty() && imaginary_planes.empty();
  }
  /// In a unit of 2^−exponent of this one; exact unless it overflows or underflows.
  Figure scaled(int exponent) const;
};

/// |between[0] − between[1]| is given. Entities are numbered points first, then lines, then planes
/// (entity e is the line e − points.size() when e ≥ points.size()). At most one of the two is a line, none a plane.
struct DistanceConstraint {
  std::string id;
  std::array<int, 2> between{};
  Decimal given;  ///< the length, or its square, in the file's unit; > 0 (≥ 0 for a point–line length)
  bool is_squared = false;

  double length() const { return is_squared ? std::sqrt(given.value) : given.value; }  ///< in the file's unit
};

/// Where a frame is: its origin, and rows that are its axes.
struct FramePose {
  Eigen::Matrix3d axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Eigen::Vector3d origin{0, 0, 0};
};

/// Which entities fix the frame; −1: not used. Points: origin, axis and (in space) plane.
/// With a line: `line` is the x-axis and `height` is the point put on the z-axis.
/// In general scenes with fewer points `axis`, `plane` and `height` are entities of any kind: along the x-axis is the
/// direction or normal of `axis`, in the xy-plane that of `plane`, and where there is no point, the origin is where `axis`
/// is nearest to the line `plane`, or meets the plane, or where the planes `axis`, `plane` and `height` meet. With a point
/// as `plane` the origin is the point of the line `axis` next to it; the plane `axis` has the origin next to the point
/// `height`, or where it meets the line `plane`.
struct Reference {
  int origin = -1;
  int axis = -1;
  int plane = -1;
  int line = -1;
  int height = -1;
};

/// a(t) = (1 − t)·a_sketch + t·a_target + t(1 − t)·(c_0 + c_1 t + c_2 t² + …) for one constraint, which any
/// polynomial with these ends is.
struct BentLength {
  int constraint = -1;
  std::vector<double>
      coefficients;  ///< c_0, c_1, …, in the file's unit of length; any number, but most_coefficients

  static constexpr std::size_t most_coefficients = 16;
};

/// How lengths travel from the sketch (t = 0) to the targets (t = 1): linearly, except for constraint `bent`,
/// a(t) = −bend·t² + (a_target − a_sketch + bend)·t + a_sketch. −1: the last constraint.
struct InterpolationChoice {
  int bent = -1;
  double bend = 2;  ///< in the file's unit of length
  /// In place of the two: all constraints that are bent, each once; the others are linear.
  std::optional<std::vector<BentLength>> bends{};
};

/// One term of a given construction plan: `place` at the given distances from the points named.
/// A radius is a constraint (index ≥ 0) or a driving parameter (constraint −1), which is measured from a
/// fixed copy.
struct PlanStep {
  struct Radius {
    int from = -1;
    int constraint = -1;
    std::string driving;  ///< the driving parameter's name, empty for a constraint
  };
  int place = -1;
  std::vector<Radius> from;
};

/// What the exact numbers of an element of a body are: a point's coordinates (two in the plane), a line's point and
/// direction, a plane's normal and offset.
struct BodyElement {
  int entity = -1;
  std::vector<Decimal> numbers;
};

/// Elements that are moved as one, never mirrored: a solution has them as here but for a motion.
struct RigidBody {
  std::string name;
  std::vector<BodyElement> elements;
};

/// What a relation is between: an entity, or the segment from one point to another.
struct Operand {
  int entity = -1;  ///< of a segment its first point
  int end = -1;     ///< of a segment its second point; −1: an entity

  bool is_segment() const { return end >= 0; }
  bool operator==(const Operand&) const = default;
};

/// A constraint that is no distance between points, or of a point from a line.
struct Relation {
  /// How `given` says the value.
  enum class Form { none, length, squared, degrees, cosine };

  std::string id;
  std::string type;  ///< see elements/constraint_types.hpp
  std::vector<Operand> of;
  Form form = Form::none;
  Decimal given{};  ///< lengths in the file's unit; from a plane's side they have a sign
  int sign = 0;     ///< of an orientation; 0: it is none
};

struct ProblemStatement {
  int dimension = 3;  ///< 2 or 3
  std::vector<std::string> points;
  std::vector<std::string> lines;
  std::vector<DistanceConstraint> constraints;
  std::vector<std::optional<Eigen::Vector3d>> fixed_points;  ///< one per point
  std::vector<std::optional<LinePosition>> fixed_lines;      ///< one per line
  /// The decimal texts of given positions, which are exact; empty: the doubles are. By points; after them two for each
  /// line, its point and its direction, and two for each plane, its normal and, first of three, its offset.
  std::vector<std::array<std::string, 3>> fixed_texts;
  std::optional<Reference> reference;
  std::optional<Figure> sketch;
  InterpolationChoice interpolation;
  std::vector<PlanStep> construction;  ///< empty: derived
  std::vector<std::string> planes{};
  std::vector<RigidBody> bodies{};  ///< their elements are among the points, lines and planes
  std::vector<Relation> relations{};
  std::vector<std::optional<PlanePosition>> fixed_planes{};  ///< one per plane, or empty
  int reference_body = -1;  ///< the body that the frame is put in; −1: see Reference
  /// Where given positions leave motions: a frame, in the file, that has them at its origin or on its axis, and that
  /// `reference` or `reference_body` completes.
  std::optional<FramePose> file_frame;

  int entity_count() const { return static_cast<int>(points.size() + lines.size() + planes.size()); }
  bool is_point(int entity) const { return entity < static_cast<int>(points.size()); }
  bool is_plane(int entity) const { return entity >= static_cast<int>(points.size() + lines.size()); }
  bool is_line(int entity) const { return !is_point(entity) && !is_plane(entity); }
  int line_of(int entity) const { return entity - static_cast<int>(points.size()); }
  int plane_of(int entity) const { return entity - static_cast<int>(points.size() + lines.size()); }
  /// The way back: the entity that a line, or a plane, is.
  int line_entity(int line) const { return line + static_cast<int>(points.size()); }
  int plane_entity(int plane) const { return plane + static_cast<int>(points.size() + lines.size()); }
  const std::string& name(int entity) const {
    if (is_point(entity)) return points[entity];
    return is_line(entity) ? lines[line_of(entity)] : planes[plane_of(entity)];
  }
  /// Whether there is more than points, lines in space and distances between them, or a frame is to be completed.
  bool is_general() const {
    return !planes.empty() || !bodies.empty() || !relations.empty() || (dimension == 2 && !lines.empty()) ||
           file_frame;
  }
  /// True when the file gives the entity's position. A problem without any may leave both vectors empty.
  bool is_fixed(int entity) const;
  /// True when the file gives some entity's position.
  bool has_fixed() const;
  /// True when positions are given that leave no motion, so that no motion or reflection is divided out.
  bool is_anchored() const { return !file_frame && has_fixed(); }

  /// Compiled once.
  ProblemStatement();
  ProblemStatement(const ProblemStatement&);
  ProblemStatement(ProblemStatement&&) noexcept;
  ProblemStatement& operator=(const ProblemStatement&);
  ProblemStatement& operator=(ProblemStatement&&) noexcept;
  ~ProblemStatement();
};

enum class OperandKind { point, line, plane, segment };

OperandKind kind_of(const ProblemStatement& problem, const Operand& operand);

/// The bodies that have an entity among their elements, by their numbers.
std::vector<int> bodies_with(const ProblemStatement& problem, int entity);

/// The constraints that are bent, however `interpolation` says so.
std::vector<BentLength> bent_lengths(const ProblemStatement& problem);

/// Which figures are one solution.
enum class Convention { in_the_given_frame, up_to_motion, up_to_reflection };

/// The convention of a problem: in the given frame where there are positions; up to motion with an orientation or
/// with a body that is not flat; otherwise up to reflection.
Convention convention_of(const ProblemStatement& problem);

/// What the scene's frame leaves to be divided out: motions also of given positions that leave some; otherwise the
/// problem's convention.
Convention frame_convention(const ProblemStatement& problem);

/// The row of fixed_texts that an entity's texts begin in.
std::size_t fixed_text_row(const ProblemStatement& problem, int entity);

/// Whether a body has nothing but points whose last coordinate is 0: then it is its own mirror image.
bool is_flat(const RigidBody& body, int dimension);

/// How many mirror images of a solution a frame tells apart.
struct FrameImages {
  /// By reflections that the frame leaves: the one through the reference unless all points lie in it; with a
  /// line on the x-axis and a point on the positive z-axis x → −x and y → −y, unless that is all.
  int in_frame = 1;
  /// By signs of the reference coordinates to which the frame gives one.
  int by_signs = 1;
};

/// One of each where positions are given.
FrameImages frame_images(const ProblemStatement& problem);

/// All ways to change the signs of coordinates without leaving a solution's class: 2^dimension, and none but
/// the identity where positions are given.
int sign_patterns(bool is_anchored, int dimension);

}  // namespace gcs
