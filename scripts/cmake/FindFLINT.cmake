# FLINT and Arb, which have no CMake package in Debian: the imported target FLINT::FLINT. With GMP, whose functions
# FLINT's headers call.
find_library(FLINT_LIBRARY NAMES flint)
find_library(ARB_LIBRARY NAMES flint-arb arb)
find_library(GMP_LIBRARY NAMES gmp)
find_path(FLINT_INCLUDE_DIR flint/flint.h)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS FLINT_LIBRARY ARB_LIBRARY GMP_LIBRARY FLINT_INCLUDE_DIR)
mark_as_advanced(FLINT_LIBRARY ARB_LIBRARY GMP_LIBRARY FLINT_INCLUDE_DIR)
if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT INTERFACE IMPORTED)
  target_include_directories(FLINT::FLINT INTERFACE ${FLINT_INCLUDE_DIR})
  target_link_libraries(FLINT::FLINT INTERFACE ${ARB_LIBRARY} ${FLINT_LIBRARY} ${GMP_LIBRARY})
endif()
