// Fills the same polygon by the library and by CGAL.
#pragma once

#include <cstddef>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_bench {

struct FillRun {
  std::size_t triangles;
  double seconds;  ///< processor time: other processes may share the machine
};

/// Fills one ring by the library. At a size of infinity no point is added.
FillRun fill_by_rbpa(const std::vector<rbpa::Point>& ring, double size, bool graded);
/// Runs CGAL's Delaunay refinement: angles of at least 20.7° and no edge longer than `longest`.
FillRun fill_by_cgal(const std::vector<rbpa::Point>& ring, double longest);
/// Runs CGAL's constrained Delaunay triangulation, including the outside of the ring.
FillRun triangulate_by_cgal(const std::vector<rbpa::Point>& ring);

}  // namespace rbpa_bench
