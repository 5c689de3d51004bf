#include "harness/instances/family.hpp"

#include <fmt/format.h>

namespace gcs {

std::vector<std::string> InstanceFamily::members() const {
  std::vector<std::string> ids;
  for (const std::string& value : values) ids.push_back(fmt::format("{}@{}", name, value));
  return ids;
}

}  // namespace gcs
