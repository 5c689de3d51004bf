#pragma once
/// Small scenes of gcsbench-instance/2 for the tests of reading.

#include <nlohmann/json.hpp>
#include <string>

#include "solvers/problem/problem_statement.hpp"

namespace gcs::samples {

/// Points p1 to p4, lines L and M and planes E and F in space, without any constraint.
nlohmann::json scene();

/// Points p1 to p4 and lines L and M in the plane.
nlohmann::json plane_scene();

/// Two triangles, a1 to a3 and b1 to b3, in space.
nlohmann::json bodies();

/// The document with one constraint more.
nlohmann::json and_also(nlohmann::json document, const std::string& constraint);

/// What the constraint, as the last one, is read as.
Relation relation_of(const nlohmann::json& document, const std::string& constraint);

/// The constraint, alone, is refused at that place in it.
void check_constraint_refused(const nlohmann::json& document, const std::string& constraint,
                              const std::string& pointer, const std::string& word);

/// A constraint between two operands, with the text of further members.
std::string between(const std::string& type, const std::string& a, const std::string& b,
                    const std::string& value = "");

}  // namespace gcs::samples
