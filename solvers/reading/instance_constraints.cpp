#include "solvers/reading/instance_constraints.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/reading/instance_relations.hpp"
#include "solvers/reading/relation_words.hpp"

namespace gcs {
namespace {

/// What two constraints say that say the same, "the distance", "'on'".
std::string subject(const Relation& relation) {
  const bool has_value = value_kind(relation) != ConstraintType::Value::none;
  return has_value ? "give the " + relation.type : "say '" + relation.type + "'";
}

class ConstraintList {
 public:
  ConstraintList(InstanceFormat format, ProblemStatement& problem) : format_(format), problem_(problem) {}

  void read(const JsonCursor& list) {
    for (const JsonCursor& element : list.elements()) add(element);
    const ParallelClasses parallels(problem_);
    for (std::size_t i = 0; i < problem_.relations.size(); ++i)
      require_parallel(cursors_[i], problem_.relations[i], parallels);
  }

 private:
  void add(const JsonCursor& element) {
    Relation relation = read_relation(element, ids_.size() + 1, format_, problem_);
    if (!ids_.insert(relation.id).second) {
      element.fail("the constraint id '" + relation.id + "' is taken", "give every constraint its own id");
    }
    refuse_repeated(element, relation);
    if (is_plain_distance(relation)) {
      problem_.constraints.push_back({relation.id,
                                      {relation.of[0].entity, relation.of[1].entity},
                                      std::move(relation.given),
                                      relation.form == Relation::Form::squared});
    } else {
      problem_.relations.push_back(std::move(relation));
      cursors_.push_back(element);
    }
  }

  void refuse_repeated(const JsonCursor& element, const Relation& relation) {
    const auto [known, is_new] = known_.emplace(key(relation), relation.id);
    if (is_new) return;
    element.fail("over-constrained: '" + known->second + "' and '" + relation.id + "' both " +
                     subject(relation) + " of " + operand_names(problem_, relation.of),
                 "keep one of them");
  }

  bool is_plain_distance(const Relation& relation) const {
    if (relation.type != "distance") return false;
    const OperandKind a = kind_of(problem_, relation.of[0]), b = kind_of(problem_, relation.of[1]);
    const bool with_line = a == OperandKind::line || b == OperandKind::line;
    const bool with_point = a == OperandKind::point || b == OperandKind::point;
    return (a == OperandKind::point && b == OperandKind::point) ||
           (with_line && with_point && problem_.dimension == 3);
  }

  void require_parallel(const JsonCursor& element, const Relation& relation,
                        const ParallelClasses& parallels) const {
    if (!needs_parallel(problem_, relation) || parallels.joins(relation.of[0], relation.of[1])) return;
    element.required("between").fail("no 'parallel' joins " + operand_names(problem_, relation.of) +
                                         ", and only where parallel they have a distance",
                                     "add a constraint 'parallel' between the two");
  }

  using Key = std::pair<std::string, std::vector<std::pair<int, int>>>;

  static Key key(const Relation& relation) {
    Key result{relation.type, {}};
    for (const Operand& operand : relation.of) {
      const Operand way = undirected(operand);
      result.second.emplace_back(way.entity, way.end);
    }
    std::ranges::sort(result.second);
    return result;
  }

  InstanceFormat format_;
  ProblemStatement& problem_;
  std::set<std::string> ids_;
  std::map<Key, std::string> known_;
  std::vector<JsonCursor> cursors_;  ///< of the relations
};

}  // namespace

void read_constraints(const JsonCursor& list, InstanceFormat format, ProblemStatement& problem) {
  ConstraintList(format, problem).read(list);
}

}  // namespace gcs
