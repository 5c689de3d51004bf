#pragma once
/// The median of repeated measurements and how far it can be trusted.

#include <vector>

namespace gcs {

/// `low` and `high` bound the true median with probability `confidence`, whatever the distribution of the
/// measurements: they are order statistics. Units are those of the measurements.
struct MedianInterval {
  double median = 0;
  double low = 0;
  double high = 0;
  double confidence = 0;

  /// Half the interval's width relative to the median; 0 when the median is.
  double relative_half_width() const { return median > 0 ? (high - low) / (2 * median) : 0; }
};

/// The narrowest symmetric pair of order statistics that reaches `wanted`, a probability. Too few
/// measurements cannot reach it (of 95 %, fewer than 6): then the interval is their whole range, and
/// `confidence` says what that is worth. Precondition: not empty.
MedianInterval median_interval(std::vector<double> measurements, double wanted = 0.95);

/// How many times as large one median is as another.
struct MedianRatio {
  double ratio = 0;
  double low = 0;
  double high = 0;
  double confidence = 0;  ///< that `low` and `high` bound the true ratio
};

/// The ratio of the medians of `after` and `before`, which lies between the quotients of the limits of their
/// intervals when both medians lie in these; each does with the square root of `wanted`. It supposes nothing
/// of the distributions but that they are independent. Precondition: neither is empty, and all are positive.
MedianRatio median_ratio(const std::vector<double>& before, const std::vector<double>& after, double wanted);

}  // namespace gcs
