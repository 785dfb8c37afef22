# Installs BUILD, moves the installation, and lets a program and the project EXAMPLE, which finds it as a package, mesh
# what PHANTOM makes. WORK is a folder for that.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE _result WORKING_DIRECTORY "${WORK}")
  if(NOT _result EQUAL 0)
    message(FATAL_ERROR "\"${ARGN}\" ended with ${_result}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/before")
file(RENAME "${WORK}/before" "${WORK}/installed")
foreach(_file LICENSE NOTICE)
  if(NOT EXISTS "${WORK}/installed/share/doc/MultiMaterialMeshing/${_file}")
    message(FATAL_ERROR "${_file} is not installed")
  endif()
endforeach()
run("${PHANTOM}" labels.nrrd 8)
run("${WORK}/installed/bin/multimaterial-mesh" labels.nrrd program.vtu --quiet)
run("${WORK}/installed/bin/optimize-tetrahedral-mesh" program.vtu optimized.vtu)
run(
  "${CMAKE_COMMAND}" -S "${EXAMPLE}" -B example -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${WORK}/installed"
  -DCMAKE_BUILD_TYPE=Release
)
run("${CMAKE_COMMAND}" --build example)
run("${WORK}/example/mesh-labels" labels.nrrd example.vtu)
