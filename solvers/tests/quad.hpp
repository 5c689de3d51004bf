#pragma once
/// A floating-point type of 113 bits to check double-double arithmetic against.

#include <cfloat>

namespace gcs::samples {

#if LDBL_MANT_DIG >= 113
using Quad = long double;
#else
__extension__ using Quad = __float128;
#endif

inline Quad magnitude(Quad x) { return x < 0 ? -x : x; }

}  // namespace gcs::samples
