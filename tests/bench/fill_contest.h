// Fills of the same polygon, by the library and by CGAL.
#pragma once

#include <cstddef>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_bench {

struct FillRun {
  std::size_t triangles;
  double seconds;  ///< of the processor: others may share the machine
};

/// Of what is in one ring. At a size of infinity no point is added.
FillRun fill_by_rbpa(const std::vector<rbpa::Point>& ring, double size, bool graded);
/// CGAL's Delaunay refinement: angles of at least 20.7° and no edge longer than `longest`.
FillRun fill_by_cgal(const std::vector<rbpa::Point>& ring, double longest);
/// CGAL's constrained Delaunay triangulation, with what is outside of the ring.
FillRun triangulate_by_cgal(const std::vector<rbpa::Point>& ring);

}  // namespace rbpa_bench
