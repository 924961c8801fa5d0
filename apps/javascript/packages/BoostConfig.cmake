# Headers are in the folder that toolchain.cmake makes.
if(NOT TARGET Boost::headers)
  add_library(Boost::headers INTERFACE IMPORTED)
endif()
