#pragma once
/// Families of instances that grow stiff or extreme with a parameter, made here with lengths in as many
/// decimals as the parameter needs.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/instance_io.hpp"

namespace gcs {

struct Family {
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

/// Those of `gcsbench stability`.
std::span<const Family> families();

/// Scenes with more and more of what need not be solved for; the parameter says how much.
std::span<const Family> growing_families();

/// The family of that name, of both kinds, or nullptr.
const Family* find_family(std::string_view name);

/// Whether the member of that id is one of the ill-posed ones. Precondition: it is one of some family.
bool is_ill_posed(const std::string& id);

/// The member of that id. Precondition: it is one of some family.
Instance load_member(const std::string& id);

}  // namespace gcs
