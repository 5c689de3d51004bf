#include "solvers/reading/instance_bodies.hpp"

#include <algorithm>
#include <map>

#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {
namespace {

/// How far positions that are given twice may disagree, of the size of the largest body.
constexpr double most_disagreement = 1e-9;

enum class ElementKind { point, line, plane };

ElementKind kind_of(const JsonCursor& position) {
  if (!position.is_object()) return ElementKind::point;
  return position.has("normal") || position.has("offset") ? ElementKind::plane : ElementKind::line;
}

const char* word(ElementKind kind) {
  if (kind == ElementKind::point) return "a point";
  return kind == ElementKind::line ? "a line" : "a plane";
}

std::vector<std::string>& names_of(ElementKind kind, ProblemStatement& problem) {
  if (kind == ElementKind::point) return problem.points;
  return kind == ElementKind::line ? problem.lines : problem.planes;
}

/// Collects the elements of bodies, body by body.
class ElementNames {
 public:
  ElementNames(std::set<std::string>& taken, ProblemStatement& problem)
      : free_(taken), taken_(taken), problem_(problem) {}

  void add(const std::string& body, const JsonCursor& cursor) {
    cursor.require_name(body);
    if (!taken_.insert(body).second) refuse_taken(body, cursor);
    for (const auto& [name, position] : cursor.members()) add_element(name, position);
  }

 private:
  void add_element(const std::string& name, const JsonCursor& position) {
    position.require_name(name);
    const ElementKind kind = kind_of(position);
    if (kind == ElementKind::plane && problem_.dimension == 2) refuse_planes_in_the_plane(position);
    const auto [known, is_new] = kinds_.emplace(name, kind);
    if (!is_new) {
      if (known->second != kind)
        position.fail(
            "'" + name + "' is " + word(kind) + " here and " + word(known->second) + " in another body",
            "an element that two bodies share is of one kind: give one of them another name");
      return;
    }
    if (free_.contains(name))
      position.fail("'" + name + "' is both free and in a body",
                    "leave it out of 'points', 'lines' and 'planes': the elements of bodies are known");
    if (!taken_.insert(name).second) refuse_taken(name, position);
    names_of(kind, problem_).push_back(name);
  }

  [[noreturn]] static void refuse_taken(const std::string& name, const JsonCursor& cursor) {
    cursor.fail("the name '" + name + "' is given twice", distinct_names);
  }

  const std::set<std::string> free_;
  std::set<std::string>& taken_;
  ProblemStatement& problem_;
  std::map<std::string, ElementKind> kinds_;
};

std::vector<Decimal> numbers(const JsonCursor& position, int dimension) {
  if (!position.is_object()) return position.decimals(dimension);
  if (kind_of(position) == ElementKind::plane) {
    position.plane_position();
    std::vector<Decimal> result = position.required("normal").decimals(dimension);
    result.push_back(position.required("offset").number());
    return result;
  }
  position.line_position(dimension);
  std::vector<Decimal> result = position.required("point").decimals(dimension);
  for (Decimal& component : position.required("direction").decimals(dimension))
    result.push_back(std::move(component));
  return result;
}

RigidBody read_body(const std::string& name, const JsonCursor& cursor, const ProblemStatement& problem) {
  RigidBody body{name, {}};
  for (const auto& [element, position] : cursor.members())
    body.elements.push_back(
        {entity_number(problem, element, position), numbers(position, problem.dimension)});
  return body;
}

/// Elements by their numbers, in positions relative to each other.
using Shape = std::map<int, ElementPosition>;

Shape shape_of(const ProblemStatement& problem, const RigidBody& body) {
  Shape shape;
  for (const BodyElement& element : body.elements)
    shape.emplace(element.entity, position_in_body(problem, element));
  return shape;
}

std::vector<ElementPosition> positions(const Shape& shape) {
  std::vector<ElementPosition> result;
  for (const auto& [entity, position] : shape) result.push_back(position);
  return result;
}

/// What a body needs that can still be moved in so many ways: a further point takes away three of them in space and two
/// in the plane, and those about an axis through it only with another one.
std::string missing_points(int motions, int dimension) {
  if (motions <= dimension - 1) return "give it one more point, beside what it has";
  if (dimension == 2) return "give it two points";
  return motions == 3 ? "give it two more points, which are not on one line with what it has"
                      : "give it three points that are not on one line";
}

void require_pose(const JsonCursor& body, const std::string& name, const Shape& shape, int dimension) {
  const int motions = motions_left(positions(shape), dimension);
  if (motions == 0) return;
  body.fail("the elements of the body '" + name + "' do not determine its pose: they leave it " +
                std::to_string(motions) + " of " + (dimension == 2 ? "3" : "6") + " motions",
            missing_points(motions, dimension));
}

/// The part of the shape that the other has, too.
Shape shared_part(const Shape& shape, const Shape& other) {
  Shape result;
  for (const auto& element : shape)
    if (other.contains(element.first)) result.insert(element);
  return result;
}

double size_of(const Shape& shape) {
  double size = 0;
  for (const auto& [entity, position] : shape) {
    const Measure apart = measures(shape.begin()->second, position).back();
    if (apart.is_distance) size = std::max(size, std::abs(apart.value));
  }
  return size;
}

/// A shape and what it is called in a message.
struct NamedShape {
  std::string where;
  Shape shape;
};

/// What is said of two entities here and there, where it is not the same.
class Agreement {
 public:
  Agreement(const ProblemStatement& problem, double size) : problem_(problem), size_(size) {}

  void require(const JsonCursor& cursor, const NamedShape& a, const NamedShape& b) const {
    const Shape in_a = shared_part(a.shape, b.shape);
    for (auto first = in_a.begin(); first != in_a.end(); ++first)
      for (auto second = std::next(first); second != in_a.end(); ++second)
        compare(cursor, a, b, first->first, second->first);
  }

 private:
  void compare(const JsonCursor& cursor, const NamedShape& a, const NamedShape& b, int x, int y) const {
    const std::vector<Measure> in_a = measures(a.shape.at(x), a.shape.at(y));
    const std::vector<Measure> in_b = measures(b.shape.at(x), b.shape.at(y));
    for (std::size_t i = 0; i < std::min(in_a.size(), in_b.size()); ++i) {
      const double tolerance = most_disagreement * (in_a[i].is_distance ? size_ : 1);
      if (!(std::abs(in_a[i].value - in_b[i].value) > tolerance)) continue;
      cursor.fail((in_a[i].is_distance ? "the distance of " : "the cosine of the angle of ") +
                      entity_names(problem_, {x, y}) + " is " + number_text(json_number(in_a[i].value)) +
                      " " + a.where + " and " + number_text(json_number(in_b[i].value)) + " " + b.where,
                  "give both the same positions relative to each other");
    }
  }

  const ProblemStatement& problem_;
  double size_;
};

void refuse_one_body(const JsonCursor& body, const NamedShape& a, const NamedShape& b,
                     const ProblemStatement& problem) {
  const Shape shared = shared_part(a.shape, b.shape);
  if (motions_left(positions(shared), problem.dimension) > 0) return;
  std::vector<int> entities;
  for (const auto& [entity, position] : shared) entities.push_back(entity);
  body.fail(entity_names(problem, entities) + ", which are " + a.where + " and " + b.where +
                ", fix the two to each other",
            "they are one body: give all their elements in one");
}

double largest_size(const std::vector<NamedShape>& shapes) {
  double size = 0;
  for (const NamedShape& shape : shapes) size = std::max(size, size_of(shape.shape));
  return size;
}

std::vector<NamedShape> all_shapes(const ProblemStatement& problem) {
  std::vector<NamedShape> shapes;
  for (const RigidBody& body : problem.bodies)
    shapes.push_back({"in the body '" + body.name + "'", shape_of(problem, body)});
  return shapes;
}

/// Of each body those before it that share an element with it.
std::vector<std::set<std::size_t>> earlier_neighbours(const std::vector<NamedShape>& shapes) {
  std::vector<std::set<std::size_t>> neighbours(shapes.size());
  std::map<int, std::vector<std::size_t>> users;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const auto& [entity, position] : shapes[i].shape) {
      neighbours[i].insert(users[entity].begin(), users[entity].end());
      users[entity].push_back(i);
    }
  }
  return neighbours;
}

}  // namespace

void append_body_elements(const JsonCursor& bodies, std::set<std::string>& taken, ProblemStatement& problem) {
  ElementNames names(taken, problem);
  for (const auto& [name, body] : bodies.members()) names.add(name, body);
}

void read_bodies(const JsonCursor& bodies, ProblemStatement& problem) {
  const auto members = bodies.members();
  for (const auto& [name, body] : members) problem.bodies.push_back(read_body(name, body, problem));
  const std::vector<NamedShape> shapes = all_shapes(problem);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    require_pose(members[i].second, members[i].first, shapes[i].shape, problem.dimension);
  const Agreement agreement(problem, largest_size(shapes));
  const auto neighbours = earlier_neighbours(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const std::size_t earlier : neighbours[i]) {
      refuse_one_body(members[i].second, shapes[earlier], shapes[i], problem);
      agreement.require(members[i].second, shapes[earlier], shapes[i]);
    }
  }
}

void check_fixed_bodies(const JsonCursor& fixed, const ProblemStatement& problem) {
  NamedShape given{"in 'fixed'", {}};
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    if (!problem.is_fixed(entity)) continue;
    if (problem.is_point(entity)) given.shape.emplace(entity, *problem.fixed_points[entity]);
    if (problem.is_line(entity)) given.shape.emplace(entity, *problem.fixed_lines[problem.line_of(entity)]);
    if (problem.is_plane(entity))
      given.shape.emplace(entity, *problem.fixed_planes[problem.plane_of(entity)]);
  }
  const std::vector<NamedShape> shapes = all_shapes(problem);
  const Agreement agreement(problem, largest_size(shapes));
  for (const NamedShape& shape : shapes) agreement.require(fixed, shape, given);
}

int common_body(const ProblemStatement& problem, const std::vector<int>& entities) {
  const auto has_all = [&](const RigidBody& body) {
    return std::all_of(entities.begin(), entities.end(), [&](int entity) {
      return std::any_of(body.elements.begin(), body.elements.end(),
                         [&](const BodyElement& element) { return element.entity == entity; });
    });
  };
  const auto found = std::find_if(problem.bodies.begin(), problem.bodies.end(), has_all);
  return found == problem.bodies.end() ? -1 : static_cast<int>(found - problem.bodies.begin());
}

}  // namespace gcs
