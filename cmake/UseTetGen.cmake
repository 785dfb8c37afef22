# Which TetGen it is: one that is built from its source, by BuildTetGen.cmake, or the system's.
set(MultiMaterialMeshing_TETGEN_SOURCE "" CACHE PATH "Source of TetGen 1.5.0 to build; the system's TetGen if empty")

if(NOT MultiMaterialMeshing_TETGEN_SOURCE)
  find_package(TetGen REQUIRED)
  # If this module is a static library, those who link it link TetGen, too.
  set(
    MultiMaterialMeshing_EXPORT_CODE_BUILD
    "
if(NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  set_target_properties(TetGen::TetGen PROPERTIES IMPORTED_LOCATION \"${TetGen_LIBRARY}\")
endif()
"
  )
  set(MultiMaterialMeshing_EXPORT_CODE_INSTALL "${MultiMaterialMeshing_EXPORT_CODE_BUILD}")
endif()
