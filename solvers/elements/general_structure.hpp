#pragma once
/// What is loose in a general scene, and what redundant, before any solving.

#include <optional>
#include <string>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/structure/structure.hpp"

namespace gcs {

/// The rank of all equations at a random figure that meets those without a value; defects name the elements that can move
/// and the constraints that depend on each other there. Without defects as well where there is no system, or no such
/// figure is found. Numbers of relations are counted on after those of the distance constraints.
/// A rank that is reached is right; one that is missed is so but for the accidents of rounding: a pivot below 1e-9 of
/// the largest counts as 0, unless all equations together, as many as unknowns, are proven to be regular there in balls.
Structure analyse_general_structure(const Scene& scene);

/// The id of what gives a value, numbered as constraints and then relations.
const std::string& id_of_value(const ProblemStatement& problem, int value);

/// Why a general scene has no equations for homotopies and paths: no system, or one that is not square and regular at a
/// random figure. A sentence; nothing where it has.
std::optional<std::string> why_not_general(const Scene& scene);

/// The orientations, by their numbers among the relations, whose points lie on a line, or in a plane, in a figure at random
/// that meets the constraints without a value, and hence in all; none where there is no such figure.
std::vector<int> flat_orientations(const Scene& scene);

/// Throws InputError with the first defect, or the first flat orientation, as of a file of that name.
void require_general_well_posed(const ProblemStatement& problem, const std::string& file);

}  // namespace gcs
