/// The compiled part of the Python module gcsbench: instances as text, answers and figures as arrays. What a person calls is in
/// gcsbench/__init__.py.

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/record_json.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/python/answer_arrays.hpp"
#include "harness/python/followed_binding.hpp"
#include "harness/python/solved_instance.hpp"
#include "harness/python/watched_solve.hpp"
#include "harness/results/certificate_io.hpp"
#include "harness/results/result_counts.hpp"
#include "harness/results/result_io.hpp"
#include "harness/solving/counts_view.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/running/errors.hpp"

namespace py = pybind11;

namespace gcs {
namespace {

// ---- JSON as Python's objects

py::object python_of(const JsonValue& value);

/// A whole number above 2^53 is a text in JSON, and an int here.
py::object python_of_text(const std::string& text) {
  const bool is_count = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return is_count ? py::object(py::int_(py::str(text))) : py::object(py::str(text));
}

py::object python_of_number(const JsonValue& value) {
  const std::string text = number_text(value);
  const bool is_whole = text.find_first_of(".eE") == std::string::npos;
  return is_whole ? py::object(py::int_(py::str(text))) : py::object(py::float_(value.number));
}

py::list list_of(const JsonValue& array) {
  py::list result;
  for (const JsonValue& element : array.elements) result.append(python_of(element));
  return result;
}

py::dict dict_of(const JsonMembers& members) {
  py::dict result;
  for (const auto& [name, value] : members) result[py::str(name)] = python_of(value);
  return result;
}

py::object python_of(const JsonValue& value) {
  switch (value.kind) {
    case JsonValue::Kind::null:
      return py::none();
    case JsonValue::Kind::boolean:
      return py::bool_(value.boolean);
    case JsonValue::Kind::number:
      return python_of_number(value);
    case JsonValue::Kind::string:
      return python_of_text(value.text);
    case JsonValue::Kind::array:
      return list_of(value);
    case JsonValue::Kind::object:
      return dict_of(value.members);
  }
  return py::none();
}

// ---- what is known of an answer

py::dict counts_of(const SolvedInstance& solved) {
  JsonMembers members;
  const ResultCounts stated = stated_counts(solved.instance.problem, solved.answer.counts);
  visit_result_counts(stated, RecordWriter(members));
  return dict_of(members);
}

py::dict particulars_of(const SolvedInstance& solved) {
  JsonMembers members;
  visit_particulars(solved.answer.particulars, RecordWriter(members));
  return dict_of(members);
}

py::list failed_checks_of(const SolvedInstance& solved) {
  py::list result;
  for (const FailedCheck& check : solved.answer.failed_checks)
    result.append(py::make_tuple(check.name, check.what));
  return result;
}

/// The figures of their curves as arrays.
py::list motions_of(const SolvedInstance& solved) {
  const ProblemStatement& problem = solved.instance.problem;
  py::list result = python_of(motions_value(problem, solved.answer.motions));
  for (std::size_t i = 0; i < solved.answer.motions.size(); ++i) {
    const std::vector<Figure>& figures = solved.answer.motions[i].curve.figures;
    if (!figures.empty()) result[i]["curve"]["figures"] = point_array(problem, figures);
  }
  return result;
}

/// The figures along its curves as arrays.
py::object graph_of(const SolvedInstance& solved) {
  const ProblemStatement& problem = solved.instance.problem;
  const std::vector<AssessedCurve>& curves = solved.answer.curves;
  py::object result = python_of(graph_value(problem, curves));
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (!curves[i].figures.empty()) result[py::int_(i)]["figures"] = point_array(problem, curves[i].figures);
  return result;
}

std::optional<std::string> claim_of(const SolvedInstance& solved) {
  if (!solved.answer.claim) return std::nullopt;
  return std::string(word(*solved.answer.claim));
}

double error_of(const AssessedSolution& solution) {
  return solution.error().value_or(std::numeric_limits<double>::quiet_NaN());
}

SolvedInstance solve_instance(const Instance& instance, const std::string& strategy, const OptionMap& options,
                              std::uint64_t seed, int threads, bool certify,
                              std::optional<double> time_limit_s, const py::object& progress) {
  const SolveSettings settings{.seed = seed, .threads = threads, .certify = certify};
  return {instance, watched_solve(instance, strategy, options, settings, time_limit_s, progress)};
}

py::dict strategies() {
  py::dict result;
  for (const StrategyEntry& entry : all_strategies()) {
    py::dict options;
    for (const OptionSpec& option : entry.options)
      options[py::str(std::string(option.name))] =
          py::make_tuple(option.default_value, option.allowed, std::string(option.summary));
    result[py::str(std::string(entry.name))] =
        py::dict(py::arg("summary") = std::string(entry.summary), py::arg("options") = options);
  }
  return result;
}

void bind_instance(py::module_& module) {
  py::class_<Instance>(module, "Instance")
      .def(py::init(
               [](const std::string& text, const std::string& name) { return parse_instance(text, name); }),
           py::arg("text"), py::arg("name"))
      .def_static("load", &load_instance, py::arg("name"))
      .def_property_readonly("text", [](const Instance& i) { return to_text(i.document, -1); })
      .def("count", [](const Instance& i) {
        return python_of(counts_value(i.problem, theoretical_counts(i.problem)));
      });
}

using BoundAnswer = py::class_<SolvedInstance>;

void bind_texts(BoundAnswer& bound) {
  const auto of_problem = [](auto member) {
    return [member](const SolvedInstance& s) { return s.instance.problem.*member; };
  };
  const auto of_answer = [](auto member) {
    return [member](const SolvedInstance& s) { return s.answer.*member; };
  };
  bound
      .def_property_readonly("points", of_problem(&ProblemStatement::points),
                             "names, in the order of the arrays' second axis")
      .def_property_readonly("lines", of_problem(&ProblemStatement::lines), "names, likewise")
      .def_property_readonly("planes", of_problem(&ProblemStatement::planes), "names, likewise")
      .def_property_readonly("strategy", of_answer(&Answer::strategy))
      .def_property_readonly("options", of_answer(&Answer::options), "of the strategy, defaults included")
      .def_property_readonly("seed", of_answer(&Answer::seed))
      .def_property_readonly(
          "status", [](const SolvedInstance& s) { return std::string(word(s.answer.status)); },
          "'complete', 'partial', 'infinite', 'unsupported', 'gave up', 'interrupted' or 'timed out'")
      .def_property_readonly("reason", of_answer(&Answer::reason), "a sentence; empty when complete")
      .def_property_readonly("claim", &claim_of,
                             "what the strategy claims to have found: 'all complex', 'all real', 'all real "
                             "of this component', 'on path', 'some real'")
      .def_property_readonly(
          "counts", &counts_of,
          "numbers of solutions with their convention; None where the strategy does not determine one")
      .def_property_readonly(
          "proofs", [](const SolvedInstance& s) { return python_of(proofs_value(s.answer.proofs)); },
          "what certificates prove; None without certify=True")
      .def_property_readonly(
          "motions", &motions_of,
          "solutions that are not isolated, beside the others: which points coincide and which bars are "
          "parallel there; ['curve']['figures'], where a real one is known: m × n × d coordinates along a "
          "curve "
          "of them")
      .def_property_readonly(
          "graph", &graph_of,
          "of 'explore', the curves that it walked: of each the constraint that it lacks, "
          "its end, and its crossings with the solutions, which are counted from 0; with "
          "samples=…, 'figures': m × n × d coordinates along it. None elsewhere, and where "
          "the scene was solved in parts")
      .def_property_readonly("particulars", &particulars_of, "counts that only this strategy knows")
      .def_property_readonly("failed_checks", &failed_checks_of,
                             "(name, sentence) of what must hold in a correct answer and does not");
}

/// `make(problem, answer)`.
template <typename Make>
void bind_array(BoundAnswer& bound, const char* name, Make make, const char* help) {
  const auto get = [name, make](SolvedInstance& s) {
    const auto [place, is_new] = s.arrays.try_emplace(name);
    if (is_new) place->second = make(s.instance.problem, s.answer);
    return place->second;
  };
  bound.def_property_readonly(name, get, help);
}

/// `make(problem, figures)`.
template <typename Make>
void bind_positions(BoundAnswer& bound, const char* name, Make make, const char* help) {
  bind_array(
      bound, name,
      [make](const ProblemStatement& problem, const Answer& answer) {
        return make(problem, placements(answer));
      },
      help);
}

/// `make(solution)`.
template <typename Make>
void bind_numbers(BoundAnswer& bound, const char* name, Make make, const char* help) {
  using Number = std::invoke_result_t<Make, const AssessedSolution&>;
  bind_array(
      bound, name,
      [make](const ProblemStatement&, const Answer& answer) { return number_array<Number>(answer, make); },
      help);
}

void bind_arrays(BoundAnswer& bound) {
  bind_positions(
      bound, "solutions", &point_array,
      "coordinates of the points, k × n × d, real solutions first; complex where there are complex ones");
  bind_positions(
      bound, "solution_lines", &line_arrays,
      "{'point', 'direction'}: k × m × d each, the point nearest to the origin and a direction of length 1");
  bind_positions(bound, "solution_planes", &plane_arrays,
                 "{'normal': k × m × 3, 'offset': k × m}: normal·x = offset, normals of length 1");
  bind_numbers(
      bound, "is_real", [](const AssessedSolution& a) { return a.is_real(); }, "k booleans");
  bind_numbers(
      bound, "is_as_stated", [](const AssessedSolution& a) { return a.is_as_stated(); },
      "real, and orientations and senses of angles are as stated");
  bind_numbers(
      bound, "certified", [](const AssessedSolution& a) { return a.certified; },
      "proven to be near an exact solution");
  bind_numbers(bound, "error_bound", &error_of,
               "how far from the exact solution at most, proven; NaN where it is not");
  bind_numbers(
      bound, "multiplicity", [](const AssessedSolution& a) { return a.multiplicity; },
      "as the strategy says");
  bind_numbers(
      bound, "residual", [](const AssessedSolution& a) { return a.residual; },
      "the largest error of a constraint, relative");
  bind_numbers(
      bound, "condition", [](const AssessedSolution& a) { return a.condition; },
      "of the Jacobian; infinite at a singular solution");
}

std::string described(const SolvedInstance& s) {
  return fmt::format("<gcsbench.Answer of {}: {}{}{}; {} solutions>", s.answer.strategy,
                     word(s.answer.status), s.answer.reason.empty() ? "" : ": ", s.answer.reason,
                     s.answer.solutions.size());
}

/// k × d; KeyError where no point has the name.
py::object point_of(const py::object& solved, const std::string& name) {
  const std::vector<std::string>& points = solved.cast<const SolvedInstance&>().instance.problem.points;
  const auto found = std::ranges::find(points, name);
  if (found == points.end()) throw py::key_error("there is no point '" + name + "'");
  return solved.attr(
      "solutions")[py::make_tuple(py::slice(py::none(), py::none(), py::none()), found - points.begin())];
}

std::size_t write_certificate_of(const SolvedInstance& s, const std::string& file) {
  require_certifiable(s.instance);
  if (s.answer.counts.certified.value_or(0) == 0)
    throw UserError("nothing is proven of this answer; solve with certify=True");
  AtomicFile out(file);
  const py::gil_scoped_release unlocked;
  const std::size_t proven = write_certificate(s.instance, Scene(s.instance.problem), s.answer,
                                               [&](std::string_view piece) { out.write(piece); });
  out.commit();
  return proven;
}

void bind_answer(py::module_& module) {
  BoundAnswer bound(module, "Answer", "What a strategy found: k solutions.");
  bind_texts(bound);
  bind_arrays(bound);
  bound.def("__len__", [](const SolvedInstance& s) { return s.answer.solutions.size(); })
      .def("__repr__", &described)
      .def("point", &point_of, py::arg("name"), "Where the point is in each solution, k × d.")
      .def("write_certificate", &write_certificate_of, py::arg("file"),
           "Writes the proofs for scripts/check-certificate, and returns how many solutions it has. Of an "
           "answer by "
           "certify=True to points and distances between them.");
}

PYBIND11_MODULE(_core, module) {
  py::register_exception<UserError>(module, "Error", PyExc_ValueError).attr("__doc__") =
      "What is wrong with a problem, a strategy or an option, and what would be right.";
  bind_instance(module);
  bind_answer(module);
  bind_followed(module);
  module.def("solve", &solve_instance, py::arg("instance"), py::arg("strategy"), py::arg("options"),
             py::arg("seed"), py::arg("threads"), py::arg("certify"), py::arg("time_limit_s"),
             py::arg("progress"));
  module.def("strategies", &strategies);
}

}  // namespace
}  // namespace gcs
