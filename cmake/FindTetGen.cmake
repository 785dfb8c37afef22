# Finds TetGen, which ships no CMake package of its own.
#
#   TetGen_FOUND      header and library were found
#   TetGen::TetGen    imported target; compiles its users with TETLIBRARY, so that TetGen throws instead of exiting
#
# Hint: set TETGEN_ROOT (or TetGen_ROOT) to a prefix that holds include/tetgen.h and lib/libtet.*

find_path(TetGen_INCLUDE_DIR NAMES tetgen.h HINTS "${TETGEN_ROOT}" ENV TETGEN_ROOT PATH_SUFFIXES include)
find_library(TetGen_LIBRARY NAMES tet tetgen libtet HINTS "${TETGEN_ROOT}" ENV TETGEN_ROOT PATH_SUFFIXES lib)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen REQUIRED_VARS TetGen_LIBRARY TetGen_INCLUDE_DIR)

if(TetGen_FOUND AND NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  set_target_properties(
    TetGen::TetGen
    PROPERTIES
      IMPORTED_LOCATION "${TetGen_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${TetGen_INCLUDE_DIR}"
      INTERFACE_COMPILE_DEFINITIONS TETLIBRARY
  )
endif()
mark_as_advanced(TetGen_INCLUDE_DIR TetGen_LIBRARY)
