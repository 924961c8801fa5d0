// What: the contestants rbpa, hrbpa and CGAL, and the result of a run.
// Law:  on the same points and alpha all contestants that accept alpha find the same number of triangles.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/hrbpa.h"
#include "rbpa/plane/triangles_by_level.h"
#include "support/triangle.h"

namespace rbpa_bench {

using Triangles = std::vector<rbpa_test::Triangle>;

/// Clock of a measured time.
enum class Clock {
  here,     ///< this process: from points in memory to the finished result; freeing it is not counted
  peer,     ///< another program's own
  process,  ///< from the start to the end of another program, its files included
};

struct Run {
  double seconds;
  std::size_t triangles;
  Clock clock = Clock::here;
  std::optional<double> process_bytes = {};      ///< the peak of another program, all of it
  std::optional<double> processor_seconds = {};  ///< processor seconds of all threads, if the clock is ours
};

/// Contestant: computes triangles of points.
struct Contestant {
  std::string name;
  /// If the result is a list of input indices, or can be converted to one after the measured time, it is left in `list`
  /// unless that is null. Throws std::runtime_error when there is no result.
  std::function<Run(std::span<const rbpa::Point> points, double alpha, Triangles* list)> run;
  bool takes_alpha = true;  ///< if false, it finds all Delaunay triangles whatever alpha is
  bool is_program = false;  ///< another program, whose memory is measured from outside
};

/// Runs rbpa::rbpa(): a halfedge mesh with input indices. 0 threads: one for each processor.
Run run_rbpa(std::span<const rbpa::Point> points, double alpha, unsigned threads = 1, Triangles* list = nullptr);

/// Runs rbpa::alpha_complex(): triangles in canonical order as arrays, on request with neighbors.
Run run_arrays(std::span<const rbpa::Point> points, double alpha, unsigned threads = 1, bool neighbors = false,
               Triangles* list = nullptr);

/// Run rbpa() and hrbpa() of the paper.
Run run_paper_rbpa(std::span<const rbpa::Point> points, double alpha);
Run run_paper_hrbpa(std::span<const rbpa::Point> points, double alpha);

/// Runs rbpa::hrbpa(): the mesh of rbpa(), from the bottom up, with one thread.
Run run_hrbpa(std::span<const rbpa::Point> points, double alpha);
constexpr std::size_t usual_leaves = rbpa::usual_leaf_capacity;
Run run_hrbpa_with(std::span<const rbpa::Point> points, double alpha, std::size_t leaf_capacity);

/// Filter of triangles by circumradius, in plain double arithmetic.
enum class Filter { none, circumradius };

/// Runs CGAL's Delaunay triangulation with input indices, to a list of index triples.
Run run_cgal_indices(std::span<const rbpa::Point> points, double alpha, Filter filter, Triangles* list = nullptr);

/// Runs CGAL's best case: its triangulation of a range of its own points, which it sorts, without indices. The result
/// is the triangulation itself, or, with a filter, a list of its faces.
Run run_cgal_points(std::span<const rbpa::Point> points, double alpha, Filter filter);

/// Runs CGAL's Alpha_shape_2: the faces that it classifies as interior at alpha.
Run run_cgal_alpha_shape(std::span<const rbpa::Point> points, double alpha);

Contestant rbpa_with(unsigned threads);
Contestant arrays_with(unsigned threads);
Contestant neighbors_with(unsigned threads);
extern const Contestant paper_rbpa, paper_hrbpa;
extern const Contestant hrbpa;
extern const Contestant cgal_indices;  ///< without a filter
extern const Contestant cgal_indices_filtered;
extern const Contestant cgal_points;  ///< without a filter
extern const Contestant cgal_points_filtered;
extern const Contestant cgal_alpha_shape;

}  // namespace rbpa_bench
