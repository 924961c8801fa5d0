// What: the task of the contestants of bench_operators: a mesh as triangles, and the sites at which to operate, in
//       order.
// Law:  a task is made from fixed seeds; at every site the operation is allowed when its turn comes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace meshops_bench {

enum class Operation {
  split_edge,
  split_face,
  flip,
  collapse,
  split_vertex,
  open_curve,
  close_curve,
  add_triangles,
  build_mesh,
  sew_curves
};

std::string_view name(Operation operation);

using Corners = std::array<std::uint32_t, 3>;

/// Site: an edge or halfedge by its two ends; a face by its corners; a vertex to split, with the ends of left and
///       right.
using Site = Corners;

struct Task {
  Operation operation;
  std::uint32_t vertices = 0;
  std::vector<Corners> triangles;
  std::vector<Site> sites = {};  ///< empty if the operation is for the whole mesh
  std::size_t steps = 0;         ///< number of operations in a pass, by which the time is divided
};

enum class Ground {
  grid,   ///< rows of squares in two triangles each, in order
  random  ///< a grid after as many random flips as it has edges, with vertices and triangles in random order
};

std::string_view name(Ground ground);

Task make_task(Operation operation, Ground ground);

}  // namespace meshops_bench
