#include "solvers/structure/sub_problem.hpp"

#include <algorithm>

namespace gcs {
namespace {

/// Those of a list, one for each of the whole's points, lines or planes, that are of the part: the numbers of its
/// entities of that kind begin with `first`.
template <class T>
std::vector<T> kept(const std::vector<T>& all, const std::vector<int>& entities, int first) {
  std::vector<T> result;
  for (const int entity : entities)
    if (entity >= first && entity < first + static_cast<int>(all.size()))
      result.push_back(all[static_cast<std::size_t>(entity - first)]);
  return result;
}

/// Numbers in the whole problem put in the place of those in the part.
class Renumbering {
 public:
  Renumbering(const ProblemStatement& whole, const std::vector<bool>& is_there)
      : whole_(whole), number_(is_there.size(), -1) {
    for (int entity = 0; entity < static_cast<int>(is_there.size()); ++entity)
      if (is_there[static_cast<std::size_t>(entity)]) {
        number_[static_cast<std::size_t>(entity)] = static_cast<int>(entities_.size());
        entities_.push_back(entity);
      }
  }

  SubProblem part() {
    take_entities();
    take_constraints();
    for (const Relation& relation : whole_.relations) take(relation);
    for (int body = 0; body < static_cast<int>(whole_.bodies.size()); ++body) take_body(body);
    take_reference();
    if (whole_.sketch) take_sketch(*whole_.sketch);
    return {std::move(problem_), std::move(entities_)};
  }

 private:
  int number(int entity) const { return entity < 0 ? -1 : number_[static_cast<std::size_t>(entity)]; }

  void take_entities() {
    const int line = whole_.line_entity(0), plane = whole_.plane_entity(0);
    problem_.dimension = whole_.dimension;
    problem_.points = kept(whole_.points, entities_, 0);
    problem_.lines = kept(whole_.lines, entities_, line);
    problem_.planes = kept(whole_.planes, entities_, plane);
    if (whole_.file_frame) return;
    problem_.fixed_points = kept(whole_.fixed_points, entities_, 0);
    take_fixed_texts();
    problem_.fixed_lines = kept(whole_.fixed_lines, entities_, line);
    problem_.fixed_planes = kept(whole_.fixed_planes, entities_, plane);
  }

  void take_fixed_texts() {
    const std::vector<std::array<std::string, 3>>& all = whole_.fixed_texts;
    for (const int entity : entities_) {
      const std::size_t first = std::min(all.size(), fixed_text_row(whole_, entity)),
                        last = std::min(all.size(), fixed_text_row(whole_, entity + 1));
      problem_.fixed_texts.insert(problem_.fixed_texts.end(),
                                  all.begin() + static_cast<std::ptrdiff_t>(first),
                                  all.begin() + static_cast<std::ptrdiff_t>(last));
    }
  }

  void take_constraints() {
    problem_.interpolation.bend = whole_.interpolation.bend;
    if (whole_.interpolation.bends) problem_.interpolation.bends.emplace();
    for (int i = 0; i < static_cast<int>(whole_.constraints.size()); ++i) {
      DistanceConstraint constraint = whole_.constraints[static_cast<std::size_t>(i)];
      for (int& entity : constraint.between) entity = number(entity);
      if (std::ranges::min(constraint.between) < 0) continue;
      take_bend(i);
      problem_.constraints.push_back(std::move(constraint));
    }
  }

  /// Of the constraint that is taken next.
  void take_bend(int constraint) {
    const int next = static_cast<int>(problem_.constraints.size());
    if (constraint == whole_.interpolation.bent) problem_.interpolation.bent = next;
    if (!whole_.interpolation.bends) return;
    for (const BentLength& bent : *whole_.interpolation.bends)
      if (bent.constraint == constraint) problem_.interpolation.bends->push_back({next, bent.coefficients});
  }

  void take(Relation relation) {
    for (Operand& operand : relation.of) {
      const bool is_segment = operand.is_segment();
      operand = {number(operand.entity), number(operand.end)};
      if (operand.entity < 0 || operand.is_segment() != is_segment) return;
    }
    problem_.relations.push_back(std::move(relation));
  }

  void take_body(int body) {
    RigidBody taken = whole_.bodies[static_cast<std::size_t>(body)];
    for (BodyElement& element : taken.elements) {
      element.entity = number(element.entity);
      if (element.entity < 0) return;
    }
    if (body == whole_.reference_body) problem_.reference_body = static_cast<int>(problem_.bodies.size());
    problem_.bodies.push_back(std::move(taken));
  }

  void take_reference() {
    if (!whole_.reference) return;
    Reference reference = *whole_.reference;
    for (int* point : {&reference.origin, &reference.axis, &reference.plane, &reference.height}) {
      if (*point < 0) continue;
      *point = number(*point);
      if (*point < 0) return;
    }
    if (reference.line >= 0) {
      const int line = number(whole_.line_entity(reference.line));
      if (line < 0) return;
      reference.line = problem_.line_of(line);
    }
    problem_.reference = reference;
  }

  void take_sketch(const Figure& sketch) {
    Figure& figure = problem_.sketch.emplace();
    figure.points.resize(3, static_cast<Eigen::Index>(problem_.points.size()));
    for (Eigen::Index i = 0; i < figure.points.cols(); ++i)
      figure.points.col(i) = sketch.points.col(entities_[static_cast<std::size_t>(i)]);
    figure.lines = kept(sketch.lines, entities_, whole_.line_entity(0));
    figure.planes = kept(sketch.planes, entities_, whole_.plane_entity(0));
  }

  const ProblemStatement& whole_;
  std::vector<int> number_;  ///< of each entity of the whole; −1: not in the part
  std::vector<int> entities_;
  ProblemStatement problem_;
};

}  // namespace

SubProblem sub_problem(const ProblemStatement& whole, const std::vector<bool>& is_there) {
  return Renumbering(whole, is_there).part();
}

}  // namespace gcs
