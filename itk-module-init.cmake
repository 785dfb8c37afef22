# TetGen is linked PRIVATE: modules that depend on this one need neither its header nor its library to compile.
list(APPEND CMAKE_MODULE_PATH "${MultiMaterialMeshing_SOURCE_DIR}/cmake")
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
