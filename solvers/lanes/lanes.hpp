#pragma once
/// Several doubles side by side, as wide as the instruction set of the translation unit has them. Every
/// operation acts lane by lane and rounds as the scalar one, and `fused` is one rounding on every machine, so
/// a lane's bits depend neither on the width nor on what the other lanes hold.
///
/// A translation unit that is compiled for another instruction set defines GCS_LANES as a name of its own
/// before it includes this, so that no two units share code that was compiled differently.

#include <cmath>
#if defined(__AVX2__) || defined(__AVX512F__)
#include <immintrin.h>
#endif

#include "solvers/numeric/double_double.hpp"

#ifndef GCS_LANES
#define GCS_LANES portable_lanes
#endif

namespace gcs::GCS_LANES {

#if defined(__AVX512F__)
inline constexpr int native_lanes = 8;
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr int native_lanes = 4;
#else
inline constexpr int native_lanes = 2;
#endif

struct Lanes {
  static constexpr int count = native_lanes;
  using Vector [[gnu::vector_size(native_lanes * sizeof(double))]] = double;

  Vector v = {};

  double lane(int i) const { return v[i]; }
  void set_lane(int i, double value) { v[i] = value; }
};

inline Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
inline Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
inline Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
inline Lanes operator/(Lanes a, Lanes b) { return {a.v / b.v}; }
inline Lanes operator-(Lanes a) { return {-a.v}; }

/// a·b + c with one rounding.
inline Lanes fused(Lanes a, Lanes b, Lanes c) {
#if defined(__AVX512F__)
  return {_mm512_fmadd_pd(a.v, b.v, c.v)};
#elif defined(__AVX2__) && defined(__FMA__)
  return {_mm256_fmadd_pd(a.v, b.v, c.v)};
#else
  Lanes r;
  for (int i = 0; i < Lanes::count; ++i) r.v[i] = std::fma(a.v[i], b.v[i], c.v[i]);
  return r;
#endif
}

/// c − a·b with one rounding.
inline Lanes fused_minus(Lanes a, Lanes b, Lanes c) {
#if defined(__AVX512F__)
  return {_mm512_fnmadd_pd(a.v, b.v, c.v)};
#elif defined(__AVX2__) && defined(__FMA__)
  return {_mm256_fnmadd_pd(a.v, b.v, c.v)};
#else
  return fused(-a, b, c);
#endif
}

inline Lanes absolute(Lanes a) { return {a.v < 0 ? -a.v : a.v}; }
/// The larger, and `b` where `a` is not a number.
inline Lanes larger(Lanes a, Lanes b) { return {a.v > b.v ? a.v : b.v}; }
/// `a` where `mask` is not 0, else `b`.
inline Lanes selected(Lanes mask, Lanes a, Lanes b) { return {mask.v != 0 ? a.v : b.v}; }
inline Lanes constant(double value, Lanes) { return {value - Lanes::Vector{}}; }
/// 1 where a < b, else 0.
inline Lanes is_less(Lanes a, Lanes b) { return {a.v < b.v ? constant(1, {}).v : Lanes::Vector{}}; }

/// (u − v) − difference exactly, for the rounded difference.
inline Lanes lost(Lanes u, Lanes v, Lanes difference) {
  const Lanes t = difference - u;
  return (u - (difference - t)) - (v + t);
}

template <class Real>
struct Compensated;

/// A sum kept in two numbers, for residuals that cancel.
template <>
struct Compensated<Lanes> {
  Lanes high;
  Lanes low;

  /// Adds a exactly, but for the rounding of `low`.
  void add(Lanes a) {
    const Lanes s = high + a;
    const Lanes t = s - high;
    low = low + ((high - (s - t)) + (a - t));
    high = s;
  }
  /// Adds a·b likewise.
  void add_product(Lanes a, Lanes b) {
    const Lanes p = a * b;
    low = low + fused(a, b, -p);
    add(p);
  }
  Lanes value() const { return high + low; }
};

/// Numbers of about 106 bits in the place of doubles: for paths that doubles cannot follow.
struct Wide {
  static constexpr int count = Lanes::count;

  Doubled<Lanes> v;

  double lane(int i) const { return v.hi.lane(i); }
  void set_lane(int i, double value) {
    v.hi.set_lane(i, value);
    v.lo.set_lane(i, 0);
  }
};

inline Wide operator+(Wide a, Wide b) { return {a.v + b.v}; }
inline Wide operator-(Wide a, Wide b) { return {a.v - b.v}; }
inline Wide operator*(Wide a, Wide b) { return {a.v * b.v}; }
inline Wide operator/(Wide a, Wide b) { return {a.v / b.v}; }
inline Wide operator-(Wide a) { return {-a.v}; }
inline Wide fused(Wide a, Wide b, Wide c) { return a * b + c; }
inline Wide fused_minus(Wide a, Wide b, Wide c) { return c - a * b; }
/// `a` where `mask` is not 0, else `b`.
inline Wide selected(Lanes mask, Wide a, Wide b) {
  return {{selected(mask, a.v.hi, b.v.hi), selected(mask, a.v.lo, b.v.lo)}};
}
inline Wide selected(Wide mask, Wide a, Wide b) { return selected(mask.v.hi, a, b); }
inline Wide absolute(Wide a) { return selected(is_less(a.v.hi, {}), -a, a); }
inline Wide larger(Wide a, Wide b) { return selected(is_less(b.v.hi, a.v.hi), a, b); }
inline Wide constant(double value, Wide) { return {{constant(value, Lanes{}), {}}}; }
inline Wide lost(Wide, Wide, Wide) { return {}; }

template <>
struct Compensated<Wide> {
  Wide high;
  Wide low;

  void add(Wide a) { high = high + a; }
  void add_product(Wide a, Wide b) { high = high + a * b; }
  Wide value() const { return high + low; }
};

}  // namespace gcs::GCS_LANES
