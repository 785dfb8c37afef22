# To be included after find_package(ITK), before targets that link to ITK_LIBRARIES: these can read and write the formats
# that ITK has then. Up to ITK 5, by a file that changes the settings of all targets that follow.
if(ITK_VERSION_MAJOR GREATER_EQUAL 6)
  itk_generate_factory_registration()
  set(ITK_LIBRARIES "${ITK_INTERFACE_LIBRARIES}")
  foreach(_formats ITK::ITKImageIO ITK::ITKMeshIO)
    if(TARGET ${_formats})
      list(APPEND ITK_LIBRARIES ${_formats})
    endif()
  endforeach()
else()
  include("${ITK_USE_FILE}")
endif()
