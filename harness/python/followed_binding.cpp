#include "harness/python/followed_binding.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/python/answer_arrays.hpp"
#include "harness/python/solved_instance.hpp"
#include "harness/python/watched_solve.hpp"

namespace py = pybind11;

namespace gcs {
namespace {

/// What Python calls a Followed.
struct FollowedInstance {
  Instance instance;
  Followed followed;
};

std::vector<FollowedInstance> follow_instance(const Instance& instance,
                                              const std::vector<std::map<std::string, std::string>>& texts,
                                              bool prove, bool beyond, std::optional<double> time_limit_s) {
  std::vector<ChangedValues> vertices;
  for (const auto& changes : texts) {
    ChangedValues& vertex = vertices.emplace_back();
    for (const auto& [id, value] : changes) vertex.push_back({id, value});
  }
  FollowSettings settings;
  settings.arc.prove = prove;
  settings.beyond = beyond;
  std::vector<FollowedInstance> result;
  for (Followed& leg : watched_follow(instance, *instance.problem.sketch, vertices, settings, time_limit_s))
    result.push_back({instance, std::move(leg)});
  return result;
}

bool has_figure(const FollowedInstance& f) {
  return f.followed.end == ArcEnd::reached || f.followed.end == ArcEnd::folds;
}

/// What `make(problem, figures)` says of k figures, of the one where the arc ends; None where it has no end.
template <typename Make>
py::object of_figure(const FollowedInstance& f, Make make) {
  if (!has_figure(f)) return py::none();
  const py::object made = make(f.instance.problem, std::vector<Figure>{f.followed.figure});
  if (!py::isinstance<py::dict>(made)) return made[py::int_(0)];
  py::dict result;
  for (const auto& [name, array] : made.cast<py::dict>()) result[name] = array[py::int_(0)];
  return result;
}

py::object range_of(double low, double high) { return py::make_tuple(low, high); }

py::object fold_of(const FollowedInstance& f) {
  if (f.followed.end != ArcEnd::folds) return py::none();
  return range_of(f.followed.fold.low, f.followed.fold.high);
}

py::dict values_of(const FollowedInstance& f) {
  py::dict result;
  for (const FoldValue& value : f.followed.values)
    result[py::str(value.id)] = range_of(value.low, value.high);
  return result;
}

std::optional<SolvedInstance> beyond_of(const FollowedInstance& f) {
  if (!f.followed.beyond) return std::nullopt;
  return SolvedInstance{f.instance, *f.followed.beyond};
}

std::string described_leg(const FollowedInstance& f) {
  const std::string proof = f.followed.proven ? ", proven" : "";
  return fmt::format("<gcsbench.Followed: {}{}>", word(f.followed.end),
                     has_figure(f) ? proof : ": " + f.followed.reason);
}

}  // namespace

void bind_followed(py::module_& module) {
  const auto names = [](auto member) {
    return [member](const FollowedInstance& f) { return f.instance.problem.*member; };
  };
  const auto of_leg = [](auto member) {
    return [member](const FollowedInstance& f) { return f.followed.*member; };
  };
  const auto figure = [](auto make) {
    return [make](const FollowedInstance& f) { return of_figure(f, make); };
  };
  py::class_<FollowedInstance>(module, "Followed", "Where a figure moved to.")
      .def_property_readonly("points", names(&ProblemStatement::points),
                             "names, in the order of the figure's first axis")
      .def_property_readonly("lines", names(&ProblemStatement::lines), "names, likewise")
      .def_property_readonly("planes", names(&ProblemStatement::planes), "names, likewise")
      .def_property_readonly(
          "end", [](const FollowedInstance& f) { return std::string(word(f.followed.end)); },
          "'reached', 'folds', 'undecided', 'unsupported' or 'stopped'")
      .def_property_readonly("reason", of_leg(&Followed::reason), "a sentence, unless it is reached or folds")
      .def_property_readonly("proven", of_leg(&Followed::proven), "by tubes along which the figure moved")
      .def_property_readonly("why_unproven", of_leg(&Followed::why_unproven), "where a proof was asked for")
      .def_property_readonly("figure", figure(&point_array),
                             "coordinates of the points, n × d; None unless it is reached or folds")
      .def_property_readonly("figure_lines", figure(&line_arrays), "{'point', 'direction'}: m × d each")
      .def_property_readonly("figure_planes", figure(&plane_arrays), "{'normal': m × 3, 'offset': m}")
      .def_property_readonly("error_bound", of_leg(&Followed::error),
                             "how far from the exact figure at most; None where it is not proven")
      .def_property_readonly("fold", &fold_of,
                             "between which parts of the way, 0 to 1, it folds; None unless it does")
      .def_property_readonly("values", &values_of,
                             "{id: (low, high)} at the fold: lengths, offsets or cosines")
      .def_property_readonly("beyond", &beyond_of, "an Answer with the solutions beyond the fold")
      .def("__repr__", &described_leg);
  module.def("follow", &follow_instance, py::arg("instance"), py::arg("vertices"), py::arg("prove"),
             py::arg("beyond"), py::arg("time_limit_s"));
}

}  // namespace gcs
