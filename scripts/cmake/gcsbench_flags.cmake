# Flags of every target. Results must be the same bits for the same source: no contraction into fused
# multiply-adds behind the reader's back, no -ffast-math, no code for the build machine alone.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(gcs_flags INTERFACE)
target_compile_options(gcs_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast)
# g++ 12 reports overlapping and overlong accesses inside std::string that do not exist (GCC bug 105651 and its
# kin); the sanitizers watch for real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gcs_flags INTERFACE -Wno-restrict -Wno-stringop-overread)
endif()
if(GCSBENCH_WARNINGS_AS_ERRORS)
  target_compile_options(gcs_flags INTERFACE -Werror)
endif()
if(GCSBENCH_SANITIZE)
  target_compile_options(gcs_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
  target_link_options(gcs_flags INTERFACE -fsanitize=address,undefined)
endif()
# Half of a build is parsing of these. The release preset does without, so that a missing include is noticed.
set(gcs_precompiled_headers <algorithm> <array> <cmath> <functional> <map> <optional> <string> <vector> <Eigen/Dense>)
target_include_directories(gcs_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
