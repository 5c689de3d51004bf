#define GCS_ONCE
#include "solvers/numeric/compiled_once.hpp"
