# The paths that public headers had up to version 0.1: each includes the new one, for version 0.2 only. They are written into the
# build folder, so that the sources have one place for each thing.
set(forwarded
  rbpa/space/auto_radii.h>rbpa/auto_radii.h
  rbpa/core/api.h>rbpa/base/api.h
  rbpa/core/duplicate.h>rbpa/base/duplicate.h
  rbpa/core/error.h>rbpa/base/error.h
  rbpa/core/point.h>rbpa/base/point.h
  rbpa/core/point3.h>rbpa/base/point3.h
  rbpa/core/progress.h>rbpa/base/progress.h
  rbpa/core/triangle_arrays.h>rbpa/base/triangle_arrays.h
  rbpa/shape/boundary_curves.h>rbpa/boundary_curves.h
  rbpa/core/complex.h>rbpa/complex.h
  rbpa/partial/corner_polygon.h>rbpa/corner_polygon.h
  rbpa/shape/coverage.h>rbpa/coverage.h
  rbpa/filtration/covering.h>rbpa/covering.h
  rbpa/space/normals/estimate_normals.h>rbpa/estimate_normals.h
  rbpa/space/facing_sides.h>rbpa/facing_sides.h
  rbpa/fill/fill.h>rbpa/fill.h
  rbpa/filtration/filtration.h>rbpa/filtration.h
  rbpa/filtration/filtration_arrays.h>rbpa/filtration_arrays.h
  rbpa/space/holes.h>rbpa/holes.h
  rbpa/filtration/level_topology.h>rbpa/level_topology.h
  rbpa/shape/link_triangles.h>rbpa/link_triangles.h
  rbpa/core/mesh.h>rbpa/mesh.h
  rbpa/partial/partial.h>rbpa/partial.h
  rbpa/partial/bytes.h>rbpa/partial_bytes.h
  rbpa/filtration/persistence.h>rbpa/persistence.h
  rbpa/filtration/plateaus.h>rbpa/plateaus.h
  rbpa/fill/polygons_of_rings.h>rbpa/polygons_of_rings.h
  rbpa/partial/region.h>rbpa/region.h
  rbpa/space/rolling_ball.h>rbpa/rolling_ball.h
  rbpa/shape/polygons.h>rbpa/shape.h
  rbpa/space/surface.h>rbpa/surface.h
  rbpa/space/surface_levels.h>rbpa/surface_levels.h
  rbpa/space/surface_mesh.h>rbpa/surface_mesh.h
  rbpa/space/unused.h>rbpa/unused.h
  rbpa/fill/validity.h>rbpa/validity.h)
set(forwarding ${CMAKE_CURRENT_BINARY_DIR}/forwarding)
foreach(pair ${forwarded})
  string(REGEX MATCH "^(.*)>(.*)$" _ ${pair})
  set(content "// Moved: include \"${CMAKE_MATCH_2}\".\n#pragma once\n\n#include \"${CMAKE_MATCH_2}\"  // IWYU pragma: export\n")
  file(CONFIGURE OUTPUT ${forwarding}/${CMAKE_MATCH_1} CONTENT "${content}" @ONLY)
endforeach()
target_include_directories(rbpa PUBLIC $<BUILD_INTERFACE:${forwarding}>)
install(DIRECTORY ${forwarding}/rbpa DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
