#pragma once
/// Writes gcsbench-result/1.

#include <optional>
#include <string>

#include "harness/base/document_text.hpp"
#include "harness/base/environment.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {

/// What certificates prove, as in a result; null unless that was asked for.
JsonValue proofs_value(const std::optional<Proofs>& proofs);

/// The curves between solutions, as in a result; null for a strategy that walks along none.
JsonValue graph_value(const ProblemStatement& problem, const std::vector<AssessedCurve>& curves);

/// Solutions that are not isolated, as in a result.
JsonValue motions_value(const ProblemStatement& problem, const std::vector<Motion>& motions);

/// The result, piece by piece; as JSON it ends in a newline, and has one top-level member a line, one solution a line. What
/// does not apply is null; so is an infinite condition. The instance keeps the decimal text of its numbers.
void write_result(const Instance& instance, const SolveRun& run, const Environment& environment,
                  const TextSink& take, const DocumentForm& form = json_form);

/// The result in `text` in that form: what write_result writes of the same solve, solution by solution. `file` is for
/// messages. Throws InputError, perhaps after a part is written.
void rewrite_result(std::string_view text, const std::string& file, const TextSink& take,
                    const DocumentForm& form);
std::string result_text(const Instance& instance, const SolveRun& run, const Environment& environment);

}  // namespace gcs
