#include "harness/cli/certificates_view.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "harness/base/summary_line.hpp"

namespace gcs {
namespace {

std::string limit_text(const Proofs& proofs) {
  return fmt::format("the {} of {}", proofs.limit_is_exact ? "exact number" : "upper bound",
                     proofs.limit->decimal());
}

/// Whether so many proven classes, and those at infinity, are all there are; of some, mirror images are known to differ.
std::string completeness(const Proofs& proofs, std::uint64_t classes, std::uint64_t at_infinity = 0,
                         std::uint64_t with_image = 0) {
  if (!proofs.limit) return "found, not proven: no exact number and no upper bound is known";
  const std::string beyond = at_infinity > 0 ? fmt::format(" and {} at infinity", at_infinity) : "";
  if (proofs.meets_limit(classes + at_infinity))
    return fmt::format("proven: {} is met{}", limit_text(proofs),
                       beyond.empty() ? "" : fmt::format(" by {}{}", classes, beyond));
  if (proofs.meets_limit(classes + at_infinity, with_image))
    return fmt::format("proven: the upper bound of {} figures, mirror images counted apart, is met",
                       proofs.figure_limit->decimal());
  return fmt::format("found, not proven: {} certified{}, and {}", classes, beyond, limit_text(proofs));
}

/// Empty where each solution stands for itself.
std::string clusters_text(const Proofs& proofs) {
  const std::uint64_t undecided = proofs.clusters - proofs.multiple;
  if (undecided == 0 && proofs.in_clusters == proofs.clusters) return "";
  const std::string what =
      undecided == 0 ? ", as multiple ones"
      : proofs.multiple == 0
          ? ", that are not told apart"
          : fmt::format("; {} are multiple ones, the others are not told apart", proofs.multiple);
  return summary_line(
      "clusters",
      fmt::format("{} stand{} for {}, counted with multiplicities{}",
                  proofs.clusters == 1 ? "1 solution" : fmt::format("{} solutions", proofs.clusters),
                  proofs.clusters == 1 ? "s" : "", proofs.in_clusters, what));
}

/// Empty where no solution was looked for at infinity.
std::string infinity_text(const Proofs& proofs) {
  if (proofs.at_infinity == 0 && proofs.why_not_at_infinity.empty()) return "";
  std::string text =
      fmt::format("{} proven at infinity, simple there, and finite at lengths next to the given ones",
                  proofs.at_infinity);
  if (!proofs.why_not_at_infinity.empty()) text += "; not all: " + proofs.why_not_at_infinity;
  return summary_line("escaped", text);
}

}  // namespace

std::string certificates_text(const Proofs& proofs, std::size_t solutions, bool lists_all_complex) {
  if (proofs.why_none) return summary_line("certified", "nothing: " + *proofs.why_none);
  // Of more than are listed where the real ones alone are.
  const std::string listed = proofs.classes > solutions ? "" : fmt::format(" of {}", solutions);
  std::string text = summary_line(
      "certified", fmt::format("{}{} solutions exist, each in a class of its own, {} of them real; "
                               "proven in {} bits at most",
                               proofs.classes, listed, proofs.real, proofs.most_bits));
  text += clusters_text(proofs);
  text += infinity_text(proofs);
  if (lists_all_complex)
    text += summary_line("all complex", completeness(proofs, proofs.with_multiplicities(), proofs.at_infinity,
                                                     proofs.with_image));
  if (proofs.generic)
    text += summary_line("all generic", fmt::format("{} classes certified; {}", *proofs.generic,
                                                    completeness(proofs, *proofs.generic)));
  return text;
}

}  // namespace gcs
