# Builds TetGen 1.5.0 from its source in MultiMaterialMeshing_TETGEN_SOURCE, as the target TetGen::TetGen.
# The copy of its header that is used differs in two lines, so that each of TetGen's ways to give up is an exception:
# - terminatetetgen() frees the mesh and throws, whereupon the mesh's destructor would free it again.
# - Some assertions fail on valid input. One that fails throws its words.

set(_source "${MultiMaterialMeshing_TETGEN_SOURCE}")
set(_include "${CMAKE_CURRENT_BINARY_DIR}/TetGen")
if(NOT EXISTS "${_source}/tetgen.h")
  message(FATAL_ERROR "There is no tetgen.h in MultiMaterialMeshing_TETGEN_SOURCE, ${_source}.")
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${_source}/tetgen.h")
file(READ "${_source}/tetgen.h" _header)
macro(replace_in_header _old _new)
  string(FIND "${_header}" "${_old}" _place)
  if(_place EQUAL -1)
    message(FATAL_ERROR "${_source} is not TetGen 1.5.0: tetgen.h has no \"${_old}\".")
  endif()
  string(REPLACE "${_old}" "${_new}" _header "${_header}")
endmacro()
replace_in_header("if (m) {\n    m->freememory();\n  }" "")
replace_in_header("#include <assert.h>" "#define assert(condition) ((condition) ? void() : throw #condition)")
file(GENERATE OUTPUT "${_include}/tetgen.h" CONTENT "${_header}")
# beside the header, where they find it before their own
configure_file("${_source}/tetgen.cxx" "${_include}/tetgen.cxx" COPYONLY)
configure_file("${_source}/predicates.cxx" "${_include}/predicates.cxx" COPYONLY)

add_library(MultiMaterialMeshingTetGen "${_include}/tetgen.cxx" "${_include}/predicates.cxx")
add_library(TetGen::TetGen ALIAS MultiMaterialMeshingTetGen)
set_target_properties(MultiMaterialMeshingTetGen PROPERTIES WINDOWS_EXPORT_ALL_SYMBOLS ON)
if(BUILD_SHARED_LIBS)
  set_target_properties(MultiMaterialMeshingTetGen PROPERTIES CXX_VISIBILITY_PRESET default VISIBILITY_INLINES_HIDDEN OFF)
else()
  # other libraries in the same process may have a TetGen of their own
  set_target_properties(MultiMaterialMeshingTetGen PROPERTIES CXX_VISIBILITY_PRESET hidden POSITION_INDEPENDENT_CODE ON)
endif()
target_include_directories(MultiMaterialMeshingTetGen SYSTEM INTERFACE "$<BUILD_INTERFACE:${_include}>")
target_compile_definitions(MultiMaterialMeshingTetGen PUBLIC TETLIBRARY)
# Its predicates are exact in IEEE arithmetic only, and it looks at doubles as pointers.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(MultiMaterialMeshingTetGen PRIVATE -w -ffp-contract=off -fno-strict-aliasing)
  # they read one number past the end of some arrays, which they do not use
  set_source_files_properties("${_include}/predicates.cxx" PROPERTIES COMPILE_OPTIONS -fno-sanitize=all)
elseif(MSVC)
  target_compile_options(MultiMaterialMeshingTetGen PRIVATE /w /fp:precise)
endif()
if(COMMAND itk_module_target)
  itk_module_target(MultiMaterialMeshingTetGen)
endif()
if(SKBUILD)
  install(
    FILES "${_source}/LICENSE"
    DESTINATION "${SKBUILD_METADATA_DIR}/licenses"
    RENAME LICENSE.TetGen
    COMPONENT PythonWheelRuntimeLibraries
  )
endif()
