// What: what is measured: the contestants, and the points they run on.
// Law:  on the same points and alpha both contestants find the same number of triangles.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "rbpa/core/point.h"
#include "support/triangle.h"

namespace rbpa_bench {

/// One run: from points in memory to the finished result. Freeing the result and what led to it is not counted.
struct Run {
  double seconds;
  std::size_t triangles;
};

struct Contestant {
  std::string_view name;
  Run (*run)(std::span<const rbpa::Point> points, double alpha);
};

/// rbpa::rbpa(): a halfedge mesh with input indices.
Run run_rbpa(std::span<const rbpa::Point> points, double alpha);

/// rbpa::hrbpa(): the same mesh, from the bottom up.
Run run_hrbpa(std::span<const rbpa::Point> points, double alpha);
Run run_hrbpa_with(std::span<const rbpa::Point> points, double alpha, std::size_t leaf_capacity);

/// The same by the paper's grid.
Run run_rbpa_paper_grid(std::span<const rbpa::Point> points, double alpha);

/// CGAL's Delaunay triangulation with input indices, filtered by circumradius in plain double arithmetic, to a list of
/// index triples.
Run run_cgal(std::span<const rbpa::Point> points, double alpha);

inline constexpr Contestant rbpa_near_to_far{"rbpa", run_rbpa};
inline constexpr Contestant hrbpa{"hrbpa", run_hrbpa};
inline constexpr Contestant rbpa_paper_grid{"rbpa_paper_grid", run_rbpa_paper_grid};
inline constexpr Contestant cgal{"cgal", run_cgal};

/// A kind of point set; of mean spacing 1 where it is even.
struct Workload {
  std::string_view name;
  rbpa_test::Points (*make)(std::size_t count);
};

extern const Workload uniform;
extern const Workload jittered;  ///< a grid whose points are moved by up to 0.45 of its pitch in either direction
extern const Workload grid;
extern const Workload clusters;  ///< a hundred Gaussian clusters of equal number whose widths span three decades
extern const Workload kuzmin;    ///< a heavy centre: density falls with the third power of the distance
extern const Workload lidar;     ///< scan lines at map coordinates, quantised to a hundredth
extern const Workload decades;   ///< spacing grows with the distance from the centre, from 1 to 1000

/// Half of the points lie twice as dense as the others, as in the paper's figure 9.
rbpa_test::Points two_level_sampling(std::size_t count);

}  // namespace rbpa_bench
