#pragma once
/// What is known of a problem before it is solved: each found when it is first asked for, and once.

#include <mutex>
#include <optional>
#include <vector>

#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/structure/decomposition.hpp"

namespace gcs {

/// May be asked from any thread. The problem outlives it.
class SceneAnalysis {
 public:
  explicit SceneAnalysis(const ProblemStatement& problem) : problem_(problem) {}

  /// See decompose.
  const std::vector<Part>& parts(Split split) const {
    OnceFound<std::vector<Part>>& found = split == Split::all ? all_parts_ : hung_points_;
    return found.get([&] { return decompose(problem_, split); });
  }

  /// See element_order.
  const std::optional<ElementOrder>& order() const {
    return order_.get([&] { return element_order(Scene::unchecked(problem_)); });
  }

  const TheoreticalCounts& counts() const {
    return counts_.get([&] {
      return problem_.is_general() ? theoretical_counts(problem_, order())
                                   : theoretical_counts(problem_, parts(Split::all));
    });
  }

 private:
  template <typename T>
  class OnceFound {
   public:
    template <typename Find>
    const T& get(Find find) {
      std::call_once(once_, [&] { value_ = find(); });
      return *value_;
    }

   private:
    std::once_flag once_;
    std::optional<T> value_;
  };

  const ProblemStatement& problem_;
  mutable OnceFound<std::vector<Part>> all_parts_, hung_points_;
  mutable OnceFound<std::optional<ElementOrder>> order_;
  mutable OnceFound<TheoreticalCounts> counts_;
};

}  // namespace gcs
