#include "harness/report/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "harness/instances/families_graphs.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/tables/table_entries.hpp"

namespace gcs {
namespace {

/// A number of classes, and what is known of it.
struct Known {
  std::uint64_t classes = 0;
  bool is_proven = false;
  std::string reason;
};

using Count = std::optional<Natural> Counts::*;

std::vector<const CellRecord*> right_cells(const RunFile& run, const std::string& id) {
  std::vector<const CellRecord*> cells;
  for (const CellRecord& cell : run.cells)
    if (cell.spec.instance == id && cell.is_right() && !cell.is_flawed()) cells.push_back(&cell);
  return cells;
}

/// `is_all`: proven with multiplicities counted, of which clusters have some.
std::string found_by(const CellRecord& cell, std::uint64_t certified, bool is_all) {
  const std::string certificates =
      cell.proofs ? fmt::format("{} certified", certified) : "not certified in this run";
  return fmt::format("found by {}, {}; {}", label_of(cell.spec), certificates,
                     is_all
                         ? "with those in clusters, counted with multiplicities, they are proven to be all; "
                           "how many of these differ is not proven"
                         : "that there are no more is not proven");
}

/// The proven number where a cell proves it, otherwise the one found with most certificates.
std::optional<Known> best(const std::vector<const CellRecord*>& cells,
                          std::optional<std::uint64_t> (*found)(const CellRecord&),
                          std::uint64_t RecordedProofs::*certified, bool RecordedProofs::*is_decided,
                          const std::string& proof) {
  std::optional<Known> known;
  std::uint64_t most = 0;
  for (const CellRecord* cell : cells) {
    const auto number = found(*cell);
    if (!number) continue;
    const std::uint64_t proven = cell->proofs ? (*cell->proofs).*certified : 0;
    const bool is_all = cell->proofs && (*cell->proofs).*is_decided;
    if (is_all && proven == *number)
      return Known{proven, true, fmt::format("{} ({})", proof, label_of(cell->spec))};
    if (known && proven <= most) continue;
    most = proven;
    known = {*number, false, found_by(*cell, proven, is_all)};
  }
  return known;
}

std::optional<std::uint64_t> small(const std::optional<Natural>& count) {
  if (!count || *count > Natural::power_of_two(53)) return std::nullopt;
  return std::stoull(count->decimal());
}

std::optional<Known> complex_solutions(const std::vector<const CellRecord*>& cells) {
  return best(
      cells, [](const CellRecord& cell) { return small(cell.counts.complex_up_to_reflection); },
      &RecordedProofs::classes, &RecordedProofs::is_complete, "each certified, and no lengths have more");
}

/// All real solutions certified that a scan of ours leaves: where it is complete, it proves that there are no
/// others.
std::optional<Known> scanned_solutions(const std::vector<const CellRecord*>& cells) {
  for (const CellRecord* cell : cells) {
    if (cell->claim != Claim::all_real || exec_command(cell->spec.strategy) || !cell->proofs) continue;
    const auto number = small(cell->counts.real_up_to_reflection);
    if (number && cell->proofs->real == *number)
      return Known{*number, true,
                   fmt::format("each certified, and the scan excludes others ({})", label_of(cell->spec))};
  }
  return std::nullopt;
}

/// A stored list counts where no cell has certificates.
std::optional<Known> real_solutions(const std::vector<const CellRecord*>& cells, const StoredScene* scene) {
  auto known = best(
      cells, [](const CellRecord& cell) { return small(cell.counts.real_up_to_reflection); },
      &RecordedProofs::real, &RecordedProofs::decides_real,
      "each certified, and all complex solutions are known");
  if (!known || !known->is_proven)
    if (auto scanned = scanned_solutions(cells)) return scanned;
  const bool is_certified = std::any_of(cells.begin(), cells.end(),
                                        [](const CellRecord* cell) { return cell->proofs.has_value(); });
  if (is_certified || scene == nullptr || !scene->record.are_proven) return known;
  const ShownScene& record = scene->record;
  return Known{record.solutions.size(), record.is_real_proven,
               fmt::format("each certified ({}); {}", record.source,
                           record.is_real_proven ? "that there are no more is proven"
                                                 : "that there are no more is not proven here")};
}

constexpr std::string_view proven_tubes = "S is followed in proven tubes until it closes";

/// Where the stored scene has S, and in its list all solutions that S meets.
std::optional<Known> solutions_on_shown_path(const StoredScene* scene) {
  if (scene == nullptr || !scene->path) return std::nullopt;
  const auto& crossings = scene->record.crossings;
  std::set<int> met;
  for (const auto& crossing : crossings) {
    if (!crossing) return std::nullopt;
    met.insert(crossing->solution);
  }
  return Known{met.size(), true,
               fmt::format("{}, with {} crossings of t = 1", proven_tubes, crossings.size())};
}

/// Where no scene shows S, a cell whose answer proves its closing, otherwise the first that has S.
std::optional<Known> solutions_on_path(const std::vector<const CellRecord*>& cells,
                                       const StoredScene* scene) {
  auto known = solutions_on_shown_path(scene);
  if (known) return known;
  for (const CellRecord* cell : cells) {
    const std::optional<std::uint64_t> count = cell->counts.on_path;
    if (!count) continue;
    if (cell->is_path_proven)
      return Known{*count, true, fmt::format("{} ({})", proven_tubes, label_of(cell->spec))};
    if (!known)
      known = {*count, false, fmt::format("found by {}, which proves no closing", label_of(cell->spec))};
  }
  return known;
}

const PrintedFigure* printed_figure(const Publications& publications, const std::string& row,
                                    const std::string& id) {
  for (const auto& [name, publication] : publications)
    for (const PrintedFigure& figure : publication.figures)
      if (figure.row == row && figure.instance == id) return &figure;
  return nullptr;
}

/// How many printed solutions make one class of a shipped instance; nothing for another convention.
std::optional<int> per_class(const PrintedFigure& figure, const InstanceSummary& instance) {
  if (figure.convention == "all signs")
    return sign_patterns(instance.has_given_positions, instance.dimension);
  if (figure.convention == instance.convention) return 1;
  if (figure.convention == "up to reflection" || figure.convention.starts_with("lines")) return 1;
  if (figure.convention == "fixed frame") return frame_images(load_instance(instance.id).problem).in_frame;
  return std::nullopt;
}

/// Of an instance that was chosen to agree with the paper, agreement proves nothing; and lengths with fewer than the most
/// that is known refute nothing.
VerdictStanding standing_of(const PrintedFigure& figure, const std::optional<Known>& ours,
                            std::optional<int> factor) {
  if (figure.correction)
    return figure.correction->is_proof ? VerdictStanding::refuted : VerdictStanding::open;
  if (!ours || !ours->is_proven || !factor || !figure.chosen.empty()) return VerdictStanding::open;
  const double found = static_cast<double>(ours->classes) * *factor;
  if (figure.at_least) return found >= figure.value ? VerdictStanding::proven : VerdictStanding::open;
  return found == figure.value ? VerdictStanding::proven : VerdictStanding::refuted;
}

std::optional<Verdict> verdict(const std::string& quantity, const std::string& row,
                               const std::optional<Known>& ours, const InstanceSummary& instance,
                               const Publications& publications) {
  const PrintedFigure* figure =
      instance.is_shipped ? printed_figure(publications, row, instance.id) : nullptr;
  if (!ours && figure == nullptr) return std::nullopt;
  Verdict result{quantity, "", std::nullopt, ours ? std::to_string(ours->classes) : "not measured",
                 VerdictStanding::open};
  if (figure != nullptr) {
    result.printed =
        fmt::format("{}{} ({})", figure->at_least ? "at least " : "", figure->printed, figure->convention);
    result.printed_standing = standing_of(*figure, ours, per_class(*figure, instance));
    if (figure->correction)
      result.reason = "Printed: " + figure->correction->reason + " (" + figure->correction->source + ") ";
    if (figure->at_least) result.reason = "Printed: at other lengths of this graph. ";
    if (!figure->chosen.empty()) result.reason = "Printed: " + figure->chosen + " ";
  }
  if (!ours) return result;
  result.our_standing = ours->is_proven ? VerdictStanding::proven : VerdictStanding::open;
  result.reason += "Ours: " + ours->reason + ".";
  return result;
}

}  // namespace

std::string_view word(VerdictStanding standing) {
  switch (standing) {
    case VerdictStanding::proven:
      return "proven";
    case VerdictStanding::refuted:
      return "refuted";
    case VerdictStanding::open:
      break;
  }
  return "open";
}

std::vector<Verdict> verdicts(const RunFile& run, const InstanceSummary& instance, const StoredScene* scene,
                              const Publications& publications) {
  const auto cells = right_cells(run, instance.id);
  std::vector<Verdict> all;
  const auto add = [&](const std::string& quantity, const std::string& row,
                       const std::optional<Known>& ours) {
    if (auto one = verdict(quantity, row, ours, instance, publications)) all.push_back(std::move(*one));
  };
  add("complex", "complex", complex_solutions(cells));
  add("real", "real", real_solutions(cells, scene));
  add("on S", "on path", solutions_on_path(cells, scene));
  return all;
}

Table verdict_table(const RunFile& run, const std::map<std::string, StoredScene>& scenes,
                    const Publications& publications) {
  Table table{.name = "verdicts",
              .caption = "Numbers of solutions: what the papers print, and what is proven, refuted or open",
              .stub = "",
              .groups = {{"published", {""}}, {"is", {""}}, {"ours", {""}}, {"is", {""}}, {"why", {""}}},
              .rows = {},
              .footnotes = {},
              .remarks = {"Ours count classes up to reflection; with given positions all figures, and of "
                          "bodies that are no mirror image "
                          "of themselves solutions up to motion.",
                          measured_with(run)}};
  for (const InstanceSummary& instance : run.instances) {
    if (graph_member(instance.id)) continue;  // hundreds, of which a table of their own tells
    const auto scene = scenes.find(instance.id);
    for (const Verdict& one :
         verdicts(run, instance, scene == scenes.end() ? nullptr : &scene->second, publications)) {
      const auto standing = one.printed_standing ? word(*one.printed_standing) : "–";
      table.rows.push_back({instance.id + ", " + one.quantity,
                            {{one.printed.empty() ? "–" : one.printed, {}},
                             {std::string(standing), {}},
                             {one.ours, {}},
                             {std::string(word(one.our_standing)), {}},
                             {one.reason.empty() ? "–" : one.reason, {}}},
                            {}});
    }
  }
  return table;
}

}  // namespace gcs
