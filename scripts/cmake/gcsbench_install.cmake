# cmake --install: the program with its data, manual and completions, and the library as a CMake package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gcsbench)
set(data_dir ${CMAKE_INSTALL_DATADIR}/gcsbench)

install(TARGETS gcsbench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY instances DESTINATION ${data_dir} FILES_MATCHING PATTERN "*.json" PATTERN "README.md")
install(DIRECTORY results/published results/records results/reference DESTINATION ${data_dir}/results FILES_MATCHING PATTERN "*.json")
# README.md, and what it leads to.
install(FILES LICENSE CITATION.cff README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES results/README.md results/findings.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/results)
install(DIRECTORY results/plots results/published results/sweeps results/tables
        DESTINATION ${CMAKE_INSTALL_DOCDIR}/results)
install(FILES solvers/README.md solvers/rooms.svg DESTINATION ${CMAKE_INSTALL_DOCDIR}/solvers)
foreach(room IN ITEMS strategies certificates constraints counting elements homotopies reduction systems)
  install(FILES solvers/${room}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/solvers/${room})
endforeach()
install(FILES harness/README.md harness/glossary.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/harness)
install(FILES harness/python/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/harness/python)
install(FILES instances/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/instances)

# The Python module, where Debian's python3 looks for those of this prefix; others have to tell it.
if(GCSBENCH_WITH_PYTHON)
  install(CODE "
    set(version \"python${PYTHON_VERSION_MAJOR}.${PYTHON_VERSION_MINOR}\")
    cmake_path(SET prefix NORMALIZE \"\${CMAKE_INSTALL_PREFIX}\")
    cmake_path(SET own NORMALIZE \"\$ENV{HOME}/.local\")
    if(prefix STREQUAL /usr)
      set(modules /usr/lib/python3/dist-packages)
    elseif(prefix STREQUAL /usr/local)
      set(modules /usr/local/lib/\${version}/dist-packages)
    else()
      set(modules \${prefix}/lib/\${version}/site-packages)
      if(NOT prefix STREQUAL own)
        message(STATUS \"For Python: export PYTHONPATH=\${modules}\")
      endif()
    endif()
    file(INSTALL \"$<TARGET_FILE:gcs_python>\" DESTINATION \${modules}/gcsbench)
    foreach(file IN ITEMS __init__.py _core.pyi py.typed)
      file(INSTALL \"${PROJECT_SOURCE_DIR}/harness/python/gcsbench/\${file}\" DESTINATION \${modules}/gcsbench)
    endforeach()")
endif()

# The program writes its manual page itself.
set(manual ${PROJECT_BINARY_DIR}/generated/gcsbench.1)
install(CODE "execute_process(COMMAND \"$<TARGET_FILE:gcsbench>\" manual OUTPUT_FILE \"${manual}\" COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES harness/cli/shells/gcsbench.bash RENAME gcsbench
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES harness/cli/shells/gcsbench.zsh RENAME _gcsbench
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES harness/cli/shells/gcsbench.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set_target_properties(gcs_solvers PROPERTIES EXPORT_NAME solvers)
set_target_properties(gcs_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS gcs_solvers gcs_flags EXPORT gcsbenchTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY solvers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gcsbench
        FILES_MATCHING PATTERN "*.hpp" PATTERN tests EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/generated/gcsbench/gcsbench.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gcsbench)
install(EXPORT gcsbenchTargets NAMESPACE gcsbench:: DESTINATION ${package_dir})
configure_package_config_file(scripts/cmake/gcsbenchConfig.cmake.in
  ${PROJECT_BINARY_DIR}/generated/gcsbenchConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/gcsbenchConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/gcsbenchConfig.cmake
              ${PROJECT_BINARY_DIR}/generated/gcsbenchConfigVersion.cmake
              scripts/cmake/FindFLINT.cmake
        DESTINATION ${package_dir})
