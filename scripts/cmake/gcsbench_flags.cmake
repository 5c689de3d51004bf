# Flags of every target. Results must be the same bits for the same source: no contraction into fused
# multiply-adds behind the reader's back, no -ffast-math, no code for the build machine alone.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(gcs_flags INTERFACE)
target_compile_features(gcs_flags INTERFACE cxx_std_20)
target_compile_options(gcs_flags INTERFACE -ffp-contract=off)
add_library(gcs_warnings INTERFACE)  # not of who uses the installed library
target_link_libraries(gcs_flags INTERFACE $<BUILD_INTERFACE:gcs_warnings>)
target_compile_options(gcs_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                              -Wnon-virtual-dtor -Wold-style-cast)
# g++ 12 reports overlapping and overlong accesses inside std::string that do not exist (GCC bug 105651 and its
# kin); the sanitizers watch for real ones.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(gcs_warnings INTERFACE -Wno-restrict -Wno-stringop-overread)
  # Up to a gigabyte (in kB) g++ does not look for memory to use again: a sixth of a build was that.
  target_compile_options(gcs_flags INTERFACE $<BUILD_INTERFACE:--param=ggc-min-heapsize=1048576>)
endif()
if(GCSBENCH_WARNINGS_AS_ERRORS)
  target_compile_options(gcs_warnings INTERFACE -Werror)
endif()
# A module of Python takes the library in. Hidden, its functions call each other as in a program.
if(GCSBENCH_WITH_PYTHON)
  target_compile_options(gcs_flags INTERFACE $<BUILD_INTERFACE:-fPIC> $<BUILD_INTERFACE:-fvisibility=hidden>)
endif()
if(GCSBENCH_SANITIZE)
  target_compile_options(gcs_flags INTERFACE -fsanitize=${GCSBENCH_SANITIZE} -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer
                                             -fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/foreign_code.txt)
  target_link_options(gcs_flags INTERFACE -fsanitize=${GCSBENCH_SANITIZE})
endif()
# Half of a build would be parsing of these. That a source includes what it uses of them is a test (includes).
set(gcs_precompiled_headers <algorithm> <array> <cmath> <functional> <map> <optional> <span> <stop_token> <string> <vector>
                            <Eigen/Dense> ${PROJECT_SOURCE_DIR}/solvers/numeric/compiled_once.hpp)
target_include_directories(gcs_flags INTERFACE
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated> $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/gcsbench>)
