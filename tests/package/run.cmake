cmake_minimum_required(VERSION 3.25)

# run(WHAT COMMAND...): runs a command; if it fails, so does the test, with what the command said.
# run_expecting_failure(WHAT REGEX COMMAND...): the command must fail and say what matches REGEX.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif()
  message(STATUS "${what}: well")
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(run_expecting_failure what regex)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    message(FATAL_ERROR "${what}: passed, but should be rejected")
  endif()
  string(REGEX REPLACE "[ \n]+" " " output "${output}") # CMake breaks its lines
  if(NOT output MATCHES "${regex}")
    message(FATAL_ERROR "${what}: rejected without '${regex}':\n${output}")
  endif()
  message(STATUS "${what}: rejected, as it should be")
endfunction()
