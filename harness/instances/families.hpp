#pragma once
/// Families of instances that grow stiff or extreme with a parameter, made here with lengths in as many
/// decimals as the parameter needs.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "harness/instances/family.hpp"
#include "solvers/reading/instance_parser.hpp"

namespace gcs {

/// Those of `gcsbench stability`.
std::span<const InstanceFamily> families();

/// Scenes with more and more of what need not be solved for, or of turns of S; the parameter says how much.
std::span<const InstanceFamily> growing_families();

/// Minimally rigid graphs of the plane with random lengths, there and on a sphere (families_graphs.hpp).
std::span<const InstanceFamily> graph_families();

/// Graphs at lengths with many real realisations, as they were found (results/records).
std::span<const InstanceFamily> record_families();

/// All kinds of families, in this order.
std::array<std::span<const InstanceFamily>, 4> all_families();

/// The family of that name, of all kinds, or nullptr.
const InstanceFamily* find_family(std::string_view name);

/// Whether the member of that id is one of the ill-posed ones. Precondition: it is one of some family.
bool is_ill_posed(const std::string& id);

/// How many complex solutions theory counts for the member, if the family says so; nothing for any other id.
std::optional<std::uint64_t> solutions_by_theory(const std::string& id);

/// The member of that id. Precondition: it is one of some family.
Instance load_member(const std::string& id);

}  // namespace gcs
