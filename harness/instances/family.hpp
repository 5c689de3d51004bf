#pragma once
/// A family of instances that grow stiff or extreme with a parameter.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gcs {

struct InstanceFamily {
  std::string_view name;
  std::string_view summary;         ///< what becomes of the scene, and what the parameter is
  std::vector<std::string> values;  ///< of the parameter, the tame one first
  /// The text of an instance with this id.
  std::string (*text)(const std::string& id, const std::string& value) = nullptr;
  /// Values at which the solutions are not isolated, or none is regular: to say so is right there.
  std::vector<std::string> ill_posed = {};
  /// Complex solutions by theory, in the scene's convention; 0: what theoretical_counts says.
  std::uint64_t solutions = 0;
  std::uint64_t solutions_at_zero = 0;  ///< likewise at the value 0, where the convention is another one

  /// The ids of the members: "flat-triangle@1e-8".
  std::vector<std::string> members() const;
};

}  // namespace gcs
