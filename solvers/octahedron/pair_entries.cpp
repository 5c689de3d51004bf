#include "solvers/octahedron/pair_entries.hpp"

#include "solvers/model/given_numbers.hpp"
#include "solvers/structure/octahedral_pairs.hpp"

namespace gcs {
namespace {

int first_plane(const ProblemStatement& problem) { return problem.plane_entity(0); }

}  // namespace

std::optional<GivenPair> given_pair(const Scene& scene, const Relation& relation) {
  const auto between = pair_with_plane(scene.problem(), relation);
  if (!between) return std::nullopt;
  if (relation.type == "distance") return GivenPair{*between, given_length(scene, relation.given)};
  if (relation.type == "angle") return GivenPair{*between, given_cosine(relation, false)};
  return GivenPair{*between, {}};
}

PairEntries::PairEntries(const Scene& scene)
    : matrix_(Eigen::MatrixXd::Zero(scene.problem().entity_count(), scene.problem().entity_count())),
      first_plane_(first_plane(scene.problem())) {
  for (int e = 0; e < scene.constraint_count(); ++e) {
    const auto [p, q] = scene.problem().constraints[e].between;
    matrix_(p, q) = matrix_(q, p) = scene.target_lengths()[e] * scene.target_lengths()[e];
  }
  for (const Relation& relation : scene.problem().relations)
    if (const auto pair = given_pair(scene, relation)) {
      const auto [p, q] = pair->between;
      matrix_(p, q) = matrix_(q, p) = rounded_to_double(pair->entry).real();
    }
  for (int plane = first_plane_; plane < scene.problem().entity_count(); ++plane) matrix_(plane, plane) = 1;
}

ExactEntries::ExactEntries(const Scene& scene) : first_plane_(first_plane(scene.problem())) {
  for (int i = 0; i < scene.constraint_count(); ++i) {
    const auto [p, q] = scene.problem().constraints[static_cast<std::size_t>(i)].between;
    entries_[{p, q}] = entries_[{q, p}] = rational(given_square(scene, i));
  }
  for (const Relation& relation : scene.problem().relations)
    if (const auto pair = given_pair(scene, relation)) {
      const auto [p, q] = pair->between;
      entries_[{p, q}] = entries_[{q, p}] = rational(pair->entry);
    }
}

}  // namespace gcs
