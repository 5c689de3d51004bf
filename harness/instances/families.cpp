#include "harness/instances/families.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/instances/family_lists.hpp"

namespace gcs {

std::vector<std::string> shrinking(const std::string& tame) {
  return {tame, "1e-1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12", "1e-15"};
}

std::vector<std::string> shrinking_to_zero(const std::string& tame) {
  std::vector<std::string> values = shrinking(tame);
  values.emplace_back("0");
  return values;
}

std::span<const InstanceFamily> families() {
  static const std::vector<InstanceFamily> all = [] {
    std::vector<InstanceFamily> families;
    for (const auto& list :
         {flat_families(), line_families(), octahedron_families(), compound_families(), general_families()})
      families.insert(families.end(), list.begin(), list.end());
    return families;
  }();
  return all;
}

std::array<std::span<const InstanceFamily>, 4> all_families() {
  return {families(), growing_families(), graph_families(), record_families()};
}

const InstanceFamily* find_family(std::string_view name) {
  for (const auto kind : all_families())
    for (const InstanceFamily& family : kind)
      if (family.name == name) return &family;
  return nullptr;
}

namespace {

struct Member {
  const InstanceFamily& family;
  std::string value;
};

Member member_of(const std::string& id) {
  const std::size_t at = id.find('@');
  return {*find_family(id.substr(0, at)), id.substr(at + 1)};
}

}  // namespace

bool is_ill_posed(const std::string& id) {
  const auto [family, value] = member_of(id);
  return std::find(family.ill_posed.begin(), family.ill_posed.end(), value) != family.ill_posed.end();
}

std::optional<std::uint64_t> solutions_by_theory(const std::string& id) {
  if (find_family(id.substr(0, id.find('@'))) == nullptr || id.find('@') == std::string::npos)
    return std::nullopt;
  const auto [family, value] = member_of(id);
  const std::uint64_t count =
      value == "0" && family.solutions_at_zero > 0 ? family.solutions_at_zero : family.solutions;
  return count > 0 && !is_ill_posed(id) ? std::optional(count) : std::nullopt;
}

Instance load_member(const std::string& id) {
  const auto [family, value] = member_of(id);
  return parse_instance(family.text(id, value), id);
}

}  // namespace gcs
