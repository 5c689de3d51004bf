#pragma once
/// A family of instances that grow stiff or extreme with a parameter.

#include <string>
#include <string_view>
#include <vector>

namespace gcs {

struct InstanceFamily {
  std::string_view name;
  std::string_view summary;         ///< what becomes of the scene, and what the parameter is
  std::vector<std::string> values;  ///< of the parameter, the tame one first
  /// The text of gcsbench-instance/1 with this id.
  std::string (*text)(const std::string& id, const std::string& value) = nullptr;
  /// Values at which the solutions are not isolated, or none is regular: to say so is right there.
  std::vector<std::string> ill_posed = {};

  /// The ids of the members: "flat-triangle@1e-8".
  std::vector<std::string> members() const;
};

}  // namespace gcs
