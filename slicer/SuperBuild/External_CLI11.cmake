set(proj CLI11)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)

if(DEFINED ${proj}_DIR)
  # one that is there already
  ExternalProject_Add_Empty(${proj} DEPENDS ${${proj}_DEPENDS})
else()
  # Headers only: nothing of it is installed with the extension.
  ExternalProject_Add(
    ${proj}
    ${${proj}_EP_ARGS}
    GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git
    GIT_TAG v2.1.2
    GIT_SHALLOW ON
    SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
    BINARY_DIR ${proj}-build
    INSTALL_DIR ${proj}-install
    CMAKE_CACHE_ARGS
      ${ep_common_cache_args}
      -DCMAKE_INSTALL_PREFIX:PATH=<INSTALL_DIR>
      -DBUILD_TESTING:BOOL=OFF
      -DCLI11_BUILD_TESTS:BOOL=OFF
      -DCLI11_BUILD_EXAMPLES:BOOL=OFF
    DEPENDS ${${proj}_DEPENDS}
  )
  set(${proj}_DIR ${CMAKE_BINARY_DIR}/${proj}-install/lib/cmake/CLI11)
endif()
mark_as_superbuild(${proj}_DIR:PATH)
