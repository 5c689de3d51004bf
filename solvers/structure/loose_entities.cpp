#include "solvers/structure/loose_entities.hpp"

#include <algorithm>
#include <optional>

namespace gcs {
namespace {

/// One flag per entity.
using Body = std::vector<bool>;

/// A velocity that changes no given distance and, with near certainty, every distance that some motion can
/// change.
ResidueVector random_motion(const RigidityMatrix& matrix, std::mt19937_64& engine) {
  ResidueVector velocity(matrix.columns);
  for (const ResidueVector& motion : null_space(matrix.rows, matrix.columns)) {
    const Residue factor = Residue::random(engine);
    for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += factor * motion[i];
  }
  return velocity;
}

/// Finds the sets of entities that one random motion moves rigidly.
class BodySearch {
 public:
  BodySearch(const RigidityMatrix& matrix, const ResidueVector& velocity)
      : equations_(rigid_motion_equations(matrix, velocity)), largest_(equations_.size()) {}

  /// The body of the given entities when they fix its motion.
  std::optional<Body> body_of(const std::vector<int>& seed) const {
    const Fit fit = fit_motion(seed);
    return fit.kind == Fit::Kind::unique ? std::optional(moved_by(fit.motion)) : std::nullopt;
  }

  /// The largest body. Two bodies share at most d − 1 points (or one line), so two or three entities tell a
  /// body.
  Body largest() {
    const int entities = static_cast<int>(equations_.size());
    if (entities > 0) keep_larger(body_of_only({0}));
    for (int i = 0; i < entities; ++i) {
      for (int j = i + 1; j < entities; ++j) {
        if (2 * largest_size_ > entities + 2) return largest_;  // no other body can be larger
        search_from_pair(i, j);
      }
    }
    return largest_;
  }

 private:
  struct Fit {
    enum class Kind { none, unique, many };
    Kind kind = Kind::none;
    ResidueVector motion;
  };

  /// The rigid motions that move the seed's entities as the velocity does.
  Fit fit_motion(const std::vector<int>& seed) const {
    ResidueMatrix stacked;
    for (const int entity : seed) {
      stacked.insert(stacked.end(), equations_[entity].begin(), equations_[entity].end());
    }
    const int columns = static_cast<int>(equations_.front().front().size());
    ResidueMatrix solutions = null_space(std::move(stacked), columns);
    const bool solvable = std::any_of(solutions.begin(), solutions.end(), [](const ResidueVector& solution) {
      return !solution.back().is_zero();
    });
    if (!solvable) return {};
    if (solutions.size() > 1) return {Fit::Kind::many, {}};
    return {Fit::Kind::unique, std::move(solutions.front())};
  }

  Body moved_by(const ResidueVector& motion) const {
    Body body;
    for (const ResidueMatrix& equations : equations_) {
      body.push_back(std::all_of(equations.begin(), equations.end(), [&](const ResidueVector& equation) {
        return dot(equation, motion).is_zero();
      }));
    }
    return body;
  }

  Body body_of_only(const std::vector<int>& entities) const {
    Body body(equations_.size());
    for (const int entity : entities) body[entity] = true;
    return body;
  }

  void keep_larger(const Body& body) {
    const auto size = std::count(body.begin(), body.end(), true);
    if (size <= largest_size_) return;
    largest_ = body;
    largest_size_ = static_cast<int>(size);
  }

  void add(const Body& body) {
    found_.push_back(body);
    keep_larger(body);
  }

  bool is_in_found_body(int i, int j, int k) const {
    return std::any_of(found_.begin(), found_.end(),
                       [&](const Body& body) { return body[i] && body[j] && body[k]; });
  }

  void search_from_pair(int i, int j) {
    const Fit fit = fit_motion({i, j});
    if (fit.kind == Fit::Kind::none) return;
    if (fit.kind == Fit::Kind::unique) {
      if (!is_in_found_body(i, j, j)) add(moved_by(fit.motion));
      return;
    }
    keep_larger(body_of_only({i, j}));
    for (int k = j + 1; k < static_cast<int>(equations_.size()); ++k) {
      if (is_in_found_body(i, j, k)) continue;
      if (const auto body = body_of({i, j, k})) add(*body);
    }
  }

  std::vector<ResidueMatrix> equations_;
  std::vector<Body> found_;
  Body largest_;
  int largest_size_ = 0;
};

}  // namespace

std::vector<int> loose_entities(const RigidityMatrix& matrix, std::mt19937_64& engine) {
  BodySearch search(matrix, random_motion(matrix, engine));
  const int entities = static_cast<int>(matrix.placement.size());
  std::vector<int> fixed;
  for (int entity = 0; entity < entities; ++entity) {
    if (matrix.first_column[entity] < 0) fixed.push_back(entity);
  }
  std::optional<Body> body;
  if (!fixed.empty()) body = search.body_of(fixed);
  if (!body) body = search.largest();
  std::vector<int> loose;
  for (int entity = 0; entity < entities; ++entity) {
    if (!(*body)[entity]) loose.push_back(entity);
  }
  return loose;
}

}  // namespace gcs
