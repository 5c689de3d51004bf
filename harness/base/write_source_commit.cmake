# Run at every build: writes OUTPUT, a header with the commit of SOURCE, and touches it only when it changes.
find_program(git_program git)
set(commit unknown)
if(git_program)
  # A folder inside somebody else's repository has no commit of its own.
  execute_process(COMMAND ${git_program} -C ${SOURCE} rev-parse --show-prefix HEAD
                  OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed AND answer MATCHES "^\n?([0-9a-f]+)$")
    set(commit ${CMAKE_MATCH_1})
    # What one sweep has written does not make another program of the next one's.
    set(sources . ":!results/sweeps" ":!results/tables" ":!results/plots")
    execute_process(COMMAND ${git_program} -C ${SOURCE} diff --quiet HEAD -- ${sources} RESULT_VARIABLE dirty)
    if(dirty)
      # Two edits of one commit are two programs.
      execute_process(COMMAND ${git_program} -C ${SOURCE} diff --binary HEAD -- ${sources}
                      COMMAND ${git_program} hash-object --stdin
                      OUTPUT_VARIABLE edit OUTPUT_STRIP_TRAILING_WHITESPACE)
      string(SUBSTRING "${edit}" 0 12 edit)
      string(APPEND commit "+dirty-${edit}")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define GCSBENCH_SOURCE_COMMIT \"${commit}\"\n")
