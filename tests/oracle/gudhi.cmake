# Finds GUDHI's headers, which use CGAL's kernels of any dimension and so Eigen, and defines the target test_gudhi.
include(${CMAKE_CURRENT_LIST_DIR}/cgal.cmake)
if(NOT TARGET test_gudhi)
  find_path(GUDHI_INCLUDE_DIR gudhi/Alpha_complex.h REQUIRED)
  find_path(EIGEN3_INCLUDE_DIR Eigen/Core PATH_SUFFIXES eigen3 REQUIRED)
  mark_as_advanced(GUDHI_INCLUDE_DIR EIGEN3_INCLUDE_DIR)

  add_library(test_gudhi INTERFACE)
  target_include_directories(test_gudhi SYSTEM INTERFACE ${GUDHI_INCLUDE_DIR} ${EIGEN3_INCLUDE_DIR})
  target_link_libraries(test_gudhi INTERFACE test_cgal)
endif()
