set(proj TetGen)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)

if(DEFINED MultiMaterialMeshing_TETGEN_SOURCE)
  # one that is there already
  ExternalProject_Add_Empty(${proj} DEPENDS ${${proj}_DEPENDS})
else()
  # TetGen is under the AGPL 3. Its source is got here; the module builds it, and refuses other versions.
  set(_path pool/main/t/tetgen/tetgen_1.5.0.orig.tar.gz)
  ExternalProject_Add(
    ${proj}
    ${${proj}_EP_ARGS}
    URL
      https://deb.debian.org/debian/${_path}
      https://snapshot.debian.org/archive/debian/20230611T000000Z/${_path}
    URL_HASH SHA256=4d114861d5ef2063afd06ef38885ec46822e90e7b4ea38c864f76493451f9cf3
    DOWNLOAD_DIR ${CMAKE_BINARY_DIR}
    SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
    CONFIGURE_COMMAND ""
    BUILD_COMMAND ""
    INSTALL_COMMAND ""
    DEPENDS ${${proj}_DEPENDS}
  )
  set(MultiMaterialMeshing_TETGEN_SOURCE ${CMAKE_BINARY_DIR}/${proj})
endif()
mark_as_superbuild(MultiMaterialMeshing_TETGEN_SOURCE:PATH)
