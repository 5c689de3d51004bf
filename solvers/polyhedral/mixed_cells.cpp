#include "solvers/polyhedral/mixed_cells.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "solvers/polyhedral/cell_enumeration.hpp"

namespace gcs {
namespace {

constexpr int random_bits = 30;
/// A lifting is special with a probability near 1e-10 per linear program: a second one hardly ever is.
constexpr int most_liftings = 8;

/// How the origins that were added are lifted above the others, in units of 2^random_bits.
struct AddedOrigins {
  Lifting levels;  ///< 1 for them, 0 for other points
  std::int64_t height = 0;
};

Lifting random_lifting(const Supports& supports, std::mt19937_64& random) {
  Lifting lifting;
  for (const Support& support : supports) {
    std::vector<std::int64_t>& values = lifting.emplace_back();
    for (std::size_t c = 0; c < support.size(); ++c)
      values.push_back(static_cast<std::int64_t>(random() >> (64 - random_bits)));
  }
  return lifting;
}

Lifting raised(Lifting lifting, const AddedOrigins& origins) {
  for (std::size_t i = 0; i < lifting.size(); ++i)
    for (std::size_t c = 0; c < lifting[i].size(); ++c)
      lifting[i][c] += origins.levels[i][c] * (origins.height << random_bits);
  return lifting;
}

/// What the check of one cell says.
enum class CellVerdict { proved, unstable, wrong, too_large };

/// A cell with its normal for the levels of added origins, α₀, and that for the random lifting, α₁: for a
/// height h beyond all bounds the cell's normal is h·α₀ + α₁.
class CellProof {
 public:
  CellProof(const Supports& supports, const AddedOrigins& origins, const Lifting& lifting,
            const CellEdges& edges)
      : supports_(supports), origins_(origins), lifting_(lifting), edges_(edges) {}

  CellVerdict check() {
    coarse_ = exact_normal(supports_, origins_.levels, edges_);
    fine_ = exact_normal(supports_, lifting_, edges_);
    if (!coarse_ || !fine_) return CellVerdict::too_large;
    if (!others_are_higher()) return CellVerdict::wrong;
    const auto& numerators = coarse_->numerators;
    const bool is_stable = std::all_of(numerators.begin(), numerators.end(), [](auto x) { return x >= 0; });
    return is_stable ? CellVerdict::proved : CellVerdict::unstable;
  }

  /// Precondition: proved.
  MixedCell cell() const {
    MixedCell result{edges_, fine_->volume, {}};
    const double raise = static_cast<double>(origins_.height << random_bits);
    for (std::size_t v = 0; v < supports_.size(); ++v)
      result.normal.push_back(
          (raise * static_cast<double>(coarse_->numerators[v]) + static_cast<double>(fine_->numerators[v])) /
          static_cast<double>(fine_->volume));
    return result;
  }

 private:
  bool others_are_higher() const {
    for (int i = 0; i < static_cast<int>(supports_.size()); ++i)
      for (int c = 0; c < static_cast<int>(supports_[i].size()); ++c)
        if (c != edges_[i][0] && c != edges_[i][1] && !is_higher(i, c)) return false;
    return true;
  }

  bool is_higher(int i, int c) const {
    const int coarse = height_sign(supports_, origins_.levels, edges_, *coarse_, i, c);
    if (coarse != 0) return coarse > 0;
    return height_sign(supports_, lifting_, edges_, *fine_, i, c) > 0;
  }

  const Supports& supports_;
  const AddedOrigins& origins_;
  const Lifting& lifting_;
  const CellEdges& edges_;
  std::optional<ExactNormal> coarse_, fine_;
};

/// Whether all cells are proved; those that count are put into `result`.
CellVerdict prove(const std::vector<CellEdges>& found, const AddedOrigins& origins, const Lifting& lifting,
                  MixedCells& result) {
  for (const CellEdges& edges : found) {
    CellProof proof(result.supports, origins, lifting, edges);
    const CellVerdict verdict = proof.check();
    if (verdict == CellVerdict::wrong || verdict == CellVerdict::too_large) return verdict;
    if (verdict == CellVerdict::proved) result.cells.push_back(proof.cell());
  }
  return CellVerdict::proved;
}

MixedCells cells_of(const Supports& supports, AddedOrigins origins, const MixedCellOptions& options) {
  std::mt19937_64 random(options.seed);
  MixedCells result;
  result.supports = supports;
  while (result.liftings_tried < most_liftings) {
    ++result.liftings_tried;
    const Lifting lifting = random_lifting(supports, random);
    result.lifting = raised(lifting, origins);
    const EnumeratedCells found = enumerate_cells(supports, result.lifting, options.threads, options.stop);
    result.work += found.work;
    if (options.stop.stop_requested()) {
      result.status = MixedCellStatus::stopped;
      return result;
    }
    if (found.work.near_ties == 0) {
      const CellVerdict verdict = prove(found.cells, origins, lifting, result);
      if (verdict == CellVerdict::proved) return result;
      result.cells.clear();
      if (verdict == CellVerdict::too_large) {
        result.status = MixedCellStatus::too_large;
        return result;
      }
    }
    origins.height *= 4;  // the added origins may have been too low
  }
  result.status = MixedCellStatus::ties;
  return result;
}

AddedOrigins no_origins(const Supports& supports) {
  AddedOrigins origins;
  for (const Support& support : supports) origins.levels.emplace_back(support.size(), 0);
  return origins;
}

}  // namespace

Natural MixedCells::total_volume() const {
  Natural total;
  for (const MixedCell& cell : cells) total += Natural(static_cast<std::uint64_t>(cell.volume));
  return total;
}

MixedCells mixed_cells(const Supports& supports, const MixedCellOptions& options) {
  return cells_of(supports, no_origins(supports), options);
}

MixedCells stable_mixed_cells(const Supports& supports, const MixedCellOptions& options) {
  constexpr std::int64_t first_height = 64;
  Supports extended = supports;
  AddedOrigins origins = no_origins(supports);
  origins.height = first_height;
  const Exponents origin(supports.size(), 0);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    if (std::find(supports[i].begin(), supports[i].end(), origin) != supports[i].end()) continue;
    extended[i].push_back(origin);
    origins.levels[i].push_back(1);
  }
  return cells_of(extended, std::move(origins), options);
}

}  // namespace gcs
