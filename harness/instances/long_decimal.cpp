#include "harness/instances/long_decimal.hpp"

#include <flint/flint.h>

namespace gcs {

std::string LongDecimal::text(int places) const {
  char* written = arb_get_str(value_, places, ARB_STR_NO_RADIUS);
  const std::string text = written;
  flint_free(written);
  return text;
}

}  // namespace gcs
