set(proj TetGen)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)

if(DEFINED TETGEN_ROOT)
  # one that is there already
  ExternalProject_Add_Empty(${proj} DEPENDS ${${proj}_DEPENDS})
else()
  # TetGen is under the AGPL 3. It is built from its own source, with a CMakeLists.txt of ours, as a library of its own.
  ExternalProject_Add(
    ${proj}
    ${${proj}_EP_ARGS}
    GIT_REPOSITORY https://github.com/libigl/tetgen.git
    GIT_TAG 4f3bfba3997f20aa1f96cfaff604313a8c2c85b6
    SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
    BINARY_DIR ${proj}-build
    INSTALL_DIR ${proj}-install
    PATCH_COMMAND
      ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_LIST_DIR}/TetGen/CMakeLists.txt <SOURCE_DIR>/CMakeLists.txt
    CMAKE_CACHE_ARGS
      ${ep_common_cache_args}
      -DCMAKE_INSTALL_PREFIX:PATH=<INSTALL_DIR>
      -DTETGEN_PACKAGED_LIBRARY_DIR:STRING=${Slicer_INSTALL_THIRDPARTY_LIB_DIR}
    DEPENDS ${${proj}_DEPENDS}
  )
  set(TETGEN_ROOT ${CMAKE_BINARY_DIR}/${proj}-install)
  set(TetGen_BUILD_DIR ${CMAKE_BINARY_DIR}/${proj}-build)
endif()
mark_as_superbuild(VARS TETGEN_ROOT:PATH TetGen_BUILD_DIR:PATH)
