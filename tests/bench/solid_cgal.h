// What: runs CGAL's Delaunay_triangulation_3 as a user who wants tetrahedra does: points alone, default options, one
//       thread.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa_bench {

struct SolidRun {
  std::size_t tetrahedra;
  double seconds;  ///< processor time: other processes may share the machine
};

/// Inserts the points, and counts the finite cells of circumradius at most alpha, in rounded numbers.
SolidRun solid_by_cgal(std::span<const rbpa::Point3> points, double alpha);

}  // namespace rbpa_bench
