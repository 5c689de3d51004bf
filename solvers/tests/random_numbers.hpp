#pragma once
/// Random numbers that are the same with every standard library.

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace gcs::samples {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  /// In 0, …, count − 1.
  int index(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  int sign() { return (engine_() >> 40U & 1U) != 0 ? 1 : -1; }
  /// Coordinates in [−size, size), z = 0 in the plane.
  Eigen::Vector3d point(int dimension, double size) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < dimension; ++axis) result[axis] = uniform(-size, size);
    return result;
  }
  Eigen::Matrix3Xd points(int dimension, int count, double size) {
    Eigen::Matrix3Xd result(3, count);
    for (int i = 0; i < count; ++i) result.col(i) = point(dimension, size);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace gcs::samples
