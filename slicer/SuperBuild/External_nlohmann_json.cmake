set(proj nlohmann_json)
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
    GIT_REPOSITORY https://github.com/nlohmann/json.git
    GIT_TAG v3.11.2
    GIT_SHALLOW ON
    SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
    BINARY_DIR ${proj}-build
    INSTALL_DIR ${proj}-install
    CMAKE_CACHE_ARGS
      ${ep_common_cache_args}
      -DCMAKE_INSTALL_PREFIX:PATH=<INSTALL_DIR>
      -DBUILD_TESTING:BOOL=OFF
      -DJSON_BuildTests:BOOL=OFF
      -DJSON_Install:BOOL=ON
    DEPENDS ${${proj}_DEPENDS}
  )
  set(${proj}_DIR ${CMAKE_BINARY_DIR}/${proj}-install/share/cmake/nlohmann_json)
endif()
mark_as_superbuild(${proj}_DIR:PATH)
