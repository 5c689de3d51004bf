# Catch2 2 is header-only; its main is compiled once.
find_package(Catch2 2.13 REQUIRED)
include(Catch)

if(NOT TARGET gcs_test_main)
  gcs_precompile(gcs_tests_precompiled <catch2/catch.hpp>)
  target_link_libraries(gcs_tests_precompiled PUBLIC Catch2::Catch2)
  gcs_build_quickly(gcs_tests_precompiled)
  add_library(gcs_test_main STATIC ${PROJECT_SOURCE_DIR}/solvers/tests/test_main.cpp)
  target_link_libraries(gcs_test_main PUBLIC gcs_flags Catch2::Catch2 nlohmann_json::nlohmann_json)
  target_compile_options(gcs_test_main PRIVATE -O0)
endif()

# gcs_add_tests(<program> [COST <n>] LABEL <label> LIBRARIES <lib>… [TOGETHER <folder>…] SOURCES <file>…): every
# TEST_CASE becomes a ctest test. Tests of higher cost start first, so that none is left alone at the end. The label:
# unit, a part of the library or of the program, and each kind of scene once; solve, whole solves; contract, every
# strategy on small scenes of every kind. Tests of the program as a user runs it have the labels program and, where it
# reads what anybody may have written, foreign. Sanitizers run unit and foreign. TOGETHER: the sources of such a folder
# are compiled as one.
function(gcs_add_tests program)
  cmake_parse_arguments(ARG "" "COST;LABEL" "LIBRARIES;TOGETHER;SOURCES" ${ARGN})
  add_executable(${program} ${ARG_SOURCES})
  target_link_libraries(${program} PRIVATE gcs_test_main ${ARG_LIBRARIES})
  gcs_build_quickly(${program})
  if(ARG_TOGETHER AND GCSBENCH_COMPILE_TOGETHER)
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    foreach(source IN LISTS ARG_SOURCES)
      get_filename_component(folder ${source} DIRECTORY)
      if(folder IN_LIST ARG_TOGETHER)
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder})
      endif()
    endforeach()
  endif()
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})  # of the tests, which see every room
  target_precompile_headers(${program} REUSE_FROM gcs_tests_precompiled)
  target_compile_definitions(${program} PRIVATE GCSBENCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(NOT ARG_COST)
    set(ARG_COST 0)
  endif()
  catch_discover_tests(${program} TEST_PREFIX "${program}: " PROPERTIES TIMEOUT 600 COST ${ARG_COST} LABELS ${ARG_LABEL})
endfunction()
