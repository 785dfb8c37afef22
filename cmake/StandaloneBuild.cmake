# The build against an installed ITK, which has no ITKModuleExternal.cmake: the same targets by plain CMake.
# The module's dependencies are read from itk-module.cmake, so that they are stated once.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
option(BUILD_SHARED_LIBS "Build the module as a shared library" ON)
option(BUILD_TESTING "Build the tests" ON)
option(BUILD_EXAMPLES "Build the examples" ON)
option(MultiMaterialMeshing_BUILD_BENCHMARKS "Build what measures the module" OFF)
set(MultiMaterialMeshing_SANITIZE "" CACHE STRING "Sanitizers to build with, for example address,undefined")

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

macro(itk_module _name)
  cmake_parse_arguments(_module "EXCLUDE_FROM_DEFAULT;ENABLE_SHARED" "DESCRIPTION"
    "DEPENDS;PRIVATE_DEPENDS;TEST_DEPENDS;FACTORY_NAMES" ${ARGN})
endmacro()
include("${CMAKE_CURRENT_SOURCE_DIR}/itk-module.cmake")

# Formats of surfaces that the programs read where ITK has them.
list(JOIN ITK_MODULES_ENABLED "|" _enabled)
set(_formats ITKIOMeshGifti ITKIOMeshVTK)
list(FILTER _formats INCLUDE REGEX "^(${_enabled})$")
find_itk_quietly(REQUIRED COMPONENTS ${_module_DEPENDS} ${_module_PRIVATE_DEPENDS} ${_formats})
include(UseTetGen)
# The factories of ITK that the command line, tests and examples need are registered by ITK's own generated headers.
include(RegisterITKFormats)

if(MultiMaterialMeshing_SANITIZE)
  add_compile_options(-fsanitize=${MultiMaterialMeshing_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MultiMaterialMeshing_SANITIZE})
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wall -Wextra)
endif()

include(GNUInstallDirs)
# Programs find the module's libraries beside them, wherever an installation goes, and ITK where it was.
if(APPLE)
  set(_origin "@loader_path")
else()
  set(_origin "$ORIGIN")
endif()
file(RELATIVE_PATH _libraries "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
set(CMAKE_INSTALL_RPATH "${_origin}" "${_origin}/${_libraries}")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

if(BUILD_TESTING)
  enable_testing()
endif()
add_subdirectory(src)
add_subdirectory(applications)
add_subdirectory(docs)
include(InstallPackage)
if(BUILD_EXAMPLES)
  add_subdirectory(examples)
endif()
if(MultiMaterialMeshing_BUILD_BENCHMARKS)
  add_subdirectory(bench)
endif()
if(BUILD_TESTING)
  add_subdirectory(test)
endif()
if(BUILD_TESTING AND TARGET multimaterial-mesh AND TARGET make-head-phantom)
  add_test(
    NAME InstallationServesAnotherProject
    COMMAND
      "${CMAKE_COMMAND}" "-DBUILD=${CMAKE_BINARY_DIR}" "-DEXAMPLE=${CMAKE_CURRENT_SOURCE_DIR}/examples/use-in-cxx"
      "-DGENERATOR=${CMAKE_GENERATOR}" "-DPHANTOM=$<TARGET_FILE:make-head-phantom>"
      "-DWORK=${CMAKE_BINARY_DIR}/installation" -P
      "${CMAKE_CURRENT_SOURCE_DIR}/test/installation/CheckInstallation.cmake"
  )
endif()
