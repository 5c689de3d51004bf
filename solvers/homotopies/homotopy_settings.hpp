#pragma once
/// How the strategies for all complex solutions follow their paths.

#include "solvers/interface/options.hpp"

namespace gcs {

struct HomotopySettings {
  enum class Precision { automatic, twice };
  enum class MirrorImages { divided, followed };
  enum class Instructions { automatic, portable, avx2, avx512 };
  static constexpr OneOf<Instructions> instruction_sets{"auto|portable|avx2|avx512"};

  int order = 12;
  double tolerance = 1e-6;
  Precision precision = Precision::automatic;
  MirrorImages mirror_images = MirrorImages::divided;
  Instructions instructions = Instructions::automatic;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor& option) {
    option("order", self.order, Range{4, 40}, "of the Taylor predictor");
    option("tolerance", self.tolerance, Range{1e-12, 1e-3},
           "error of a prediction, relative to how far the path goes until its series diverges");
    option("precision", self.precision, OneOf<Precision>{"auto|twice"},
           "twice: every path in about 106 bits; auto: where 53 do not suffice");
    option("mirror_images", self.mirror_images, OneOf<MirrorImages>{"divided|followed"},
           "followed: on the way to random lengths they are followed too, for the same solutions");
    option("instructions", self.instructions, instruction_sets,
           "SIMD instructions; the result does not depend on them", OptionTraits{.changes_result = false});
  }
  bool operator==(const HomotopySettings&) const = default;
};

}  // namespace gcs
