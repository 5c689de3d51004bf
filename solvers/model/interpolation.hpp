#pragma once
/// The interpolation functions a_i(t) of [I] Definition 1.

namespace gcs {

/// a(t) = −bend·t² + (at_target − at_sketch + bend)·t + at_sketch, in one unit of length; t has none.
/// bend = 0 is the linear interpolation.
struct LengthPath {
  double at_sketch = 0;
  double at_target = 0;
  double bend = 0;

  /// The form (1−t)·a_sk + t·a_so + bend·t·(1−t) is exact at t = 0 and t = 1.
  double value(double t) const { return (1 - t) * at_sketch + t * at_target + bend * t * (1 - t); }
  double slope(double t) const { return at_target - at_sketch + bend * (1 - 2 * t); }
};

}  // namespace gcs
