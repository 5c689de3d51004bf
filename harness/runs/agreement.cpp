#include "harness/runs/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace gcs {
namespace {

std::string described(const CellRecord& cell) {
  return fmt::format("{} found {}", cell.spec.strategy, *cell.counts.on_path);
}

using Cells = std::vector<const CellRecord*>;

/// The complete cells of an instance with default options that count solutions on the path.
Cells standard_cells(const std::vector<CellRecord>& cells, const std::string& instance) {
  Cells standard;
  for (const CellRecord& cell : cells) {
    const bool counts = cell.status == RunStatus::complete && cell.counts.on_path;
    if (counts && cell.spec.instance == instance && cell.spec.given.empty()) standard.push_back(&cell);
  }
  return standard;
}

bool agree(const Cells& cells) {
  return std::all_of(cells.begin(), cells.end(),
                     [&](const CellRecord* c) { return c->counts.on_path == cells.front()->counts.on_path; });
}

std::string disagreement(const Cells& cells) {
  std::string text = "The strategies disagree:";
  for (const CellRecord* cell : cells) text += (cell == cells.front() ? " " : ", ") + described(*cell);
  return text + ".";
}

/// A strategy that claims all real solutions has those on S too.
std::string shortfall(const CellRecord& cell, const Cells& standard) {
  if (!cell.counts.real_up_to_reflection || standard.empty()) return "";
  const Natural& real = *cell.counts.real_up_to_reflection;
  const std::uint64_t on_path = *standard.front()->counts.on_path;
  if (real >= Natural(on_path)) return "";
  return fmt::format("Found {} real solutions, fewer than the {} on S.", real.decimal(), on_path);
}

std::string difference_of(const CellRecord& cell, const Cells& standard,
                          std::optional<std::uint64_t> expected) {
  if (!agree(standard)) return disagreement(standard);
  const std::uint64_t found = *cell.counts.on_path;
  if (!standard.empty() && !cell.spec.given.empty()) expected = standard.front()->counts.on_path;
  if (!expected || found == *expected) return "";
  const std::int64_t excess = static_cast<std::int64_t>(found) - static_cast<std::int64_t>(*expected);
  return fmt::format("Found {} on S instead of {} ({:+}).", found, *expected, excess);
}

}  // namespace

void note_differences(std::vector<CellRecord>& cells, const ExpectedCounts& expected) {
  const std::vector<CellRecord> answers = cells;
  for (CellRecord& cell : cells) {
    if (!cell.is_right()) continue;
    const Cells standard = standard_cells(answers, cell.spec.instance);
    const auto entry = expected.find(cell.spec.instance);
    const auto count = entry == expected.end() ? std::nullopt : std::optional(entry->second);
    cell.difference = cell.counts.on_path ? difference_of(cell, standard, count) : shortfall(cell, standard);
    if (!cell.is_right()) cell.repetitions.clear();
  }
}

}  // namespace gcs
