// What: the methods rbpa, hrbpa, CGAL and any other program as contestants on points in the plane, and their runs in
//       fresh processes.
// Law:  on the same points and alpha all methods that take alpha find the same number of triangles.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/triangles_by_level.h"
#include "support/triangle.h"

namespace rbpa_bench {

using Triangles = std::vector<rbpa_test::Triangle>;

/// Computes triangles of points.
struct Method {
  std::string name;
  /// If the result is a list of input indices, or can be converted to one after the measured time, it is left in `list`
  /// unless that is null. Throws std::runtime_error when there is no result.
  std::function<Run(std::span<const rbpa::Point> points, double alpha, Triangles* list)> run;
  bool takes_alpha = true;  ///< if false, it finds all Delaunay triangles whatever alpha is
};

Method rbpa_with(unsigned threads);       ///< rbpa::rbpa(): a halfedge mesh with input indices
Method arrays_with(unsigned threads);     ///< rbpa::alpha_complex(): triangles in canonical order as arrays
Method neighbors_with(unsigned threads);  ///< rbpa::alpha_complex() with neighbors
/// Returns rbpa::hrbpa() with one thread: the mesh of rbpa(), from the bottom up.
Method hrbpa(std::size_t leaf_capacity = rbpa::usual_leaf_capacity);
Method paper_rbpa();
Method paper_hrbpa();

/// Return CGAL's Delaunay triangulation as methods: of points with input indices, to a list of index triples; and of
/// points alone, which CGAL sorts itself, its best case. The filtered ones list only triangles of circumradius at most
/// alpha, compared in plain double arithmetic.
Method cgal_indices();
Method cgal_indices_filtered();
Method cgal_points();
Method cgal_points_filtered();
/// Returns CGAL's Alpha_shape_2: the faces that it classifies as interior at alpha.
Method cgal_alpha_shape();

/// Returns the methods as contestants on these points, which are not copied.
std::vector<Contestant> on(std::span<const rbpa::Point> points, double alpha, const std::vector<Method>& methods);

/// Runs the methods again and compares the triangles themselves with those of the first method, as sets.
void compare_sets(std::span<const rbpa::Point> points, double alpha, const std::vector<Method>& methods,
                  Contest& contest);

/// Returns any program as a method, of an argument NAME=COMMAND. The shell runs the command with two file names behind
/// it: points to read, as native float64 pairs x y x y …, and triangles to write, as native uint32 triples of indices
/// into them. Its time is the value of a line `seconds VALUE` on its standard error, or else that of its whole process,
/// files included. It finds all Delaunay triangles. A run throws std::runtime_error when the command ended with a code
/// or a signal, wrote no triangles or an incomplete one, or named a point that does not exist. Throws
/// std::invalid_argument when the argument has no name or no command.
Method peer(const std::string& argument);

/// Returns the methods of cold runs: the meshes and arrays of one thread and two, and CGAL.
const std::vector<Method>& cold_methods();

struct ColdRun {
  Run run;
  double bytes;  ///< peak rise of resident memory above the state with the points loaded
};

/// Runs the cold method of that number on a file of points (write_values()), in a fresh process of this program, with
/// page faults: the cost for the user of a program. Its main() begins with answer_cold_run().
ColdRun run_cold(std::size_t method, const std::string& points_file);

/// Ends the process of a cold run, after printing its result; does nothing in any other process.
void answer_cold_run(int argc, char** argv);

}  // namespace rbpa_bench
