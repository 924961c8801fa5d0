# Finds the C interface of GEOS, 3.10 or newer for its GeoJSON reader, and defines the target test_geos.
if(NOT TARGET test_geos)
  find_path(GEOS_INCLUDE_DIR geos_c.h REQUIRED)
  find_library(GEOS_C_LIBRARY geos_c REQUIRED)
  mark_as_advanced(GEOS_INCLUDE_DIR GEOS_C_LIBRARY)

  add_library(test_geos INTERFACE)
  target_include_directories(test_geos SYSTEM INTERFACE ${GEOS_INCLUDE_DIR})
  target_link_libraries(test_geos INTERFACE ${GEOS_C_LIBRARY})
endif()
