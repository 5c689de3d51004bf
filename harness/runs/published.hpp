#pragma once
/// The figures that papers print (results/published/*.json): compared with, never used by a strategy.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gcs {

/// Why a published figure is known to be wrong, or does not come out, and on whose authority.
struct Correction {
  std::string reason;
  std::string source;
  bool is_proof = true;  ///< false: it does not come out, whatever was tried
};

/// One printed figure. `place` is "table 1"; `row` says what it is; `by` is the method, empty where there is
/// none.
struct PrintedFigure {
  std::string place;
  std::string row;
  std::string instance;
  std::string by;
  std::string convention;
  double value = 0;     ///< seconds, milliseconds or plain numbers, as the row says
  std::string printed;  ///< as the paper prints it, with its unit
  std::string remark;   ///< what a reader should know when comparing; may be empty
  std::string chosen;   ///< why our instance says nothing of the paper's: it was chosen to agree; else empty
  /// The most that was known of the graph, at other lengths than the instance's.
  bool at_least = false;
  std::optional<Correction> correction;
};

/// A point by its name, coordinates as the paper prints them.
struct PrintedPoint {
  std::string name;
  std::array<std::string, 3> printed;
};

/// One printed solution. `corrected` holds the points that a known misprint has wrong.
struct PrintedSolution {
  std::string place;
  std::string instance;
  int number = 0;
  std::vector<PrintedPoint> points;
  std::vector<PrintedPoint> corrected;
  std::optional<Correction> correction;
};

struct Publication {
  std::string source;  ///< short name, as instances cite it
  std::string citation;
  std::string machine;                                  ///< on which the times were taken
  std::map<std::string, std::string> instance_remarks;  ///< what our instance differs in
  std::vector<PrintedFigure> figures;
  std::vector<PrintedSolution> solutions;  ///< in the paper's order

  /// The figure, or nullptr when the paper prints none.
  const PrintedFigure* find(const std::string& place, const std::string& row, const std::string& instance,
                            const std::string& by) const;
};

/// Reads results/published/<source>.json below the current folder, else where the program was built.
/// Throws InputError.
Publication load_publication(const std::string& source);

/// Reads the text of such a file; `file` is for messages. Throws InputError.
Publication parse_publication(const std::string& text, const std::string& file);

}  // namespace gcs
