#pragma once
/// The whole interface of a strategy. To add one: a file solvers/strategies/my_idea.cpp that defines
/// `StrategyEntry my_idea_entry()`, and the line gcs_add_strategy(my_idea) in
/// solvers/strategies/CMakeLists.txt.

#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/construction/plan_use.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/natural.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/running/journal.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

class Crew;           // solvers/running/crew.hpp
class SceneAnalysis;  // solvers/counting/scene_analysis.hpp
class StartStore;     // solvers/homotopies/start_store.hpp

/// What a strategy may use, whatever the scene.
struct SolveMeans {
  std::uint64_t seed = 1;
  int threads = 1;               ///< with a crew: of all its members here, while the others wait
  std::stop_token stop{};        ///< asked for: return what is there with SolveStatus::stopped
  Monitor* monitor = nullptr;    ///< may be null
  Journal* journal = nullptr;    ///< may be null; see StrategyEntry::keeps_journal
  Crew* crew = nullptr;          ///< may be null; other processes that do parts of the work
  StartStore* starts = nullptr;  ///< may be null for strategies whose options name no start system
  /// Solutions to list at most, where there are so many that they are counted without being listed.
  std::optional<std::size_t> most_listed = std::nullopt;
};

/// All that a strategy may see.
struct SolveRequest : SolveMeans {
  SolveRequest(const Scene& of, SolveMeans means = {}, const SceneAnalysis* known = nullptr)
      : SolveMeans(std::move(means)), scene(of), analysis(known) {}

  /// The same for another scene.
  SolveRequest on(const Scene& other, const SceneAnalysis* known = nullptr) const {
    return SolveRequest(other, *this, known);
  }

  const Scene& scene;
  const SceneAnalysis* analysis;  ///< of the scene; may be null
};

/// What a strategy says that it found; the harness checks it.
enum class Claim {
  some_real,
  on_path,
  on_path_of_core,
  all_real_of_component,  ///< no other is joined to one of these by curves along which one value changes
  all_real,
  all_complex
};

/// How a solve ended. Everything but `complete` comes with a reason.
enum class SolveStatus { complete, partial, infinite, gave_up, stopped };

/// One solution in the scene's own unit, in any position (the harness moves it into the frame).
struct Candidate {
  Figure figure;
  int multiplicity = 1;
  /// Proven: no point is further from its place in a solution, up to a motion, in the scene's unit. Infinite
  /// where nothing is proven.
  double error = std::numeric_limits<double>::infinity();
  /// jacobian_condition of the scene at the figure, if the strategy knows it.
  std::optional<double> condition{};
};

/// The path met t = 1 at candidates[candidate], going in the direction of growing t (+1) or falling t (−1).
struct Crossing {
  int candidate = 0;
  int direction = 1;
};

/// One tracked path and its end.
struct PathRecord {
  enum class End { closed, regular, singular, at_infinity, failed, stopped };
  End end = End::failed;
  std::string cause;  ///< why, in words, when `end` is failed or stopped
  double length = 0;  ///< arc length in (X, t), X in the scene's unit
  std::vector<Crossing> crossings;
  int winding_number = 0;  ///< w: near its end the path is a series in (1 − t)^(1/w); 0: not determined
  int pole_order = 0;      ///< k: at infinity like (1 − t)^(−k/w); 0: finite, or not determined
  bool proven = false;     ///< its closing, and the order and number of its crossings, are proven
  /// The construction plans it was followed with, in order, the first from the sketch on; empty: with none.
  std::vector<PlanUse> plans{};
};

/// Figures of a scene along a curve, in order: a polyline, in the scene's unit.
struct FigureCurve {
  std::vector<Figure> figures;
  /// closed: the last figure is the first again; at_infinity or singular: so at both ends, or at the one that was come to
  /// first; stopped: after so many figures.
  PathRecord::End end = PathRecord::End::stopped;
  double residual = 0;  ///< the largest relative error of a distance
};

/// Solutions that are not isolated. Proven: where points coincide, or bars of one length are parallel, some distances say
/// the same, and what is left of them is loose (motions/collapse.hpp). Others seem to move: along a curve of all distances
/// but one that one stays met too, to rounding.
struct Motion {
  std::vector<std::array<int, 2>> coincident;  ///< pairs of points
  std::vector<std::array<int, 2>> parallel;    ///< pairs of constraints
  int dimension = 1;  ///< of the solutions around `figure`; at least, unless it is exact
  bool is_exact = false;
  bool is_proven = true;
  Figure figure;  ///< one of them, in the scene's frame and unit; real where a real one is known
  /// From a real figure on, in the frame; empty where none is known. One of many where the dimension is not 1.
  FigureCurve curve{};
};

/// A curve of figures that meet all equations but that of one value, followed to both ends or until it is closed. Its t
/// grows with what that equation says of the figure, and is 1 where the value is met.
struct CurveRecord {
  int released = -1;  ///< the value, counted as constraints and then relations
  PathRecord path;
  /// Along it, where they were asked for, in the scene's unit and in one position after the other.
  std::vector<Figure> figures{};
  std::vector<std::size_t> places{};  ///< of the crossings of the path: which of the figures is there
};

/// A count that only this strategy knows, such as the candidates of a scan.
struct Particular {
  std::string name;  ///< a fixed word of lower-case letters and underscores, unique in a report
  std::int64_t value = 0;

  bool operator==(const Particular&) const = default;
};

/// Solutions at lengths of the strategy's own choice, for which it found as many classes as it says that
/// there are at generic lengths.
struct GenericMember {
  std::vector<std::complex<double>> squares;  ///< of the lengths, one per constraint, in any unit
  std::vector<std::vector<std::complex<double>>> solutions;  ///< the free coordinates of the scene's frame
};

/// How many classes there are, where they follow from those of the scene's parts. The candidates may be
/// fewer. A number that is not determined is empty.
struct SolutionTotals {
  std::optional<Natural> real;
  std::optional<Natural> complex;
  std::optional<Natural> generic;

  bool operator==(const SolutionTotals&) const = default;
};

struct SolveReport {
  SolveStatus status = SolveStatus::gave_up;
  std::string reason;  ///< empty when complete
  Claim claim = Claim::some_real;
  /// Distinct points of S or solutions; the harness groups them into classes.
  std::vector<Candidate> candidates;
  std::vector<PathRecord> paths;
  std::vector<Motion> motions;      ///< no candidate lies on one that is proven
  std::vector<CurveRecord> curves;  ///< between candidates: the edges of a graph
  /// Of each path to a solution at infinity a figure near its end, at other lengths, as in Candidate.
  std::vector<Figure> escaping;
  std::optional<std::uint64_t> generic;         ///< number of classes at generic lengths, where it is known
  std::optional<GenericMember> generic_member;  ///< proves `generic`, where certificates reach it
  /// How many of these have escaped; with paths, their ends say it.
  std::optional<std::uint64_t> at_infinity;
  std::optional<SolutionTotals> totals;  ///< of a scene that was taken apart
  WorkCounters work;
  std::vector<Particular> particulars;

  /// Compiled once.
  SolveReport();
  SolveReport(const SolveReport&);
  SolveReport(SolveReport&&) noexcept;
  SolveReport& operator=(const SolveReport&);
  SolveReport& operator=(SolveReport&&) noexcept;
  ~SolveReport();
};

/// One option: `--set name=value`.
struct OptionSpec {
  std::string_view name;
  std::string default_value;
  std::string allowed;  ///< "a|b|c" for a choice, otherwise in words: "a number from 0 to 1"
  std::string_view summary;
  bool is_length = false;  ///< in the file's unit of length: means another length when the unit changes
  /// False: it says how to compute, or what else to write, and a journal serves all its values.
  bool changes_result = true;
};
/// Every option of the strategy has an entry: the default where the user said nothing.
using OptionMap = std::map<std::string, std::string, std::less<>>;

/// Thrown by StrategyEntry::make for a value that is not allowed; what() names option, value and what would
/// be right.
class OptionError : public UserError {
 public:
  using UserError::UserError;
};

class Strategy {
 public:
  virtual ~Strategy() = default;
  /// Why the scene is out of reach, or nullopt. A sentence for a person. Called before prepare and solve, with the
  /// same request.
  virtual std::optional<std::string> why_unsupported(const SolveRequest& request) const = 0;
  /// Work that a second solve of the same graph with other lengths may reuse. Timed apart from solve.
  virtual void prepare(const SolveRequest&) {}
  /// Timed. May be called again with the same request and then gives the same report.
  virtual SolveReport solve(const SolveRequest& request) = 0;
};

struct StrategyEntry {
  std::string_view name;     ///< command-line name and table label
  std::string_view summary;  ///< one line
  std::string_view citation;
  bool needs_sketch = false;
  bool knows_general_scenes = false;  ///< it is asked about scenes with more than points, lines and distances
  bool keeps_journal = false;  ///< a solve with the journal of an interrupted one goes on where that stopped
  std::vector<OptionSpec> options;
  /// Beside the defaults: settings that trade accuracy or certainty for time, rough ones first. They are
  /// measured by `gcsbench precision`.
  std::vector<OptionMap> accuracy_settings;
  std::function<std::unique_ptr<Strategy>(const OptionMap& options)> make;
};

/// All strategies of this build, in the order of solvers/strategies/CMakeLists.txt.
std::span<const StrategyEntry> all_strategies();

/// A part that this build does without.
struct LeftOutPart {
  std::string_view name;    ///< "strategy polyhedral"
  std::string_view option;  ///< of CMake, that brings it back when ON
};
std::span<const LeftOutPart> left_out_parts();

/// Defaults overridden by `given`. Throws OptionError for a name that the entry does not have.
OptionMap complete_options(const StrategyEntry& entry, const OptionMap& given);

}  // namespace gcs
