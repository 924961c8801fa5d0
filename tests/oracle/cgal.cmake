# Finds CGAL's headers and its number types, for tests and benchmarks, and defines the target test_cgal. Does not use
# CGAL's own package file, which prints messages and changes flags.
if(NOT TARGET test_cgal)
  find_path(CGAL_INCLUDE_DIR CGAL/Delaunay_triangulation_2.h REQUIRED)
  find_path(GMP_INCLUDE_DIR gmp.h REQUIRED)
  find_library(GMP_LIBRARY gmp REQUIRED)
  find_library(MPFR_LIBRARY mpfr REQUIRED)
  mark_as_advanced(CGAL_INCLUDE_DIR GMP_INCLUDE_DIR GMP_LIBRARY MPFR_LIBRARY)
  find_package(Threads REQUIRED)

  add_library(test_cgal INTERFACE)
  target_include_directories(test_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIR} ${GMP_INCLUDE_DIR})
  target_compile_definitions(test_cgal INTERFACE CGAL_USE_GMP=1 CGAL_USE_MPFR=1)
  # Interval arithmetic changes the rounding mode; CGAL requires a flag for that with g++.
  target_compile_options(test_cgal INTERFACE $<$<CXX_COMPILER_ID:GNU>:-frounding-math>)
  target_link_libraries(test_cgal INTERFACE ${MPFR_LIBRARY} ${GMP_LIBRARY} Boost::headers Threads::Threads)
endif()
