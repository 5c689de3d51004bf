#pragma once
/// The polynomial equations of a scene as text, for whoever compares another solver.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "solvers/model/scene.hpp"

namespace gcs {

enum class EquationsForm {
  text,    ///< an equation a line, with the numbers of the file
  phc,     ///< the input of PHCpack: their number and polynomials, with doubles
  reduced  ///< the same of reduced_system
};
inline constexpr std::array all_equations_forms{EquationsForm::text, EquationsForm::phc,
                                                EquationsForm::reduced};
std::string_view word(EquationsForm form);

/// Why a scene has no equations, in a sentence; nothing where it has.
std::optional<std::string> why_no_equations(const Scene& scene);

/// Lengths are in the scene's unit, which the text says. Names: see unknown_names; PHCpack's have _ in the place of what
/// it does not read, and v_ before those that begin as its numbers do. Its input ends with a line of JSON, the positions of
/// a solution as in a result, in the file's unit and frame, whose coordinates are texts: linear forms. Precondition: !why_no_equations(scene).
std::string equations_text(const Scene& scene, EquationsForm form);

}  // namespace gcs
