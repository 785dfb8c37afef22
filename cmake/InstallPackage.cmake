# What an installation has beside the programs: library, public headers, licences, and the package that CMake finds.

include(CMakePackageConfigHelpers)
set(_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/MultiMaterialMeshing")
set(_include_dir "${CMAKE_INSTALL_INCLUDEDIR}/MultiMaterialMeshing")

set(_libraries MultiMaterialMeshing)
if(TARGET MultiMaterialMeshingTetGen)
  list(APPEND _libraries MultiMaterialMeshingTetGen)
  install(
    FILES "${MultiMaterialMeshing_TETGEN_SOURCE}/LICENSE"
    DESTINATION "${CMAKE_INSTALL_DOCDIR}"
    RENAME LICENSE.TetGen
    COMPONENT RuntimeLibraries
  )
endif()
install(FILES LICENSE NOTICE DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT RuntimeLibraries)
install(
  TARGETS ${_libraries}
  EXPORT MultiMaterialMeshingTargets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT RuntimeLibraries
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT RuntimeLibraries
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT Development
  INCLUDES DESTINATION "${_include_dir}"
)
install(DIRECTORY include/ DESTINATION "${_include_dir}" COMPONENT Development)
install(
  FILES "${CMAKE_CURRENT_BINARY_DIR}/src/MultiMaterialMeshingExport.h"
  DESTINATION "${_include_dir}"
  COMPONENT Development
)
install(
  EXPORT MultiMaterialMeshingTargets
  NAMESPACE MultiMaterialMeshing::
  DESTINATION "${_package_dir}"
  COMPONENT Development
)
if(TARGET multimaterial-mesh)
  install(
    EXPORT MultiMaterialMeshingPrograms
    NAMESPACE MultiMaterialMeshing::
    DESTINATION "${_package_dir}"
    COMPONENT Development
  )
endif()
if(NOT BUILD_SHARED_LIBS AND MultiMaterialMeshing_EXPORT_CODE_INSTALL)
  # those who link a static library link the system's TetGen, too
  set(_tetgen "${CMAKE_CURRENT_BINARY_DIR}/MultiMaterialMeshingTetGen.cmake")
  file(GENERATE OUTPUT "${_tetgen}" CONTENT "${MultiMaterialMeshing_EXPORT_CODE_INSTALL}")
  install(FILES "${_tetgen}" DESTINATION "${_package_dir}" COMPONENT Development)
endif()
string(JOIN " " _itk_components ${_module_DEPENDS})
configure_package_config_file(
  cmake/MultiMaterialMeshingConfig.cmake.in
  MultiMaterialMeshingConfig.cmake
  INSTALL_DESTINATION "${_package_dir}"
  NO_SET_AND_CHECK_MACRO
)
write_basic_package_version_file(MultiMaterialMeshingConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_CURRENT_BINARY_DIR}/MultiMaterialMeshingConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/MultiMaterialMeshingConfigVersion.cmake"
  DESTINATION "${_package_dir}"
  COMPONENT Development
)
