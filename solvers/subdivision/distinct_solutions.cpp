#include "solvers/subdivision/distinct_solutions.hpp"

#include <algorithm>

namespace gcs {
namespace {

constexpr double rounded_out = 1 + 0x1p-50;

bool lies_where_unique(const Box& box, const ProvenSolution& known) {
  const Eigen::ArrayXd apart = (box.mid - known.enclosure.mid).cwiseAbs().array();
  return ((apart + box.radius.array()) * rounded_out <= known.unique.array()).all();
}

bool misses(const Box& box, const Box& other) {
  const Eigen::ArrayXd apart = (box.mid - other.mid).cwiseAbs().array();
  return (apart > (box.radius + other.radius).array() * rounded_out).any();
}

enum class Likeness { same, different, open };

Likeness likeness(const Box& box, const ProvenSolution& known, const std::vector<Eigen::VectorXd>& signs) {
  bool is_apart = true;
  for (const Eigen::VectorXd& sign : signs) {
    const Box image{box.mid.cwiseProduct(sign), box.radius};
    if (lies_where_unique(image, known)) return Likeness::same;
    is_apart = is_apart && misses(image, known.enclosure);
  }
  return is_apart ? Likeness::different : Likeness::open;
}

}  // namespace

std::vector<Eigen::VectorXd> mirror_signs(const SignMasks& mirror) {
  const auto n = static_cast<Eigen::Index>(mirror.size());
  std::vector<Eigen::VectorXd> result{Eigen::VectorXd::Ones(n)};
  for (const SignMask kind : mirror.kinds()) {
    if (kind == 0) continue;
    const std::size_t known = result.size();
    for (std::size_t i = 0; i < known; ++i) {
      Eigen::VectorXd signs = result[i];
      for (Eigen::Index unknown = 0; unknown < n; ++unknown)
        if (mirror[static_cast<std::size_t>(unknown)] == kind) signs[unknown] *= -1;
      result.push_back(std::move(signs));
    }
  }
  return result;
}

DistinctSolutions distinct_solutions(const std::vector<ProvenSolution>& found, const SignMasks& mirror) {
  const std::vector<Eigen::VectorXd> signs = mirror_signs(mirror);
  DistinctSolutions result;
  for (const ProvenSolution& solution : found) {
    bool is_known = false, is_open = false;
    for (const ProvenSolution& known : result.list) {
      const Likeness to_known = likeness(solution.enclosure, known, signs);
      is_known = is_known || to_known == Likeness::same;
      is_open = is_open || to_known == Likeness::open;
    }
    if (is_known) continue;
    if (is_open)
      result.undecided.push_back(solution.enclosure);
    else
      result.list.push_back(solution);
  }
  return result;
}

}  // namespace gcs
