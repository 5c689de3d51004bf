#include "solvers/reading/instance_format.hpp"

namespace gcs {
namespace {

constexpr const char* distances_name = "gcsbench-instance/1";
constexpr const char* general_name = "gcsbench-instance/2";

void check_fields_of_distances(const JsonCursor& root) {
  for (const std::string_view kind : {"planes", "bodies"}) {
    if (const auto found = root.optional(kind))
      found->fail(std::string(kind) + " are not supported", general_format_remedy());
  }
  for (const std::string_view kind : {"angles", "incidences", "circles"}) {
    if (const auto found = root.optional(kind)) {
      found->fail(std::string(kind) + " are not supported", "give points, lines, and distances between them");
    }
  }
  root.allow_members({"format", "id", "title", "dimension", "points", "lines", "fixed", "constraints",
                      "reference", "sketch", "interpolation", "construction", "published", "notes"});
}

}  // namespace

std::string general_format_remedy(const std::string& otherwise) {
  const std::string remedy = std::string("give \"format\": \"") + general_name + "\"";
  return otherwise.empty() ? remedy : otherwise + ", or " + remedy;
}

InstanceFormat read_format(const JsonCursor& root) {
  const JsonCursor format = root.required("format");
  const std::string name = format.text();
  if (name == distances_name) return InstanceFormat::distances;
  if (name == general_name) return InstanceFormat::general;
  format.fail("the format is '" + name + "'",
              std::string("this program reads '") + distances_name + "' and '" + general_name + "'");
}

void check_fields(const JsonCursor& root, InstanceFormat format) {
  if (format == InstanceFormat::distances) {
    check_fields_of_distances(root);
    return;
  }
  root.allow_members({"format", "id", "title", "dimension", "points", "lines", "planes", "bodies", "fixed",
                      "constraints", "reference", "sketch", "interpolation", "construction", "published",
                      "notes"});
}

}  // namespace gcs
