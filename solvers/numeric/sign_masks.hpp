#pragma once
/// Groups of sign changes of unknowns: reflections in the planes of a frame, half-turns about its axes, lines turned
/// over. An element of the group is a set of generators, a word of bits; it changes the sign of an unknown whose mask
/// has an odd number of these bits.

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace gcs {

using SignMask = std::uint64_t;

/// The masks of all unknowns. Bits are numbered from 0 up, without gaps where there are several.
class SignMasks {
 public:
  SignMasks() = default;
  explicit SignMasks(std::vector<SignMask> masks) : masks_(std::move(masks)) {}
  /// Independent generators: unknowns with the same number ≥ 0 change their signs together; −1: never.
  SignMasks(const std::vector<int>& groups);
  SignMasks(std::initializer_list<int> groups) : SignMasks(std::vector<int>(groups)) {}

  std::size_t size() const { return masks_.size(); }
  SignMask operator[](std::size_t unknown) const { return masks_[unknown]; }
  void push_back(SignMask mask) { masks_.push_back(mask); }
  auto begin() const { return masks_.begin(); }
  auto end() const { return masks_.end(); }

  /// The number of different sign patterns, a power of two, by its logarithm.
  int rank() const;
  /// The masks that unknowns have, each once, 0 first.
  std::vector<SignMask> kinds() const;
  /// Of each unknown, which of kinds() its mask is.
  std::vector<std::size_t> kind_numbers() const;

 private:
  std::vector<SignMask> masks_;
};

/// All generators that change the sign of an unknown.
SignMask generators_of(const SignMasks& masks);

/// Of all unknowns the signs, 1 or −1, that an element of the group gives them.
Eigen::VectorXd signs_by(const SignMasks& masks, SignMask element);

/// The signs of y0, 1 or −1, by an element of the group that is made of these generators, that bring it near to y:
/// generator by generator, lowest first, by the unknowns that no higher one changes. Coordinates beyond the masks keep
/// their signs.
Eigen::VectorXd signs_towards(const SignMasks& masks, SignMask generators, const Eigen::VectorXd& y0,
                              const Eigen::VectorXd& y);

/// y0 with the signs by which all generators bring it near to y.
Eigen::VectorXd turned_towards(const SignMasks& masks, const Eigen::VectorXd& y0, const Eigen::VectorXd& y);

/// Linear equations modulo 2: which elements of a group give these unknowns these signs.
class SignEquations {
 public:
  /// Whether elements are left that change the sign of an unknown of that mask, or that leave it.
  bool add(SignMask mask, bool changes);
  int rank() const { return static_cast<int>(rows_.size()); }

 private:
  struct Row {
    SignMask mask = 0;  ///< its lowest bit is in no other row
    bool changes = false;
  };
  std::vector<Row> rows_;
};

/// Whether an element of the group fits all unknowns. fits(i, sign): whether it may give unknown i the sign 1 or −1.
template <class Fits>
bool some_signs_fit(const SignMasks& masks, const Fits& fits) {
  SignEquations equations;
  for (std::size_t i = 0; i < masks.size(); ++i) {
    const bool stays = fits(i, 1.0), changes = masks[i] != 0 && fits(i, -1.0);
    if (!stays && !changes) return false;
    if (stays != changes && !equations.add(masks[i], changes)) return false;
  }
  return true;
}

}  // namespace gcs
