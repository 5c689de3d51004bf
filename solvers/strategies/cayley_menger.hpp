#pragma once
/// What cayley_menger.cpp can be asked for: it has no options of its own.

#include "solvers/interface/options.hpp"

namespace gcs {

struct CayleyMenger {
  static constexpr std::string_view strategy = "cayley-menger";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};

  template <class Self, class Visitor>
  static void options(Self&, Visitor&&) {}
  bool operator==(const CayleyMenger&) const = default;
};

}  // namespace gcs
