find_package(Python3 COMPONENTS Interpreter QUIET)

# add_client_test(NAME PACKAGES SCRIPT [ARGUMENT...])
# A test that runs a Python script with other people's packages (a text as behind "import"), where Python has them.
function(add_client_test name packages script)
  if(Python3_FOUND)
    execute_process(
      COMMAND "${Python3_EXECUTABLE}" -c "import ${packages}"
      RESULT_VARIABLE _missing
      OUTPUT_QUIET
      ERROR_QUIET
    )
  else()
    set(_missing TRUE)
  endif()
  if(_missing AND "$ENV{CI}" STREQUAL "true")
    message(FATAL_ERROR "The test ${name} needs a Python 3 with ${packages}, and CI leaves out no test")
  elseif(_missing)
    message(STATUS "No test ${name}: it needs a Python 3 with ${packages}")
  else()
    add_test(NAME ${name} COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${ARGN})
  endif()
endfunction()
