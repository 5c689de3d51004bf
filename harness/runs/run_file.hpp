#pragma once
/// Everything that a measurement found, as versioned JSON (gcsbench-run/1): tables are built from it without
/// solving.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/base/environment.hpp"
#include "harness/results/accuracy.hpp"
#include "harness/runs/run_session.hpp"
#include "harness/solving/counts_view.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {

/// What is measured in one cell. `given` are the options that differ from the strategy's defaults.
struct CellSpec {
  std::string instance;
  std::string strategy;
  OptionMap given;
  int digits = 0;  ///< to which every solution is refined; 0: doubles

  bool operator==(const CellSpec&) const = default;
};

/// A solution as far as tables show it. The points of a real one, in the instance's frame and the file's
/// unit; none of a complex one.
struct RecordedSolution {
  bool is_real = true;
  int multiplicity = 1;
  std::map<std::string, std::array<double, 3>> points;
};

/// What certificates prove of a cell's answer (see Proofs).
struct RecordedProofs {
  std::uint64_t classes = 0;  ///< solutions proven to exist, each in a class of its own
  std::uint64_t real = 0;     ///< those of them that are proven to be real
  bool is_complete = false;   ///< no lengths have more: these are all complex solutions
  bool decides_real = false;  ///< nor are there more real ones
};

/// One cell: the outcome of its assessed warm-up, and the times of the repetitions.
struct CellRecord : SolveOutcome {
  CellSpec spec;
  std::string difference;  ///< why the answer is wrong; empty: nothing speaks against it
  Counts counts;
  std::optional<RecordedProofs> proofs;  ///< empty: certificates do not reach the scene, or were not asked
  bool is_path_proven = false;           ///< S is proven to close, with all that it meets at t = 1
  /// Empty: not measured. Of a search that gave up only where the reference proves that there is nothing to find.
  std::optional<Accuracy> accuracy;
  double residual = 0;                      ///< largest relative residual of the solutions
  std::vector<RecordedSolution> solutions;  ///< one per class; kept only where a table shows them
  double warm_up_s = 0;                     ///< what the assessed solve took
  std::optional<double> limit_s;            ///< what a solve that was stopped by its limit was allowed
  std::optional<double> estimate_s;         ///< what a solve that was stopped by its limit would take
  int planned = 0;                          ///< repetitions; 0: not planned yet
  std::vector<Timing> repetitions;          ///< empty unless the answer is right

  /// Its claim does not hold.
  bool is_flawed() const { return !difference.empty() || contradicts_reference(); }
  bool is_right() const { return status == RunStatus::complete && !is_flawed(); }
  /// It gave up, and what it claims to find is proven not to exist.
  bool is_search_in_vain() const { return status == RunStatus::gave_up && accuracy.has_value(); }
  /// Why it is flawed, in a sentence; empty when it is not.
  std::string flaw() const;
  /// The particular of that name, if the strategy counts it.
  std::optional<std::int64_t> particular(std::string_view name) const;
  /// Compiled once.
  CellRecord();
  CellRecord(const CellRecord&);
  CellRecord(CellRecord&&) noexcept;
  CellRecord& operator=(const CellRecord&);
  CellRecord& operator=(CellRecord&&) noexcept;
  ~CellRecord();

 private:
  bool contradicts_reference() const { return accuracy && claim && accuracy->contradicts(*claim); }
};

/// "rcp mode=paper": the strategy and the options that differ from its defaults.
std::string label_of(const CellSpec& spec);

/// The solutions on the path that the cell found, if it counts them.
std::optional<double> on_path(const CellRecord* cell);

/// A constraint as the file states it.
struct GivenLength {
  std::array<std::string, 2> between;
  std::string text;  ///< the decimal number, as written
  bool is_squared = false;
};

/// How many complex solutions there are at most (see theoretical_counts).
struct RecordedLimit {
  bool is_exact = false;  ///< otherwise a bound
  std::string all_signs;  ///< in decimal
  BoundNames bound = {};  ///< what the bound is of
};

/// An instance as far as tables speak of it.
struct InstanceSummary {
  std::string id;
  std::string origin;       ///< the file it came from
  std::string fingerprint;  ///< FNV-1a, 64 bits, of the file's values as JSON on one line
  int equations = 0;        ///< constraints, the papers' m
  int dimension = 3;        ///< of the space
  std::vector<GivenLength> lengths = {};
  std::optional<RecordedLimit> limit = {};  ///< empty: not known
  bool has_given_positions = false;         ///< so that no mirror images are divided out
  std::string reference = {};               ///< what errors are measured against; empty: they are not
  bool is_shipped = true;                   ///< the instance of that id that ships, unchanged
  std::string convention = {};              ///< which figures are one solution; empty in older files
};

/// A table that was asked for, with the ids of its instances.
struct RequestedTable {
  std::string name;
  std::vector<std::string> instances;
};

/// The curve d34(θ) of an instance of 5p1L over all branches (see sample_gap_curve), and the given d34; in
/// the file's unit.
struct RecordedCurve {
  std::string instance;
  double given = 0;
  std::vector<double> theta;  ///< degrees
  std::vector<double> gap;    ///< as many
};

struct RunFile {
  std::string started;  ///< UTC, ISO 8601; when the first session did
  Environment environment;
  std::uint64_t seed = 1;
  std::vector<RunSession> sessions;        ///< in their order
  std::vector<RequestedTable> tables;      ///< in the order asked for
  std::vector<InstanceSummary> instances;  ///< of all tables, in order
  std::vector<RecordedCurve> curves;       ///< what figures show beside solutions
  std::vector<CellRecord> cells;

  /// The cell of that spec, or nullptr.
  const CellRecord* find(const CellSpec& spec) const;

  /// Compiled once.
  RunFile();
  RunFile(const RunFile&);
  RunFile(RunFile&&) noexcept;
  RunFile& operator=(const RunFile&);
  RunFile& operator=(RunFile&&) noexcept;
  ~RunFile();
};

/// The record as JSON, ending in a newline. Numbers read back as the same doubles.
std::string to_json_text(const RunFile& record);

/// Reads what to_json_text wrote. `file` is for messages. Throws InputError.
RunFile parse_run_file(const std::string& text, const std::string& file);

/// Reads a run: a run.json, or the folder that holds it. Throws InputError.
RunFile load_run_file(const std::filesystem::path& run);

}  // namespace gcs
