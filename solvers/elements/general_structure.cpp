#include "solvers/elements/general_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "solvers/elements/dense_equations.hpp"
#include "solvers/elements/stated_signs.hpp"
#include "solvers/model/ball_krawczyk.hpp"
#include "solvers/numeric/dense_factors.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

constexpr double rank_tolerance = 1e-9;

/// The Jacobian's kernel, the motions, and that of its transpose, the dependences; columns.
struct Kernels {
  Eigen::Index rank = 0;
  Eigen::MatrixXcd motions, dependences;
};

Kernels kernels_of(Eigen::MatrixXcd jacobian) {
  jacobian.rowwise().normalize();
  using Factors = Eigen::ColPivHouseholderQR<Eigen::MatrixXcd>;
  const Factors of_rows(Eigen::MatrixXcd(jacobian.adjoint()));
  const auto pivots = of_rows.matrixQR().diagonal().cwiseAbs().eval();
  Kernels result;
  while (result.rank < pivots.size() && pivots[result.rank] > rank_tolerance * pivots[0]) ++result.rank;
  result.motions = orthogonal_factor(of_rows).rightCols(jacobian.cols() - result.rank);
  result.dependences = orthogonal_factor(Factors(jacobian)).rightCols(jacobian.rows() - result.rank);
  return result;
}

/// Whether the whole system is regular at the exact figure next to one that meets these conditions to rounding, by proof: as
/// many unknowns of that stay as they are as the conditions leave free. Not tried above 100, which takes half a second.
bool is_proven_regular(const QuadraticSystem& system, const std::vector<int>& conditions,
                       const std::vector<std::complex<double>>& near) {
  constexpr slong bits = 256;
  constexpr int most_unknowns = 100;
  if (system.unknowns > most_unknowns) return false;
  QuadraticSystem met{system.unknowns, {}, {}};
  for (const int number : conditions)
    met.equations.push_back(system.equations[static_cast<std::size_t>(number)]);
  const BallKrawczyk exact(held_at(std::move(met), near, 0), bits);
  const auto figure = exact.prove(exact.refined(BallKrawczyk::vector(near)).x);
  if (!figure) return false;
  BallMatrix inverse(system.unknowns, system.unknowns);
  return acb_mat_inv(inverse.get(), BallKrawczyk(system, bits).jacobian(figure->solution).get(), bits) != 0;
}

class GeneralDefect {
 public:
  GeneralDefect(const ProblemStatement& problem, const SceneSystem& system, const Kernels& kernels)
      : problem_(problem), freedoms_(kernels.motions.cols()), surplus_(kernels.dependences.cols()) {
    for (int entity = 0; freedoms_ > 0 && entity < problem.entity_count(); ++entity)
      if (system.moves(entity, kernels.motions)) loose_.push_back(entity);
    std::set<int> owners;
    for (Eigen::Index e = 0; surplus_ > 0 && e < kernels.dependences.rows(); ++e) {
      if (kernels.dependences.row(e).norm() <= rank_tolerance) continue;
      const auto i = static_cast<std::size_t>(e);
      const int owner = system.owner_of()[i];
      if (owner >= 0) owners.insert(owner);
      if (system.value_of()[i] == gap_value && owner < no_value) closing_.insert(body_of_joints(owner));
    }
    dependent_.assign(owners.begin(), owners.end());
  }

  StructureDefect defect() const {
    using Kind = StructureDefect::Kind;
    if (surplus_ == 0)
      return {Kind::under_constrained, loose_, {}, "under-constrained: " + freedom(), hold()};
    if (freedoms_ == 0)
      return {Kind::over_constrained,
              {},
              dependent_,
              "over-constrained: " + dependence(),
              "remove " + counted(static_cast<int>(surplus_), "equation") +
                  ", beginning with one of these constraints"};
    return {Kind::wrongly_constrained, loose_, dependent_,
            "wrongly constrained: " + freedom() + ", while " + dependence(),
            "replace one of these constraints by one that holds " + names(loose_)};
  }

 private:
  std::string names(const std::vector<int>& entities) const {
    std::vector<std::string> words;
    for (const int entity : entities) words.push_back(problem_.name(entity));
    return enumeration(words);
  }

  std::string freedom() const {
    return fmt::format("{} can move against the rest ({} of freedom left)", names(loose_),
                       counted(static_cast<int>(freedoms_), "degree"));
  }

  std::string hold() const {
    return fmt::format("add constraints of {} together that hold {}",
                       counted(static_cast<int>(freedoms_), "equation"), names(loose_));
  }

  std::string dependence() const {
    std::vector<std::string> ids;
    for (const int owner : dependent_) ids.push_back(id_of_value(problem_, owner));
    for (const int body : closing_)
      ids.push_back("the joints of body '" + problem_.bodies[static_cast<std::size_t>(body)].name + "'");
    return fmt::format(
        "at a random figure that meets the constraints without a value {} depend on each other",
        enumeration(ids));
  }

  const ProblemStatement& problem_;
  Eigen::Index freedoms_;
  Eigen::Index surplus_;
  std::vector<int> loose_;
  std::vector<int> dependent_;
  std::set<int> closing_;  ///< bodies whose joints depend on the rest
};

}  // namespace

Structure analyse_general_structure(const Scene& scene) {
  Structure structure;
  if (why_no_system(scene)) return structure;
  const SceneSystem system(scene);
  if (system.equations().unknowns == 0) return structure;
  const DenseEquations equations(system.equations());
  std::mt19937_64 random(1);
  std::vector<int> conditions = system.without_value();
  auto figure = random_zero(equations, conditions, random);
  if (!figure) {
    conditions = system.of_parts();
    figure = random_zero(equations, conditions, random);
  }
  structure.unknowns = system.equations().unknowns;
  structure.constraints = static_cast<int>(system.equations().equations.size());
  if (!figure) return structure;
  const Kernels kernels = kernels_of(equations.jacobian(*figure));
  structure.generic_rank = static_cast<int>(kernels.rank);
  if (kernels.motions.cols() == 0 && kernels.dependences.cols() == 0) return structure;
  if (structure.constraints == structure.unknowns &&
      is_proven_regular(system.equations(), conditions, *figure))
    structure.generic_rank = structure.unknowns;
  else
    structure.defects.push_back(GeneralDefect(scene.problem(), system, kernels).defect());
  return structure;
}

const std::string& id_of_value(const ProblemStatement& problem, int value) {
  const auto distances = static_cast<int>(problem.constraints.size());
  return value < distances ? problem.constraints[static_cast<std::size_t>(value)].id
                           : problem.relations[static_cast<std::size_t>(value - distances)].id;
}

std::optional<std::string> why_not_general(const Scene& scene) {
  if (auto reason = why_no_system(scene)) return reason;
  const Structure structure = analyse_general_structure(scene);
  if (structure.well_posed() && structure.generic_rank == structure.unknowns) return std::nullopt;
  return structure.well_posed() ? "no figure at random meets the constraints without a value"
                                : "the scene is " + structure.defects.front().what;
}

std::vector<int> flat_orientations(const Scene& scene) {
  const std::vector<StatedSign> signs = stated_signs(scene.problem());
  const bool is_any = std::ranges::any_of(signs, [](const StatedSign& one) { return one.is_determinant; });
  if (!is_any || why_no_system(scene)) return {};
  const SceneSystem system(scene);
  std::mt19937_64 random(1);
  const auto figure = random_zero(DenseEquations(system.equations()), system.without_value(), random);
  return figure ? flat_orientations(signs, system.elements().placement(*figure).points) : std::vector<int>();
}

void require_general_well_posed(const ProblemStatement& problem, const std::string& file) {
  const Scene scene = Scene::unchecked(problem);
  const Structure structure = analyse_general_structure(scene);
  if (!structure.well_posed()) {
    const StructureDefect& defect = structure.defects.front();
    throw InputError(file, "/constraints", defect.what, defect.remedy);
  }
  for (const int number : flat_orientations(scene)) {
    const Relation& flat = problem.relations[static_cast<std::size_t>(number)];
    std::vector<std::string> points;
    for (const Operand& of : flat.of) points.push_back(problem.name(of.entity));
    throw InputError(
        file, "/constraints",
        fmt::format("the points of orientation '{}', {}, lie {} whatever the values are: it has no sign",
                    flat.id, enumeration(points), problem.dimension == 2 ? "on a line" : "in a plane"),
        "leave it out or name other points");
  }
}

}  // namespace gcs
