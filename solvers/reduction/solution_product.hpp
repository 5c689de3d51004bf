#pragma once
/// The solutions of a scene from those of its parts: one solution of each part, and for each part one of two
/// sides of its base; a class up to reflection is half of these, since changing all sides mirrors the whole.
///
/// They are counted without being listed: what depends on a choice (where a point hangs on points at no given
/// distance) is counted for each, and what does not hang together is multiplied (recursive conditioning;
/// Darwiche 2001). They are listed one after another, as far as asked for.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/numeric/natural.hpp"
#include "solvers/reduction/hung_point.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// One class of solutions of a part.
struct PartSolution {
  /// Of the points that the part places: their coordinates in the base; in the first part their positions.
  std::vector<Eigen::Vector3cd> points;
  std::vector<ComplexLine> lines{};  ///< in the first part
  bool is_real = false;
  bool is_flat = false;   ///< it is its own mirror image
  bool is_stiff = false;  ///< so ill-conditioned that the error of a figure with it has to be proven
  double condition = 1;   ///< of the part's equations there; 1 for a hung point
  int multiplicity = 1;
};

class SolutionProduct {
 public:
  /// `solved`: of each part its solutions, nothing for hung points, which are placed here. Keeps references
  /// to scene and parts.
  SolutionProduct(const Scene& scene, const std::vector<Part>& parts,
                  std::vector<std::vector<PartSolution>> solved);

  /// How many classes there are, real ones or all; nothing when that takes too long to find out.
  std::optional<Natural> count(bool only_real);
  /// So many of the real ones, or of the others, at most; in the scene's unit.
  std::vector<Candidate> list(bool real, std::size_t limit);
  /// Sentences about points that could not be placed, and about what took too long, each once. What is
  /// counted and listed is without them.
  const std::vector<std::string>& undecided() const { return undecided_; }

 private:
  struct Choice {
    int solution = -1;  ///< −1: not chosen
    int side = 1;
    bool operator==(const Choice&) const = default;
  };
  /// A class has the weight 2 for its two sides, 1 when it is flat; or only flat ones count.
  enum class Weighing { sides, flat_only };

  void leave_out_collinear_bases();
  void find_dependences();
  bool is_inside(const std::vector<int>& points, int part) const;
  int last_home(const std::vector<int>& points) const;
  const std::vector<PartSolution>& solutions(int part);
  std::vector<PartSolution> placed(int part, const HungPlace& place);
  Simplex measured_base(int part);
  /// Of a hung point, as far as one part tells, by the file's own numbers.
  std::optional<MeasuredSquares> proven_base(int part);
  Simplex positions_in_part(int part, const std::vector<int>& points);
  void place(int part);

  Natural weigh(const std::vector<int>& open, bool only_real, Weighing weighing);
  Natural weigh_connected(const std::vector<int>& open, bool only_real, Weighing weighing);
  std::vector<std::vector<int>> connected(const std::vector<int>& open) const;

  void list_from(int part, bool has_complex, bool has_side);
  bool may_become_complex(int from);
  Candidate candidate(bool is_real) const;
  Figure framed(const Figure& figure, bool is_stiff) const;
  void note(const std::string& sentence);
  bool is_exhausted();

  const Scene& scene_;
  const std::vector<Part>& parts_;
  std::vector<DoubleDouble> squares_;  ///< of the target lengths
  BasePlacer placer_;
  std::vector<std::vector<PartSolution>> solutions_;  ///< of dependent parts: at `placed_at_`
  std::vector<int> home_;                             ///< of each point, the part that places it
  std::vector<std::vector<int>> depends_on_;          ///< of each part, ascending
  std::vector<bool> is_across_;     ///< of each part: it hangs on points of several parts, whose sides matter
  std::vector<bool> side_matters_;  ///< of each part
  /// Of each part: the choices it depends on, when it was placed.
  std::vector<std::vector<Choice>> placed_at_;
  std::vector<Choice> choices_;
  Simplex positions_;  ///< of all points, as chosen
  std::vector<std::string> undecided_;

  std::int64_t visits_ = 0;
  std::size_t limit_ = 0;
  bool lists_complex_ = false;
  std::vector<Candidate> listed_;
};

}  // namespace gcs
