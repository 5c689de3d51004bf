#include "solvers/construction/plan_blocks.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace gcs {
namespace {

using Unknowns = std::set<int>;

void add_unknowns(const LinearForm& form, Unknowns& unknowns) {
  for (const ScaledUnknown& term : form.terms) unknowns.insert(term.unknown);
}

void add_unknowns(const VectorForm& forms, Unknowns& unknowns) {
  for (const LinearForm& form : forms) add_unknowns(form, unknowns);
}

Unknowns unknowns_of_element(const SceneSystem& system, int element) {
  const SystemBuilder& elements = system.elements();
  Unknowns unknowns;
  if (elements.problem().is_point(element)) {
    add_unknowns(elements.point(element), unknowns);
  } else if (elements.problem().is_line(element)) {
    add_unknowns(elements.line(element).foot, unknowns);
    add_unknowns(elements.line(element).direction, unknowns);
  } else {
    add_unknowns(elements.plane(element).normal, unknowns);
    add_unknowns(elements.plane(element).offset, unknowns);
  }
  return unknowns;
}

Unknowns unknowns_of_equation(const QuadraticEquation& equation) {
  Unknowns unknowns;
  for (const FormProduct& product : equation.products) {
    add_unknowns(product.left, unknowns);
    add_unknowns(product.right, unknowns);
  }
  return unknowns;
}

/// Deals unknowns and equations out to the steps of a plan.
class Dealing {
 public:
  Dealing(const SceneSystem& system, const ElementPlan& plan)
      : is_known_(static_cast<std::size_t>(system.equations().unknowns)), is_of_element_(is_known_.size()) {
    for (const ElementStep& step : plan.steps) of_steps_.push_back(unknowns_of_element(system, step.place));
    for (const Unknowns& unknowns : of_steps_)
      for (const int unknown : unknowns) is_of_element_[static_cast<std::size_t>(unknown)] = true;
    for (const QuadraticEquation& equation : system.equations().equations)
      of_equations_.push_back(unknowns_of_equation(equation));
    is_dealt_.resize(of_equations_.size());
  }

  std::vector<PlanBlock> run() {
    std::vector<PlanBlock> blocks;
    for (std::size_t step = 0; step < of_steps_.size(); ++step) {
      blocks.emplace_back();
      take(of_steps_[step], blocks.back());
      const bool is_last = step + 1 == of_steps_.size();
      for (const auto& [equations, unknowns] : groups())
        if (equations.size() >= unknowns.size() || is_last) {
          take(unknowns, blocks.back());
          for (const int equation : equations) {
            blocks.back().equations.push_back(equation);
            is_dealt_[static_cast<std::size_t>(equation)] = true;
          }
        }
    }
    return blocks;
  }

 private:
  /// Equations whose elements are placed, and the unknowns of no element that they share.
  using Group = std::pair<std::vector<int>, Unknowns>;

  void take(const Unknowns& unknowns, PlanBlock& block) {
    for (const int unknown : unknowns) {
      if (is_known_[static_cast<std::size_t>(unknown)]) continue;
      is_known_[static_cast<std::size_t>(unknown)] = true;
      block.unknowns.push_back(unknown);
    }
  }

  std::vector<Group> groups() const {
    std::vector<Group> all;
    for (std::size_t e = 0; e < of_equations_.size(); ++e) {
      if (is_dealt_[e]) continue;
      Group group{{static_cast<int>(e)}, {}};
      bool waits = false;
      for (const int unknown : of_equations_[e]) {
        if (is_known_[static_cast<std::size_t>(unknown)]) continue;
        waits = waits || is_of_element_[static_cast<std::size_t>(unknown)];
        group.second.insert(unknown);
      }
      if (!waits) join(std::move(group), all);
    }
    return all;
  }

  static void join(Group group, std::vector<Group>& all) {
    const auto shares = [&](const Group& other) {
      return std::ranges::any_of(other.second, [&](int unknown) { return group.second.contains(unknown); });
    };
    const auto joined =
        std::stable_partition(all.begin(), all.end(), [&](const Group& g) { return !shares(g); });
    for (auto other = joined; other != all.end(); ++other) {
      group.first.insert(group.first.end(), other->first.begin(), other->first.end());
      group.second.insert(other->second.begin(), other->second.end());
    }
    all.erase(joined, all.end());
    std::ranges::sort(group.first);
    all.push_back(std::move(group));
  }

  std::vector<Unknowns> of_steps_, of_equations_;
  std::vector<bool> is_known_, is_of_element_, is_dealt_;
};

/// Of what a pivoted QR decomposition of columns has left of each.
int count_above(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& qr, double bound) {
  const Eigen::VectorXd left = qr.matrixQR().diagonal().cwiseAbs();
  return static_cast<int>((left.array() > bound).count());
}

/// Rows of length 1 as columns; a row of zeros stays one.
Eigen::MatrixXd unit_columns(const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd columns = rows.transpose();
  for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i).stableNormalize();
  return columns;
}

}  // namespace

std::vector<PlanBlock> plan_blocks(const SceneSystem& system, const ElementPlan& plan) {
  return Dealing(system, plan).run();
}

BlockPlan::BlockPlan(std::vector<PlanBlock> blocks) : blocks_(std::move(blocks)) {}

Eigen::MatrixXd BlockPlan::rows_of(std::size_t block, const std::vector<int>& equations,
                                   const Eigen::MatrixXd& jacobian) const {
  return jacobian(equations, blocks_[block].unknowns);
}

double BlockPlan::distance_from_tangency(std::size_t block, const Eigen::MatrixXd& jacobian) const {
  const Choice& choice = choices_[block];
  const auto size = static_cast<Eigen::Index>(blocks_[block].unknowns.size());
  if (size == 0) return 1;
  Eigen::MatrixXd columns(size, size);
  columns.leftCols(size - choice.directions.rows()) = unit_columns(rows_of(block, choice.used, jacobian));
  columns.rightCols(choice.directions.rows()) = choice.directions.transpose();
  return std::abs(columns.colPivHouseholderQr().matrixQR()(size - 1, size - 1));
}

double BlockPlan::distance_from_tangency(const Eigen::MatrixXd& jacobian) const {
  double smallest = 1;
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    smallest = std::min(smallest, distance_from_tangency(block, jacobian));
  return smallest;
}

bool BlockPlan::is_due(std::size_t block, const Eigen::MatrixXd& jacobian, double alpha) const {
  if (distance_from_tangency(block, jacobian) <= alpha / 2) return true;
  return choices_[block].directions.rows() > 0 &&
         choice(block, jacobian, 2 * alpha).used.size() > choices_[block].used.size();
}

bool BlockPlan::is_due(const Eigen::MatrixXd& jacobian, double alpha) const {
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    if (is_due(block, jacobian, alpha)) return true;
  return false;
}

BlockPlan::Choice BlockPlan::choice(std::size_t block, const Eigen::MatrixXd& jacobian, double alpha) const {
  const std::vector<int>& equations = blocks_[block].equations;
  const auto size = static_cast<Eigen::Index>(blocks_[block].unknowns.size());
  Choice result;
  result.directions.setIdentity(size, size);
  if (equations.empty() || size == 0) return result;
  const auto qr = unit_columns(rows_of(block, equations, jacobian)).colPivHouseholderQr();
  const int used = count_above(qr, alpha);
  for (int i = 0; i < used; ++i)
    result.used.push_back(equations[static_cast<std::size_t>(qr.colsPermutation().indices()[i])]);
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(size, size);
  result.directions = q.rightCols(size - used).transpose();
  return result;
}

void BlockPlan::choose(const Eigen::MatrixXd& jacobian, double alpha) {
  const bool is_first = choices_.empty();
  choices_.resize(blocks_.size());
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    if (is_first || is_due(block, jacobian, alpha)) choices_[block] = choice(block, jacobian, alpha);
  count();
}

void BlockPlan::count() {
  removed_.clear();
  driving_parameters_ = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const std::vector<int>& used = choices_[block].used;
    std::ranges::copy_if(blocks_[block].equations, std::back_inserter(removed_),
                         [&](int equation) { return std::ranges::find(used, equation) == used.end(); });
    driving_parameters_ += static_cast<int>(choices_[block].directions.rows());
  }
}

Eigen::VectorXd BlockPlan::driven(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result(driving_parameters_);
  Eigen::Index next = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const Eigen::MatrixXd& directions = choices_[block].directions;
    result.segment(next, directions.rows()) = directions * x(blocks_[block].unknowns);
    next += directions.rows();
  }
  return result;
}

void BlockPlan::linearise(const Eigen::MatrixXd& jacobian) {
  sign_ = 1;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    Choice& choice = choices_[block];
    const auto size = static_cast<Eigen::Index>(blocks_[block].unknowns.size());
    if (size == 0) continue;
    Eigen::MatrixXd matrix(size, size);
    matrix.topRows(size - choice.directions.rows()) = rows_of(block, choice.used, jacobian);
    matrix.bottomRows(choice.directions.rows()) = choice.directions;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
    choice.inverse = lu.inverse();
    if (lu.determinant() < 0) sign_ = -sign_;
  }
}

void BlockPlan::solve(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& right,
                      const Eigen::VectorXd& driven, Eigen::VectorXd& change) const {
  change.head(change.size() - 1).setZero();
  Eigen::Index next = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const Choice& choice = choices_[block];
    const auto used = static_cast<Eigen::Index>(choice.used.size()), open = choice.directions.rows();
    if (used + open == 0) continue;
    Eigen::VectorXd known(used + open);
    for (Eigen::Index i = 0; i < used; ++i) {
      const int equation = choice.used[static_cast<std::size_t>(i)];
      known[i] = right[equation] - jacobian.row(equation).dot(change);
    }
    known.tail(open) = driven.segment(next, open);
    next += open;
    change(blocks_[block].unknowns) = choice.inverse * known;
  }
}

}  // namespace gcs
