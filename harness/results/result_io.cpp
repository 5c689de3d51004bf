#include "harness/results/result_io.hpp"

#include <optional>
#include <utility>

#include "harness/base/document_text.hpp"
#include "harness/base/record_fields.hpp"
#include "harness/base/record_json.hpp"
#include "harness/results/decimal_json.hpp"
#include "harness/results/file_formats.hpp"
#include "harness/results/result_counts.hpp"
#include "harness/solving/frame_view.hpp"
#include "solvers/elements/general_structure.hpp"
#include "solvers/reading/cbor_document.hpp"
#include "solvers/reading/figure_json.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

namespace {

/// Null of a complex solution.
void write_signs(const ProblemStatement& problem, const AssessedSolution& solution,
                 const RecordWriter& write) {
  std::vector<std::string> ids;
  for (const int number : solution.signs.relations)
    ids.push_back(problem.relations[static_cast<std::size_t>(number)].id);
  const auto of_real = [&](auto value) { return solution.is_real() ? std::optional(value) : std::nullopt; };
  write.named("standing", of_real(solution.signs.standing), all_standings);
  write("against", of_real(ids));
}

JsonValue solution_value(const ProblemStatement& problem, const AssessedSolution& solution) {
  const Figure placement = solution.placement();
  JsonMembers members{{"points", json_points(problem, placement)}, {"lines", json_lines(problem, placement)}};
  if (!problem.planes.empty()) members.emplace_back("planes", json_planes(problem, placement));
  const RecordWriter write(members);
  write("real", solution.is_real());
  write("multiplicity", solution.multiplicity);
  write("residual", solution.residual);
  write("condition", solution.condition);
  write("error_bound", solution.error());
  write("certified", solution.certified);
  if (solution.decimals)
    members.emplace_back("decimals",
                         json_object(decimal_members(problem, *solution.decimals, solution.is_real())));
  if (!stated_signs(problem).empty()) write_signs(problem, solution, write);
  return json_object(std::move(members));
}

JsonValue list_of_crossings(const std::vector<AssessedCrossing>& crossings) {
  return json_array_of(crossings, [](const AssessedCrossing& crossing) {
    return json_object({{"solution", json_or_null(crossing.solution, json_number)},
                        {"direction", json_number(crossing.direction)}});
  });
}

/// Null for a strategy that follows no path in the lengths.
JsonValue path_value(const SolveRun& run) {
  if (run.claim != Claim::on_path && run.claim != Claim::on_path_of_core) return json_null();
  return list_of_crossings(run.crossings);
}

/// A position of every point, in the order of the instance, for each figure.
JsonValue list_of_figures(const ProblemStatement& problem, const std::vector<Figure>& figures) {
  return json_array_of(figures, [&](const Figure& figure) {
    return json_array_of(figure.points.colwise(), [&](const Eigen::Vector3d& point) {
      return json_coordinates(point, problem.dimension);
    });
  });
}

JsonValue edge_value(const ProblemStatement& problem, const AssessedCurve& curve) {
  JsonMembers members{{"constraint", json_text(id_of_value(problem, curve.released))},
                      {"end", json_text(std::string(word(curve.end)))},
                      {"cause", json_text(curve.cause)},
                      {"proven", json_boolean(curve.proven)},
                      {"crossings", list_of_crossings(curve.crossings)}};
  if (!curve.figures.empty()) {
    members.emplace_back("figures", list_of_figures(problem, curve.figures));
    members.emplace_back("places", json_array_of(curve.places, json_count));
  }
  return json_object(std::move(members));
}

/// In lowest terms; null where it is not determined.
JsonValue exponent_value(const PathEnds& ends) {
  return json_or_null(exponent(ends), [](const Exponent& e) {
    return json_array({json_number(e.numerator), json_number(e.denominator)});
  });
}

JsonValue ends_value(const PathEnds& ends) {
  return json_object(
      {{"end", json_text(std::string(word(ends.end)))},
       {"cause", json_text(ends.cause)},
       {"winding_number", ends.winding_number > 0 ? json_number(ends.winding_number) : json_null()},
       {"exponent", exponent_value(ends)},
       {"proven", json_boolean(ends.proven)},
       {"paths", json_count(ends.paths)}});
}

JsonValue options_value(const OptionMap& options) {
  JsonMembers members;
  for (const auto& [name, value] : options) members.emplace_back(name, json_text(value));
  return json_object(std::move(members));
}

JsonValue failed_check_value(const FailedCheck& check) {
  return json_object({{"name", json_text(check.name)}, {"what", json_text(check.what)}});
}

/// Null where no real figure is known.
JsonValue curve_value(const ProblemStatement& problem, const FigureCurve& curve) {
  if (curve.figures.empty()) return json_null();
  return json_object({{"end", json_text(std::string(word(curve.end)))},
                      {"residual", json_of(curve.residual)},
                      {"figures", list_of_figures(problem, curve.figures)}});
}

JsonValue motion_value(const ProblemStatement& problem, const Motion& motion) {
  const auto pairs = [&](const std::vector<std::array<int, 2>>& list, auto name) {
    return json_array_of(list, [&](const std::array<int, 2>& pair) {
      return json_texts({name(pair[0]), name(pair[1])});
    });
  };
  const auto id = [&](int number) { return problem.constraints[static_cast<std::size_t>(number)].id; };
  return json_object(
      {{"coincident", pairs(motion.coincident, [&](int point) { return problem.name(point); })},
       {"parallel", pairs(motion.parallel, id)},
       {"dimension", json_number(motion.dimension)},
       {"exact", json_boolean(motion.is_exact)},
       {"proven", json_boolean(motion.is_proven)},
       {"real", json_boolean(motion.figure.is_real())},
       {"points", json_points(problem, motion.figure)},
       {"curve", curve_value(problem, motion.curve)}});
}

JsonValue timing_value(const Timing& timing) {
  return json_object({{"wall_s", json_number(timing.wall_s)},
                      {"cpu_s", json_number(timing.cpu_s)},
                      {"prepare_s", json_number(timing.prepare_s)},
                      {"certify_s", json_or_null(timing.certify_s, json_number)},
                      {"recalled_steps", json_count(static_cast<std::uint64_t>(timing.recalled_steps))}});
}

JsonValue claim_value(const std::optional<Claim>& claim) {
  return json_or_null(claim, [](Claim c) { return json_text(std::string(word(c))); });
}

JsonValue totals_value(const SolutionTotals& totals) {
  JsonMembers members;
  visit_totals(totals, RecordWriter(members));
  return json_object(std::move(members));
}

JsonValue counts_value(const ProblemStatement& problem, const Counts& counts) {
  JsonMembers members;
  const ResultCounts stated = stated_counts(problem, counts);
  visit_result_counts(stated, RecordWriter(members));
  return json_object(std::move(members));
}

JsonValue statistics_value(const SolveRun& run) {
  JsonMembers members;
  visit_work(run.work, RecordWriter(members));
  visit_particulars(run.particulars, RecordWriter(members));
  return json_object(std::move(members));
}

JsonValue environment_value(const Environment& environment) {
  JsonMembers members;
  visit_environment(environment, RecordWriter(members));
  return json_object(std::move(members));
}

}  // namespace

JsonValue proofs_value(const std::optional<Proofs>& proofs) {
  return json_or_null(proofs, [](const Proofs& p) {
    const auto text = [](const std::string& reason) { return json_text(reason); };
    const auto count = [](const Natural& number) { return json_count(number); };
    if (p.why_none) return json_object({{"why_none", json_or_null(p.why_none, text)}});
    return json_object({{"why_none", json_null()},
                        {"classes", json_count(p.classes)},
                        {"real", json_count(p.real)},
                        {"clusters", json_count(p.clusters)},
                        {"in_clusters", json_count(p.in_clusters)},
                        {"multiple", json_count(p.multiple)},
                        {"at_infinity", json_count(p.at_infinity)},
                        {"most_bits", json_number(p.most_bits)},
                        {"generic", json_or_null(p.generic, count)},
                        {"limit", json_or_null(p.limit, count)},
                        {"limit_is_exact", json_boolean(p.limit_is_exact)},
                        {"figure_limit", json_or_null(p.figure_limit, count)},
                        {"with_image", p.figure_limit ? json_count(p.with_image) : json_null()},
                        {"complete", json_boolean(p.are_complete())},
                        {"generic_complete", json_boolean(p.generic && p.meets_limit(*p.generic))}});
  });
}

JsonValue graph_value(const ProblemStatement& problem, const std::vector<AssessedCurve>& curves) {
  if (curves.empty()) return json_null();
  return json_array_of(curves, [&](const AssessedCurve& curve) { return edge_value(problem, curve); });
}

JsonValue motions_value(const ProblemStatement& problem, const std::vector<Motion>& motions) {
  return json_array_of(motions, [&](const Motion& motion) { return motion_value(problem, motion); });
}

void write_result(const Instance& instance, const SolveRun& run, const Environment& environment,
                  const TextSink& take, const DocumentForm& form) {
  DocumentWriter document(result_format, take, run.threads, form);
  document.member("instance", instance.document);
  document.member("strategy", json_text(run.strategy));
  document.member("options", options_value(run.options));
  document.member("seed", json_count(run.seed));
  document.member("status", json_text(std::string(word(run.status))));
  document.member("reason", json_text(run.reason));
  document.member("claim", claim_value(run.claim));
  document.member("frame", frame_value(instance));
  document.member("counts", counts_value(instance.problem, run.counts));
  document.member("totals", json_or_null(run.totals, totals_value));
  document.member("proofs", proofs_value(run.proofs));
  document.member("failed_checks", json_array_of(run.failed_checks, failed_check_value));
  document.list("solutions", run.solutions,
                [&](const AssessedSolution& s) { return solution_value(instance.problem, s); });
  document.list("escaping", run.escaping, [&](const Figure& figure) {
    return json_object({{"points", json_points(instance.problem, figure)}});
  });
  document.member("path", path_value(run));
  document.member("graph", graph_value(instance.problem, run.curves));
  document.member("ends", json_array_of(run.ends, ends_value));
  document.member("motions", motions_value(instance.problem, run.motions));
  document.member("statistics", statistics_value(run));
  document.member("timing", timing_value(run.timing));
  document.member("environment", environment_value(environment));
  document.end();
}

namespace {

/// Writes a result as it is read.
class ResultRewriter {
 public:
  ResultRewriter(const std::string& file, TextSink take, const DocumentForm& form)
      : file_(file), take_(std::move(take)), form_(form) {}

  /// `known`: the result as far as it is read.
  bool add_solution(const JsonValue& known, const JsonValue& solution, std::size_t number) {
    if (number == 0 && known.find("format") != nullptr) {
      add_members(known);
      document_->begin_list(solutions);
    }
    if (document_) document_->element(solution);
    return document_.has_value();
  }

  void finish(const JsonValue& result) {
    if (document_) {
      document_->end_list();
      ++members_;
    }
    add_members(result);
    document_->end();
  }

  static constexpr std::string_view solutions = "solutions";

 private:
  /// Those that are not written.
  void add_members(const JsonValue& known) {
    if (!document_) {
      JsonCursor(known, file_).require_format(result_format);
      document_.emplace(result_format, take_, 1, form_);
    }
    for (; members_ < known.members.size(); ++members_) {
      const auto& [name, value] = known.members[members_];
      if (name != "format") add_member(name, value);
    }
  }

  void add_member(const std::string& name, const JsonValue& value) {
    if ((name == solutions || name == "escaping") && value.kind == JsonValue::Kind::array)
      document_->list(name, value.elements,
                      [](const JsonValue& element) -> const JsonValue& { return element; });
    else
      document_->member(name, value);
  }

  const std::string& file_;
  TextSink take_;
  const DocumentForm& form_;
  std::optional<DocumentWriter> document_;
  std::size_t members_ = 0;  ///< that are written
};

}  // namespace

void rewrite_result(std::string_view text, const std::string& file, const TextSink& take,
                    const DocumentForm& form) {
  ResultRewriter rewriter(file, take, form);
  const auto add = [&](const JsonValue& known, const JsonValue& solution, std::size_t number) {
    return rewriter.add_solution(known, solution, number);
  };
  rewriter.finish(parse_document(text, file, {ResultRewriter::solutions, add}));
}

std::string result_text(const Instance& instance, const SolveRun& run, const Environment& environment) {
  std::string text;
  write_result(instance, run, environment, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace gcs
