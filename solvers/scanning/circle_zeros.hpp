#pragma once
/// Where a function of the points of a circle is 0: pieces of the circle.

#include <numbers>

#include "solvers/numeric/affine_form.hpp"
#include "solvers/scanning/piece.hpp"

namespace gcs {

/// What the angles of the plan say of the angle on the circle is solved to first order, so that a piece follows a branch;
/// near a branch end, where they say little, pieces are as short as the cell is narrow. `Excess`: a form of a position.
template <int N, class Excess>
class CircleZeros {
 public:
  using Form = AffineForm<N>;

  /// `symbol`: one of the forms' that is not in use.
  CircleZeros(const FormCircle<N>& circle, const Excess& excess, int symbol)
      : circle_(circle), excess_(excess), symbol_(symbol) {}

  /// At angles in `within` or, where it is not given, on all of the circle.
  std::vector<Piece<N>> pieces(const std::optional<Choice>& within) {
    if (within) {
      search(*within);
    } else {
      search({0, -std::numbers::pi, 0});
      search({0, 0, std::numbers::pi});
    }
    return std::move(list_);
  }

 private:
  void search(Choice range) {
    for (;;) {
      const double half = (range.high - range.low) / 2;
      Form phi((range.low + range.high) / 2);
      phi.slope[symbol_] = half;
      const Form excess = excess_(circle_.at(phi));
      if (!excess.contains_zero()) return;
      Form branch(phi.mid);
      branch.rest = half * (1 + 4 * Form::epsilon);
      const double own = std::abs(excess.slope[symbol_]);
      if (own > excess.reach() - own + excess.rest) {
        branch = solved(phi, half, excess);
        const Choice part{0, std::max(range.low, branch.low()), std::min(range.high, branch.high())};
        if (!(part.low <= part.high)) return;
        const bool is_narrower = part.high - part.low <= narrowed * 2 * half;
        range = part;
        if (branch.rest <= tight * (branch.reach() + fine)) return append(branch, range);
        if (is_narrower) continue;
      }
      const double unavoidable = excess_(circle_.at(Form(phi.mid))).radius();
      if (excess.radius() <= short_enough * unavoidable || half <= fine) return append(branch, range);
      const double middle = (range.low + range.high) / 2;
      search({0, range.low, middle});
      range.low = middle;
    }
  }

  /// excess = 0 solved for the symbol of φ = mid + half ξ. Precondition: it depends on it.
  Form solved(const Form& phi, double half, const Form& excess) const {
    Form others = excess;
    others.slope[symbol_] = 0;
    const Form xi = (-1 / excess.slope[symbol_]) * others;
    return half * xi + phi.mid;
  }

  void append(const Form& phi, const Choice& part) {
    list_.push_back({circle_.at(phi), {circle_.squared_radius}, part, {}});
  }

  static constexpr double tight = 0.1;     ///< of the branch's own slope: narrower is not worth another pass
  static constexpr double narrowed = 0.7;  ///< less progress than this is left to smaller cells
  static constexpr double short_enough = 6;  ///< a shorter piece would know little more, for the cell's sake
  static constexpr double fine = 1e-13;      ///< radians: rounding is not far below

  const FormCircle<N>& circle_;
  const Excess& excess_;
  int symbol_;
  std::vector<Piece<N>> list_;
};

}  // namespace gcs
