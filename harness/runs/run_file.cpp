#include "harness/runs/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "harness/base/record_fields.hpp"
#include "harness/results/exec_strategy.hpp"
#include "solvers/reading/json_document.hpp"
#include "solvers/reading/text_input.hpp"

namespace gcs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format_name = "gcsbench-run/1";

/// The one of `all` whose word is `text`.
template <typename Named, std::size_t count>
Named named(const std::array<Named, count>& all, const std::string& text) {
  const auto* const found =
      std::find_if(all.begin(), all.end(), [&](Named one) { return word(one) == text; });
  if (found == all.end()) throw std::invalid_argument("unknown word '" + text + "'");
  return *found;
}

template <typename Record, typename Visit>
void visit_repetition(Record& repetition, Visit visit) {
  visit("prepare_s", repetition.prepare_s);
  visit("solve_s", repetition.solve_s);
  visit("cpu_s", repetition.cpu_s);
  visit("refine_s", repetition.refine_s);
}

template <typename Record, typename Visit>
void visit_accuracy(Record& accuracy, Visit visit) {
  visit("met", accuracy.met);
  visit("missed", accuracy.missed);
  visit("spurious", accuracy.spurious);
  visit("largest_error", accuracy.largest_error);
  visit("median_error", accuracy.median_error);
  visit("largest_condition", accuracy.largest_condition);
  visit("largest_quotient", accuracy.largest_quotient);
}

template <typename Record, typename Visit>
void visit_instance(Record& instance, Visit visit) {
  visit("id", instance.id);
  visit("origin", instance.origin);
  visit("fingerprint", instance.fingerprint);
  visit("equations", instance.equations);
  visit("dimension", instance.dimension);
}

template <typename Record, typename Visit>
void visit_length(Record& length, Visit visit) {
  visit("between", length.between);
  visit("text", length.text);
  visit("squared", length.is_squared);
}

template <typename Record, typename Visit>
void visit_limit(Record& limit, Visit visit) {
  visit("exact", limit.is_exact);
  visit("all_signs", limit.all_signs);
  visit("reference", limit.bound.reference);
  visit("parts", limit.bound.parts);
}

template <typename Record, typename Visit>
void visit_table(Record& table, Visit visit) {
  visit("name", table.name);
  visit("instances", table.instances);
}

template <typename Record, typename Visit>
void visit_session(Record& session, Visit visit) {
  visit("started", session.started);
  visit("arguments", session.arguments);
  visit("folder", session.folder);
  visit("load_average", session.load_average);
  visit("repetitions", session.repetitions);
  visit("budget_s", session.budget_s);
  visit("cell_limit_s", session.cell_limit_s);
  visit("total_limit_s", session.total_limit_s);
}

template <typename Record, typename Visit>
void visit_curve(Record& curve, Visit visit) {
  visit("instance", curve.instance);
  visit("given", curve.given);
  visit("theta", curve.theta);
  visit("gap", curve.gap);
}

template <typename Record, typename Visit>
void visit_proofs(Record& proofs, Visit visit) {
  visit("classes", proofs.classes);
  visit("real", proofs.real);
  visit("complete", proofs.is_complete);
  visit("real_complete", proofs.decides_real);
}

template <typename Record, typename Visit>
void visit_solution(Record& solution, Visit visit) {
  visit("real", solution.is_real);
  visit("multiplicity", solution.multiplicity);
  visit("points", solution.points);
}

/// A number beyond 2^53 as text.
Json json_of(const Natural& count) {
  const std::string text = count.decimal();
  return count > Natural::power_of_two(53) ? Json(text) : Json::parse(text);
}

/// JSON has no infinity; null stands for it.
Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

/// Writes one member; an empty optional is null.
struct Writer {
  Json& json;

  template <typename T>
  void operator()(const std::string& name, const T& value) const {
    json[name] = value;
  }
  void operator()(const std::string& name, double value) const { json[name] = json_of(value); }
  template <typename T>
  void operator()(const std::string& name, const std::optional<T>& value) const {
    json[name] = value ? Json(*value) : Json(nullptr);
  }
  void operator()(const std::string& name, const std::optional<Natural>& value) const {
    json[name] = value ? json_of(*value) : Json(nullptr);
  }
};

struct Reader {
  const Json& json;

  template <typename T>
  void operator()(const char* name, T& value) const {
    value = json.at(name).get<T>();
  }
  void operator()(const char* name, double& value) const { value = number_of(json.at(name)); }
  template <typename T>
  void operator()(const char* name, std::optional<T>& value) const {
    const Json& member = json.at(name);
    value = member.is_null() ? std::nullopt : std::optional<T>(member.get<T>());
  }
  void operator()(const char* name, std::optional<Natural>& value) const {
    const Json& member = json.at(name);
    value = Natural::from_decimal(member.is_string() ? member.get<std::string>() : member.dump());
  }
};

Json object_of(const OptionMap& options) {
  Json json = Json::object();
  for (const auto& [name, value] : options) json[name] = value;
  return json;
}

OptionMap options_of(const Json& json) {
  OptionMap options;
  for (const auto& [name, value] : json.items()) options[name] = value.get<std::string>();
  return options;
}

/// Empty where the member is null, or missing, as in runs from before it was written.
std::optional<double> number_if_any(const Json& json, const char* name) {
  const Json number = json.value(name, Json());
  return number.is_null() ? std::nullopt : std::optional(number.get<double>());
}

Json cell_json(const CellRecord& cell) {
  Json json{{"instance", cell.spec.instance},
            {"strategy", cell.spec.strategy},
            {"given", object_of(cell.spec.given)},
            {"digits", cell.spec.digits},
            {"options", object_of(cell.options)},
            {"status", word(cell.status)},
            {"reason", cell.reason},
            {"difference", cell.difference},
            {"residual", json_of(cell.residual)},
            {"warm_up_s", cell.warm_up_s},
            {"limit_s", cell.limit_s ? Json(*cell.limit_s) : Json(nullptr)},
            {"estimate_s", cell.estimate_s ? Json(*cell.estimate_s) : Json(nullptr)},
            {"counts", Json::object()},
            {"proofs", nullptr},
            {"claim", cell.claim ? Json(word(*cell.claim)) : Json(nullptr)},
            {"accuracy", nullptr},
            {"work", Json::object()},
            {"particulars", Json::object()},
            {"solutions", Json::array()},
            {"planned", cell.planned},
            {"repetitions", Json::array()}};
  visit_counts(cell.counts, Writer{json["counts"]});
  if (cell.proofs) visit_proofs(*cell.proofs, Writer{json["proofs"]});
  if (cell.accuracy) visit_accuracy(*cell.accuracy, Writer{json["accuracy"]});
  visit_work(cell.work, Writer{json["work"]});
  visit_particulars(cell.particulars, Writer{json["particulars"]});
  for (const RecordedSolution& solution : cell.solutions)
    visit_solution(solution, Writer{json["solutions"].emplace_back(Json::object())});
  for (const Repetition& repetition : cell.repetitions) {
    visit_repetition(repetition, Writer{json["repetitions"].emplace_back(Json::object())});
  }
  return json;
}

CellRecord cell_of(const Json& json) {
  CellRecord cell;
  const Reader read{json};
  read("instance", cell.spec.instance);
  read("strategy", cell.spec.strategy);
  read("reason", cell.reason);
  read("difference", cell.difference);
  read("residual", cell.residual);
  cell.warm_up_s = json.value("warm_up_s", 0.0);
  cell.planned = json.value("planned", 0);
  cell.limit_s = number_if_any(json, "limit_s");
  cell.estimate_s = number_if_any(json, "estimate_s");
  cell.spec.given = options_of(json.at("given"));
  cell.options = options_of(json.at("options"));
  cell.status = named(all_statuses, json.at("status").get<std::string>());
  visit_counts(cell.counts, Reader{json.at("counts")});
  if (const Json proofs = json.value("proofs", Json()); !proofs.is_null())
    visit_proofs(cell.proofs.emplace(), Reader{proofs});
  cell.spec.digits = json.value("digits", 0);
  if (const Json claim = json.value("claim", Json()); !claim.is_null())
    cell.claim = named(all_claims, claim.get<std::string>());
  if (const Json accuracy = json.value("accuracy", Json()); !accuracy.is_null())
    visit_accuracy(cell.accuracy.emplace(), Reader{accuracy});
  visit_work(cell.work, Reader{json.at("work")});
  for (const auto& [name, value] : json.at("particulars").items())
    cell.particulars.push_back({name, value.get<std::int64_t>()});
  for (const Json& entry : json.at("solutions")) visit_solution(cell.solutions.emplace_back(), Reader{entry});
  for (const Json& entry : json.at("repetitions"))
    visit_repetition(cell.repetitions.emplace_back(), Reader{entry});
  return cell;
}

Json instance_json(const InstanceSummary& instance) {
  Json json = Json::object();
  visit_instance(instance, Writer{json});
  json["lengths"] = Json::array();
  for (const GivenLength& length : instance.lengths)
    visit_length(length, Writer{json["lengths"].emplace_back(Json::object())});
  json["given_positions"] = instance.has_given_positions;
  json["reference"] = instance.reference;
  json["shipped"] = instance.is_shipped;
  json["complex_limit"] = nullptr;
  if (instance.limit) {
    visit_limit(*instance.limit, Writer{json["complex_limit"]});
    json["complex_limit"]["ring"] = instance.limit->bound.ring;
  }
  return json;
}

InstanceSummary instance_of(const Json& json) {
  InstanceSummary instance;
  visit_instance(instance, Reader{json});
  for (const Json& entry : json.at("lengths")) visit_length(instance.lengths.emplace_back(), Reader{entry});
  instance.has_given_positions = json.value("given_positions", false);
  instance.reference = json.value("reference", "");
  instance.is_shipped = json.value("shipped", true);
  if (const Json limit = json.value("complex_limit", Json()); !limit.is_null()) {
    visit_limit(instance.limit.emplace(), Reader{limit});
    instance.limit->bound.ring = limit.value("ring", std::vector<std::vector<std::string>>());
  }
  return instance;
}

Json record_json(const RunFile& record) {
  Json json{{"format", format_name},      {"started", record.started}, {"sessions", Json::array()},
            {"seed", record.seed},        {"tables", Json::array()},   {"environment", Json::object()},
            {"instances", Json::array()}, {"curves", Json::array()},   {"cells", Json::array()}};
  for (const RunSession& session : record.sessions)
    visit_session(session, Writer{json["sessions"].emplace_back(Json::object())});
  for (const RequestedTable& table : record.tables)
    visit_table(table, Writer{json["tables"].emplace_back(Json::object())});
  visit_environment(record.environment, Writer{json["environment"]});
  for (const InstanceSummary& instance : record.instances)
    json["instances"].push_back(instance_json(instance));
  for (const RecordedCurve& curve : record.curves)
    visit_curve(curve, Writer{json["curves"].emplace_back(Json::object())});
  for (const CellRecord& cell : record.cells) json["cells"].push_back(cell_json(cell));
  return json;
}

RunFile record_of(const Json& json) {
  RunFile record;
  const Reader read{json};
  read("started", record.started);
  read("seed", record.seed);
  for (const Json& entry : json.value("sessions", Json::array()))
    visit_session(record.sessions.emplace_back(), Reader{entry});
  for (const Json& entry : json.at("tables")) visit_table(record.tables.emplace_back(), Reader{entry});
  visit_environment(record.environment, Reader{json.at("environment")});
  for (const Json& entry : json.at("instances")) record.instances.push_back(instance_of(entry));
  for (const Json& entry : json.at("curves")) visit_curve(record.curves.emplace_back(), Reader{entry});
  for (const Json& entry : json.at("cells")) record.cells.push_back(cell_of(entry));
  return record;
}

void require_format(const Json& json, const std::string& file) {
  const bool has_format = json.is_object() && json.contains("format") && json["format"].is_string();
  const std::string found = has_format ? json["format"].get<std::string>() : "none";
  if (found == format_name) return;
  throw InputError(file, "/format", fmt::format("the format is {}", found),
                   fmt::format("give a run.json of format {}", format_name));
}

}  // namespace

std::string CellRecord::flaw() const {
  if (!difference.empty() || !contradicts_reference()) return difference;
  return fmt::format("Held against proven solutions: {} missed, {} spurious.", accuracy->missed.value_or(0),
                     accuracy->spurious);
}

std::optional<std::int64_t> CellRecord::particular(std::string_view name) const {
  const auto found = std::find_if(particulars.begin(), particulars.end(),
                                  [&](const Particular& p) { return p.name == name; });
  return found == particulars.end() ? std::nullopt : std::optional(found->value);
}

const CellRecord* RunFile::find(const CellSpec& spec) const {
  const auto found =
      std::find_if(cells.begin(), cells.end(), [&](const CellRecord& c) { return c.spec == spec; });
  return found == cells.end() ? nullptr : &*found;
}

std::string to_json_text(const RunFile& record) {
  // Folders and arguments are bytes of any encoding.
  return record_json(record).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

RunFile parse_run_file(const std::string& text, const std::string& file) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(file, "", what, "give a run.json as `gcsbench tables --out` writes it");
  };
  try {
    const Json json = Json::parse(text);
    require_format(json, file);
    return record_of(json);
  } catch (const nlohmann::json::exception& error) {
    const std::string what = error.what();
    refuse(what.substr(what.find("] ") + 2));  // without the library's own number of the error
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return {};
}

RunFile load_run_file(const std::filesystem::path& run) {
  const std::string file = (std::filesystem::is_directory(run) ? run / "run.json" : run).string();
  return parse_run_file(read_file(file, "give a run.json or the folder that holds it"), file);
}

std::string label_of(const CellSpec& spec) {
  std::string label = short_name(spec.strategy);
  for (const auto& [name, value] : spec.given) label += fmt::format(" {}={}", name, value);
  if (spec.digits > 0) label += fmt::format(", {} digits", spec.digits);
  return label;
}

std::optional<double> on_path(const CellRecord* cell) {
  if (cell == nullptr || !cell->counts.on_path) return std::nullopt;
  return static_cast<double>(*cell->counts.on_path);
}

}  // namespace gcs
