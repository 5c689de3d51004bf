#pragma once
/// The simple real solutions next to figures that are solutions to rounding and nearly singular, by the file's own numbers.
/// With residuals in doubles ends beside a multiple solution look like stiff simple ones, and simple ones on both sides of a
/// fold like a multiple one.

#include <optional>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

class ProvenNeighbours {
 public:
  /// The scene outlives this.
  explicit ProvenNeighbours(const Scene& scene) : scene_(scene) {}

  /// All that are proven, with their errors. Those next to a place are looked for once, which takes milliseconds to seconds,
  /// most where there is none.
  const std::vector<Candidate>& of(const Figure& figure);
  /// At least how far a stiff figure is from a solution: one that it is itself, but for rounding. Infinite where none is
  /// proven, and for scenes of elements.
  double error_of(const Figure& figure) const;
  /// The nearest of these.
  std::optional<Candidate> nearest(const Figure& figure);
  /// At how many places none was found.
  int in_vain() const { return in_vain_; }
  /// Whether these are so many that other singular points are taken to be next to none, too, as in a scene that moves.
  bool is_hopeless() const { return in_vain_ >= most_in_vain; }

 private:
  static constexpr int most_in_vain = 2;

  std::size_t place_of(const Figure& representative) const;

  const Scene& scene_;
  std::vector<Figure> places_;  ///< representatives
  std::vector<std::vector<Candidate>> solutions_;
  int in_vain_ = 0;
};

}  // namespace gcs
