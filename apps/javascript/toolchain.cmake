# What: Debian's Emscripten with this machine's header-only libraries: Highway, Boost, Eigen, nanoflann.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)

# Linked into a folder of their own, as the other headers there belong to another standard library.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(header hwy boost eigen3/Eigen nanoflann.hpp)
  get_filename_component(name ${header} NAME)
  file(CREATE_LINK /usr/include/${header} ${headers}/${name} SYMBOLIC)
endforeach()
foreach(package Boost Eigen3 hwy)
  set(${package}_DIR ${CMAKE_CURRENT_LIST_DIR}/packages)
endforeach()
set(NANOFLANN_INCLUDE_DIR ${headers})

set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/missing_in_libcxx.h -isystem ${headers}")
