# What slicer/CMakeLists.txt asks of Slicer, but for its packages: enough to configure and build the module.
set(Slicer_USE_FILE "${CMAKE_CURRENT_LIST_DIR}/UseSlicer.cmake")
set(Slicer_EXTENSION_GENERATE_CONFIG "${CMAKE_CURRENT_LIST_DIR}/Nothing.cmake")
set(Slicer_EXTENSION_CPACK "${CMAKE_CURRENT_LIST_DIR}/Nothing.cmake")
set(Slicer_CLIMODULES_BIN_DIR lib/Slicer/cli-modules)
set(Slicer_CLIMODULES_LIB_DIR lib/Slicer/cli-modules)
set(Slicer_INSTALL_CLIMODULES_BIN_DIR lib/Slicer/cli-modules)
set(Slicer_INSTALL_CLIMODULES_LIB_DIR lib/Slicer/cli-modules)
