#pragma once
/// On a line, on a plane, along a direction or across it: what several types of constraints state.

#include "solvers/elements/system_builder.hpp"

namespace gcs {

void state_on_plane(SystemBuilder& builder, const VectorForm& point, const PlaneForms& plane);

/// end − start is λ·direction, with an unknown λ.
void state_along(SystemBuilder& builder, const Operand& segment, const VectorForm& direction,
                 SignMask turning);
/// (end − start)·direction = 0
void state_across(SystemBuilder& builder, const Operand& segment, const VectorForm& direction);

/// The points that a relation of points names.
std::vector<int> points_of(const Relation& relation);

}  // namespace gcs
