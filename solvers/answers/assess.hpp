#pragma once
/// Turns what a strategy reports into a result that can be compared, in the same way for every strategy:
/// classes, residuals, counts and checks. A strategy never scores itself.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/answers/assessed_solution.hpp"
#include "solvers/answers/judged_candidates.hpp"
#include "solvers/answers/path_ends.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/numeric/natural.hpp"

namespace gcs {

/// A crossing of t = 1: an index into the solutions, or empty when that solution was left out of the list.
struct AssessedCrossing {
  std::optional<int> solution;
  int direction = 1;
};

/// A curve with one value released, and the solutions on it in the order met, which are classes.
struct AssessedCurve {
  int released = -1;  ///< as in CurveRecord
  PathRecord::End end = PathRecord::End::failed;
  std::string cause;
  bool proven = false;  ///< that it is closed, and the order and number of its crossings
  std::vector<AssessedCrossing> crossings{};
  std::vector<Figure> figures{};      ///< as in CurveRecord, in the file's unit
  std::vector<std::size_t> places{};  ///< of the crossings
};

/// Counts of gcsbench-result/1; empty: the strategy does not determine it. Numbers of solutions may be those
/// of a product, of any size.
struct Counts {
  std::optional<Natural> real_up_to_reflection;
  std::optional<Natural> complex_up_to_reflection;
  std::optional<Natural> generic;
  std::optional<std::uint64_t> on_path;
  std::optional<std::uint64_t> paths;
  std::optional<std::uint64_t> at_infinity;
  std::optional<std::uint64_t> singular;
  std::optional<std::uint64_t> failed_paths;
  std::optional<std::uint64_t> certified;
  /// Real solutions of the equations that are listed and not counted as real; empty where no sign is stated.
  std::optional<std::uint64_t> not_as_stated;
  std::optional<std::uint64_t> undecided;

  bool operator==(const Counts&) const = default;
};

/// Something that must hold in a correct report and does not.
struct FailedCheck {
  /// A fixed word: residual, off path, alternation, repetition, malformed, count, certificate, singular.
  std::string name;
  std::string what;  ///< one sentence for a person
};

/// What certificates prove of a list. Counts are of classes.
struct Proofs {
  std::optional<std::string> why_none;  ///< why certificates do not reach the scene, in a sentence
  std::uint64_t classes = 0;            ///< solutions that are proven to exist, in different classes
  std::uint64_t real = 0;               ///< those of them that are proven to be real, and as stated
  std::uint64_t undecided = 0;    ///< those of them that are real, and not known to be as stated or not to be
  std::uint64_t clusters = 0;     ///< solutions that are proven to stand for several (ball_cluster.hpp)
  std::uint64_t in_clusters = 0;  ///< so many, with multiplicities
  std::uint64_t multiple = 0;     ///< clusters that are one solution each, and are among `classes`
  int most_bits = 0;              ///< the highest precision that a proof took
  /// Solutions proven to be at infinity here and finite at generic lengths (solutions_at_infinity.hpp).
  std::uint64_t at_infinity = 0;
  std::string why_not_at_infinity;  ///< of ends there that are not proven, in words; empty where all are
  /// Solutions proven in the same way at the strategy's generic lengths.
  std::optional<std::uint64_t> generic;
  std::optional<Natural> limit;         ///< no lengths have more isolated solutions; empty: not known
  bool limit_is_exact = false;          ///< generic lengths have so many
  std::optional<Natural> figure_limit;  ///< the same of figures, mirror images counted apart
  std::uint64_t with_image = 0;  ///< classes proven to be two figures, each the mirror image of the other

  /// So many proven solutions are all there are, of which some are known to be two figures.
  bool meets_limit(std::uint64_t count, std::uint64_t two_figures = 0) const;
  /// Those that the list stands for are, with those at infinity, which lengths next to these bring back.
  bool are_complete() const { return meets_limit(with_multiplicities() + at_infinity, with_image); }
  /// So many of them are real, and no more: of clusters it is not known how many differ.
  bool decide_real() const { return are_complete() && clusters == multiple && undecided == 0; }
  /// All that are proven.
  std::uint64_t with_multiplicities() const { return classes - multiple + in_clusters; }
};

struct Assessment {
  /// Of a scene that was taken apart: so many there are, however many are listed.
  std::optional<SolutionTotals> totals;
  /// Real ones first, those that doubles find as stated before the others, then in a fixed order.
  std::vector<AssessedSolution> solutions;
  std::vector<AssessedCrossing> crossings;  ///< in the order met
  std::vector<AssessedCurve> curves;        ///< the edges of a graph whose nodes are the solutions
  Counts counts;
  std::vector<PathEnds> ends;   ///< of all paths
  std::vector<Motion> motions;  ///< beside the solutions, which are isolated then; figures in the file's unit
  std::vector<Figure> escaping;  ///< as in SolveReport, of nothing but points, in the file's unit
  std::vector<FailedCheck> failed_checks;
  std::optional<Proofs> proofs;  ///< empty unless asked for (see certify)

  /// Compiled once.
  Assessment();
  Assessment(const Assessment&);
  Assessment(Assessment&&) noexcept;
  Assessment& operator=(const Assessment&);
  Assessment& operator=(Assessment&&) noexcept;
  ~Assessment();
};

/// Assesses a report of any strategy; the report may be wrong in every way. Deterministic, whatever `threads` ≥ 1 is. Never
/// throws for a bad report: what is malformed is left out and becomes a failed check. A report that is handed over is given
/// up on the way, as it may be large. `errors_of`: proven errors, asked where some candidates are taken for the same.
Assessment assess(const Scene& scene, SolveReport report, int threads = 1, const ErrorsOf& errors_of = {});

/// Brings the counts that are determined in line with the list.
void recount(Assessment& assessment);

/// Keeps the real solutions, as stated or not, which come first. How many complex ones there are is not determined then.
void keep_real(Assessment& assessment);

/// Keeps the first `limit` solutions. Counts of solutions follow the list; crossings keep their place.
void keep_first(Assessment& assessment, std::size_t limit);

}  // namespace gcs
