#pragma once
/// What sphere_tangents.cpp can be asked for.

#include "solvers/interface/options.hpp"

namespace gcs {

struct SphereTangents {
  enum class Method { direct, homotopy };

  static constexpr std::string_view strategy = "sphere-tangents";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Method method = Method::direct;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("method", self.method, OneOf<Method>{"direct|homotopy"},
           "direct: eigenvalues; homotopy: 24 paths, as published");
  }
  bool operator==(const SphereTangents&) const = default;
};

}  // namespace gcs
