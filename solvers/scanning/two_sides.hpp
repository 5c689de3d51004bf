#pragma once
/// Where a sphere meets further surfaces on two sides: by Newton's method, by the closed formula, or near a branch end by
/// the height.

#include "solvers/scanning/piece.hpp"

namespace gcs {

/// The pieces of a point on D surfaces in D dimensions, the first a sphere.
template <std::size_t D, int N>
class TwoSides {
 public:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;
  using Surfaces = std::array<FormSurface<N>, D>;

  /// Keeps references. `placed`: positions that a piece has an effect on, some of them 0 perhaps.
  TwoSides(const Surfaces& surfaces, const std::vector<Position>& placed)
      : surfaces_(surfaces), placed_(placed) {}

  /// `within` restricts to a piece found on a larger cell; `only_upper`: the side of +1 alone.
  Pieces<N> pieces(const std::optional<Choice>& within, bool only_upper) {
    const SidePlacing<D, N> placing(surfaces_);
    Pieces<N> pieces;
    for (const int side : {1, -1}) {
      if (side < 0 && only_upper) continue;
      if (within && within->side != side) continue;
      const auto point = placing.verified(side);
      Piece<N> piece{point.value_or(Position{}), {}, {side}, {}};
      const bool has_range = within && within->is_range();
      if (!point || has_range) {
        if (!meeting_) meeting_ = Meeting{room_to_meet(surfaces_), meet(surfaces_)};
        if (!take_heights(has_range ? &*within : nullptr, piece)) continue;
        if (!point && !meeting_->both) return {{}, meeting_->room};
        if (!point && !place_near_end(piece)) continue;
      }
      pieces.list.push_back(std::move(piece));
    }
    return pieces;
  }

 private:
  /// How the surfaces meet on both sides, by the closed formula.
  struct Meeting {
    Form room;  ///< room_to_meet: the square of what a range of heights is of
    std::optional<TwoPositions<N>> both;
  };

  /// Restricts the piece to heights that the room and `within`, if given, leave. False where there are none.
  bool take_heights(const Choice* within, Piece<N>& piece) const {
    const Form& room = meeting_->room;
    if (room.high() <= 0) return false;
    piece.exists.push_back(room);
    piece.choice.low = std::sqrt(std::max(0.0, room.low()));
    piece.choice.high = std::sqrt(room.high());
    if (within == nullptr) return true;
    piece.choice.low = std::max(piece.choice.low, within->low);
    piece.choice.high = std::min(piece.choice.high, within->high);
    piece.exists.push_back(room + -within->low * within->low);
    piece.exists.push_back(-room + within->high * within->high);
    return !(piece.choice.low > piece.choice.high);
  }

  /// By the closed formula or, where that leaves less unknown, by the height. False where there is no point.
  bool place_near_end(Piece<N>& piece) const {
    const TwoPositions<N>& both = *meeting_->both;
    if (both.discriminant.high() <= 0) return false;
    piece.exists.push_back(both.discriminant);
    piece.position = both.on(piece.choice.side);
    const auto rough = angle_by_height(piece);
    if (!rough) return true;
    const Form height = piece.choice.side * ranging(piece.choice, rough->exchange.symbol);
    const PointByHeight<N> sharp = HeightPlacing<D, N>(surfaces_).sharpened(*rough, both.offset, height);
    if (!sharp.is_worth_it(placed_, piece.position)) return true;
    piece.position = sharp.position;
    piece.exchange = sharp.exchange;
    return true;
  }

  /// The middle of the range and as much of the symbol as reaches its ends.
  static Form ranging(const Choice& range, int symbol) {
    Form form(range.mid());
    form.slope[symbol] = range.half();
    form.rest = 4 * Form::epsilon * std::max(std::abs(range.low), std::abs(range.high));
    return form;
  }

  /// room = height² solved for the symbol on which the room depends most. Nothing where it depends on none,
  /// or the range is a point.
  std::optional<PointByHeight<N>> angle_by_height(const Piece<N>& piece) const {
    const Form& room = meeting_->room;
    const auto is_less = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto most = std::max_element(room.slope.begin(), room.slope.end(), is_less);
    if (*most == 0 || !piece.choice.is_range()) return std::nullopt;
    const int symbol = static_cast<int>(most - room.slope.begin());
    Form others = room;
    others.slope[symbol] = 0;
    Form value = (1 / *most) * (square(ranging(piece.choice, symbol)) - others);
    if (!(std::abs(value.mid) + value.radius() <= 1)) {
      value = Form();
      value.rest = 1;  // all that a symbol can be
    }
    const Exchange<N> exchange{symbol, value};
    return PointByHeight<N>{exchange.of(piece.position), exchange};
  }

  const Surfaces& surfaces_;
  const std::vector<Position>& placed_;
  std::optional<Meeting> meeting_;  ///< once asked for
};

}  // namespace gcs
