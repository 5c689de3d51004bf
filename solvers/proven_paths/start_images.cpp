#include "solvers/proven_paths/start_images.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace gcs {
namespace {

constexpr SignMask all_turnings = ~(first_turning - 1);

/// 1 or −1, as the form changes; 0: neither.
int sign_of(const EnclosedForm& form, const Eigen::VectorXd& signs) {
  int sign = form.constant != 0 || form.constant_error != 0 || form.terms.empty() ? 1 : 0;
  for (const EnclosedForm::Term& term : form.terms) {
    const int of_term = signs[term.coordinate] > 0 ? 1 : -1;
    if (sign != 0 && sign != of_term) return 0;
    sign = of_term;
  }
  return sign;
}

bool has_value(const EnclosedLength& length) {
  return length.path.at_sketch != 0 || length.path.at_target != 0 || length.sketch_error != 0 ||
         length.target_error != 0;
}

}  // namespace

StartImages::StartImages(PathEquations equations, PathData data, SignMasks turnings)
    : equations_(std::move(equations)),
      data_(std::move(data)),
      turnings_(std::move(turnings)),
      known_as_box_(0, equations_.coordinates()) {
  SignMask used = 0;
  for (const SignMask mask : turnings_) used |= mask & all_turnings;
  for (; used != 0; used &= used - 1) generators_.push_back(used & (~used + 1));
}

/// By the unknowns that no other generator changes.
StartImages::Possible StartImages::possible(SignMask generator, const Eigen::VectorXd& centre,
                                            const Eigen::VectorXd& extent) const {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  Possible result;
  for (std::size_t i = 0; i < turnings_.size(); ++i) {
    if ((turnings_[i] & all_turnings) != generator) continue;
    const auto k = static_cast<Eigen::Index>(i);
    const double at = data_.start.mid[k];
    const double reach =
        (data_.start.radius[k] + extent[k] + rounding * (std::abs(at) + std::abs(centre[k]))) * round_up;
    result.stays = result.stays && std::abs(at - centre[k]) <= reach;
    result.turns = result.turns && std::abs(at + centre[k]) <= reach;
  }
  return result;
}

Eigen::VectorXd StartImages::signs(SignMask turned) const {
  Eigen::VectorXd result = Eigen::VectorXd::Ones(equations_.coordinates());
  for (std::size_t i = 0; i < turnings_.size(); ++i)
    if (std::popcount(turnings_[i] & turned) % 2 == 1) result[static_cast<Eigen::Index>(i)] = -1;
  return result;
}

bool StartImages::is_symmetric(const Eigen::VectorXd& signs) const {
  std::vector<int> of_equation(static_cast<std::size_t>(equations_.count), 0);
  for (const auto& [e, value, moved] : equations_.pairs) {
    const int sign = sign_of(equations_.forms[static_cast<std::size_t>(value)], signs) *
                     sign_of(equations_.forms[static_cast<std::size_t>(moved)], signs);
    int& common = of_equation[static_cast<std::size_t>(e)];
    if (sign == 0 || (common != 0 && common != sign)) return false;
    if (sign < 0 && has_value(data_.lengths[static_cast<std::size_t>(e)])) return false;
    common = sign;
  }
  return true;
}

PlaceInTube StartImages::locate(const PathTube& tube) const {
  if (generators_.empty()) return tube.locate(data_.start, known_as_box_);
  const Eigen::VectorXd centre = tube.curve().coefficient(0), extent = tube.extent();
  SignMask turned = 0;
  for (const SignMask generator : generators_) {
    const Possible here = possible(generator, centre, extent);
    if (here.stays && here.turns) return {PlaceInTube::Kind::unknown, {}};
    if (!here.stays && !here.turns) return {PlaceInTube::Kind::outside, {}};
    if (here.turns) turned |= generator;
  }
  const Eigen::VectorXd by = signs(turned);
  const PlaceInTube place =
      tube.locate({data_.start.mid.cwiseProduct(by), data_.start.radius}, known_as_box_);
  if (place.kind == PlaceInTube::Kind::inside && !is_symmetric(by))
    return {PlaceInTube::Kind::unknown, place.s};
  return place;
}

}  // namespace gcs
