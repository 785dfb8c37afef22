# find_package(ITK) without what Debian's packages say of programs of GDCM that they have not.
macro(find_itk_quietly)
  set(_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  find_package(ITK ${ARGN})
  set(CMAKE_MESSAGE_LOG_LEVEL "${_log_level}")
endmacro()
