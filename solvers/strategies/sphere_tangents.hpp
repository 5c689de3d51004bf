#pragma once
/// What sphere_tangents.cpp can be asked for.

#include "solvers/interface/options.hpp"
#include "solvers/tangents/published_tangents.hpp"

namespace gcs {

struct SphereTangents {
  enum class Method { direct, homotopy, published };

  static constexpr std::string_view strategy = "sphere-tangents";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  Method method = Method::direct;
  PublishedSystem system = PublishedSystem::quadrics;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("method", self.method, OneOf<Method>{"direct|homotopy|published"},
           "direct: eigenvalues; homotopy: paths of equations that coplanar centres keep; published: paths "
           "of `system`");
    option("system", self.system, OneOf<PublishedSystem>{"quadrics|cubic"},
           "with method=published; quadrics: the six equations; cubic: those of degrees 2, 3 and 4 in the "
           "direction");
  }
  bool operator==(const SphereTangents&) const = default;
};

}  // namespace gcs
