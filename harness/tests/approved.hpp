#pragma once
/// Output compared with approved files in harness/tests/approved. scripts/approve accepts what is produced
/// now.

#include <string>

namespace gcs {

/// Checks that `text` is the content of the approved file of that name. With GCSBENCH_APPROVE in the
/// environment the file is written instead.
void check_approved(const std::string& name, const std::string& text);

}  // namespace gcs
