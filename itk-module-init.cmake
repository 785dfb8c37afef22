# TetGen is linked PRIVATE: modules that depend on this one need neither its header nor its library to compile.
list(APPEND CMAKE_MODULE_PATH "${MultiMaterialMeshing_SOURCE_DIR}/cmake")
include(UseTetGen)
