#include "harness/results/median_interval.hpp"

#include <algorithm>
#include <cmath>

namespace gcs {
namespace {

/// P(at most k of n measurements lie below the median), in logarithms so that large n do not underflow.
double binomial_tail(int n, int k) {
  double sum = 0;
  for (int i = 0; i <= k; ++i) {
    sum +=
        std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) - n * std::log(2.0));
  }
  return sum;
}

/// Probability that the median lies between the measurements of rank k and n − 1 − k, counted from 0.
double coverage(int n, int k) { return 1 - 2 * binomial_tail(n, k); }

double middle(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

}  // namespace

MedianInterval median_interval(std::vector<double> measurements, double wanted) {
  std::sort(measurements.begin(), measurements.end());
  const int n = static_cast<int>(measurements.size());
  int k = 0;
  while (2 * (k + 1) < n && coverage(n, k + 1) >= wanted) ++k;
  return {middle(measurements), measurements[k], measurements[n - 1 - k], std::max(0.0, coverage(n, k))};
}

MedianRatio median_ratio(const std::vector<double>& before, const std::vector<double>& after, double wanted) {
  const double of_each = std::sqrt(wanted);
  const MedianInterval first = median_interval(before, of_each);
  const MedianInterval second = median_interval(after, of_each);
  return {second.median / first.median, second.low / first.high, second.high / first.low,
          first.confidence * second.confidence};
}

}  // namespace gcs
