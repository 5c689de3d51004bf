#pragma once
/// How many classes of solutions a search has not seen, by estimate.

#include <cstdint>
#include <optional>

namespace gcs {

/// w (w + 1) / (n − w − 2), where n finds, each of a class at random, are of w classes and nothing was known of the classes
/// beforehand (Boender, Rinnooy Kan, Bayesian stopping rules for multistart global optimization methods, 1987); nothing
/// where the finds are too few to tell. It proves nothing: a class that is hardly ever found is missed.
inline std::optional<double> unseen_classes(std::int64_t finds, std::int64_t classes) {
  const double n = static_cast<double>(finds), w = static_cast<double>(classes);
  return n > w + 2 ? std::optional(w * (w + 1) / (n - w - 2)) : std::nullopt;
}

}  // namespace gcs
