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

/// The narrowest symmetric pair of order statistics that reaches 95 %. Fewer than 6 measurements cannot reach
/// it: then the interval is their whole range, and `confidence` says what that is worth. Precondition: not
/// empty.
MedianInterval median_interval(std::vector<double> measurements);

}  // namespace gcs
