#include "harness/tests/contract/report_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace gcs::contract {
namespace {

/// The fields of a report by name, each as its bytes. Structured bindings name every member of a record, so
/// that a member that is added does not compile until it takes part.
class Fields {
 public:
  explicit Fields(const SolveReport& report) {
    const auto& [status, reason, claim, candidates, paths, motions, curves, escaping, generic, generic_member,
                 at_infinity, totals, work, particulars] = report;
    add("status", status);
    add("reason", reason);
    add("claim", claim);
    add("candidates.size()", candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) add(fmt::format("candidates[{}]", i), candidates[i]);
    add("paths.size()", paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i) add(fmt::format("paths[{}]", i), paths[i]);
    add("motions.size()", motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i) add(fmt::format("motions[{}]", i), motions[i]);
    add("curves.size()", curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const auto& [released, path, curve_figures, places] = curves[i];
      const std::string name = fmt::format("curves[{}]", i);
      add(name + ".released", released);
      add(name, path);
      add(name + ".figures", curve_figures);
      for (const std::size_t place : places) add(name + ".place", place);
    }
    add("escaping", escaping);
    add("generic", generic);
    add("generic_member", generic_member);
    add("at_infinity", at_infinity);
    add("totals", totals);
    add("work", work);
    add("particulars.size()", particulars.size());
    for (const auto& [name, value] : particulars) add("particulars." + name, value);
  }

  const std::vector<std::pair<std::string, std::string>>& list() const { return fields_; }

 private:
  void add_bytes(const std::string& name, const void* data, std::size_t size) {
    fields_.emplace_back(name, std::string(static_cast<const char*>(data), size));
  }

  template <class Value>
  requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
  void add(const std::string& name, Value value) { add_bytes(name, &value, sizeof value); }

  void add(const std::string& name, const std::string& value) { fields_.emplace_back(name, value); }

  template <class Value>
  void add(const std::string& name, const std::optional<Value>& value) {
    add(name + ".has_value()", value.has_value());
    if (value) add(name, *value);
  }

  template <class Derived>
  void add(const std::string& name, const Eigen::PlainObjectBase<Derived>& matrix) {
    add_bytes(name, matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double));
  }

  void add(const std::string& name, const Natural& number) { add(name, number.decimal()); }

  void add(const std::string& name, const SolutionTotals& totals) {
    const auto& [real, complex, generic] = totals;
    add(name + ".real", real);
    add(name + ".complex", complex);
    add(name + ".generic", generic);
  }

  void add(const std::string& name, const Figure& figure) {
    const auto& [points, lines, imaginary, imaginary_lines, planes, imaginary_planes] = figure;
    add(name + ".points", points);
    add(name + ".imaginary", imaginary);
    add(name + ".lines", lines);
    add(name + ".imaginary_lines", imaginary_lines);
    add(name + ".planes", planes);
    add(name + ".imaginary_planes", imaginary_planes);
  }

  void add(const std::string& name, const Candidate& candidate) {
    const auto& [figure, multiplicity, error, condition] = candidate;
    add(name, figure);
    add(name + ".multiplicity", multiplicity);
    add(name + ".error", error);
    add(name + ".condition", condition);
  }

  void add(const std::string& name, const std::vector<std::array<int, 2>>& pairs) {
    add(name + ".size()", pairs.size());
    for (const auto& [one, other] : pairs) {
      add(name + ".one", one);
      add(name + ".other", other);
    }
  }

  void add(const std::string& name, const Motion& motion) {
    const auto& [coincident, parallel, dimension, is_exact, is_proven, figure, curve] = motion;
    add(name + ".coincident", coincident);
    add(name + ".parallel", parallel);
    add(name + ".dimension", dimension);
    add(name + ".is_exact", is_exact);
    add(name + ".is_proven", is_proven);
    add(name, figure);
    const auto& [figures, end, residual] = curve;
    add(name + ".curve", figures);
    add(name + ".curve.end", end);
    add(name + ".curve.residual", residual);
  }

  void add(const std::string& name, const std::vector<Figure>& figures) {
    add(name + ".size()", figures.size());
    for (const Figure& one : figures) add(name, one);
  }

  void add(const std::string& name, const std::vector<std::complex<double>>& numbers) {
    add_bytes(name, numbers.data(), numbers.size() * sizeof(std::complex<double>));
  }

  void add(const std::string& name, const GenericMember& member) {
    const auto& [squares, solutions] = member;
    add(name + ".squares", squares);
    for (const auto& solution : solutions) add(name + ".solution", solution);
  }

  void add(const std::string& name, const std::vector<LinePosition>& lines) {
    add(name + ".size()", lines.size());
    for (const auto& [point, direction] : lines) {
      add(name + ".point", point);
      add(name + ".direction", direction);
    }
  }

  void add(const std::string& name, const std::vector<PlanePosition>& planes) {
    add(name + ".size()", planes.size());
    for (const auto& [normal, offset] : planes) {
      add(name + ".normal", normal);
      add(name + ".offset", offset);
    }
  }

  void add(const std::string& name, const PathRecord& path) {
    const auto& [end, cause, length, crossings, winding_number, pole_order, proven, plans] = path;
    add(name + ".end", end);
    add(name + ".cause", cause);
    add(name + ".length", length);
    add(name + ".winding_number", winding_number);
    add(name + ".pole_order", pole_order);
    add(name + ".proven", proven);
    add(name + ".crossings.size()", crossings.size());
    for (const auto& [candidate, direction] : crossings) {
      add(name + ".crossing.candidate", candidate);
      add(name + ".crossing.direction", direction);
    }
    add(name + ".plans.size()", plans.size());
    for (const auto& [figure, t, removed] : plans) {
      add(name + ".plan.points", figure.points);
      add(name + ".plan.t", t);
      add(name + ".plan.removed.size()", removed.size());
      for (const int constraint : removed) add(name + ".plan.removed", constraint);
    }
  }

  void add(const std::string& name, const WorkCounters& work) {
    const auto& [iterations, rejected_steps, newton_iterations, evaluations, partial_evaluations, jacobians,
                 factorisations, plan_changes, smallest_step, mean_driving_parameters,
                 max_driving_parameters] = work;
    add(name + ".iterations", iterations);
    add(name + ".rejected_steps", rejected_steps);
    add(name + ".newton_iterations", newton_iterations);
    add(name + ".evaluations", evaluations);
    add(name + ".partial_evaluations", partial_evaluations);
    add(name + ".jacobians", jacobians);
    add(name + ".factorisations", factorisations);
    add(name + ".plan_changes", plan_changes);
    add(name + ".smallest_step", smallest_step);
    add(name + ".mean_driving_parameters", mean_driving_parameters);
    add(name + ".max_driving_parameters", max_driving_parameters);
  }

  std::vector<std::pair<std::string, std::string>> fields_;
};

}  // namespace

std::optional<std::string> first_difference(const SolveReport& a, const SolveReport& b) {
  const Fields of_a(a), of_b(b);
  const auto [at, other] =
      std::mismatch(of_a.list().begin(), of_a.list().end(), of_b.list().begin(), of_b.list().end());
  if (at != of_a.list().end()) return at->first;
  if (other != of_b.list().end()) return other->first;
  return std::nullopt;
}

}  // namespace gcs::contract
