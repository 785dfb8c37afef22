# The build against an installed ITK, which has no ITKModuleExternal.cmake: the same targets by plain CMake.
# The module's dependencies are read from itk-module.cmake, so that they are stated once.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
option(BUILD_SHARED_LIBS "Build the module as a shared library" ON)
option(BUILD_TESTING "Build the tests" ON)
option(BUILD_EXAMPLES "Build the examples and the benchmarks" ON)
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

find_package(ITK REQUIRED COMPONENTS ${_module_DEPENDS} ${_module_PRIVATE_DEPENDS})
find_package(TetGen REQUIRED)
# The factories of ITK that the command line, tests and examples need are registered by ITK's own generated headers.
include("${ITK_USE_FILE}")

if(MultiMaterialMeshing_SANITIZE)
  add_compile_options(-fsanitize=${MultiMaterialMeshing_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MultiMaterialMeshing_SANITIZE})
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wall -Wextra)
endif()

include(GNUInstallDirs)
if(BUILD_TESTING)
  enable_testing()
endif()
add_subdirectory(src)
add_subdirectory(applications)
add_subdirectory(docs)
if(BUILD_EXAMPLES)
  add_subdirectory(examples)
  add_subdirectory(bench)
endif()
if(BUILD_TESTING)
  add_subdirectory(test)
endif()
