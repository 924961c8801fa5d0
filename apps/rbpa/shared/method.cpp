#include "shared/method.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "io/failure.h"
#include "io/interrupt.h"
#include "io/number.h"
#include "io/sort.h"
#include "rbpa/paper.h"
#include "rbpa/plane/link_triangles.h"
#include "rbpa/plane/triangles_by_level.h"
#include "rbpa/rbpa.h"
#include "shared/progress.h"

namespace rbpa::app {
namespace {

bool is_by_paper(const std::string& search) {
  if (search != "near" && search != "paper") bad_usage("--search", in_quotes(search), "near or paper");
  return search == "paper";
}

}  // namespace

Method parse_method(const MethodArguments& arguments) {
  Method method{.by_paper = is_by_paper(arguments.search)};
  if (arguments.method != "rbpa" && arguments.method != "hrbpa")
    bad_usage("--method", in_quotes(arguments.method), "rbpa or hrbpa");
  const bool hierarchical = arguments.method == "hrbpa";
  if (arguments.leaf_capacity && !hierarchical) throw WrongUsage("--leaf-capacity requires --method hrbpa");
  if (hierarchical)
    method.leaf_capacity = arguments.leaf_capacity
                               ? parse_whole("--leaf-capacity", *arguments.leaf_capacity, {.least = 1}, "points")
                           : method.by_paper ? paper::usual_leaf_capacity
                                             : usual_leaf_capacity;
  return method;
}

namespace {

Hierarchy build_mesh(const std::vector<Point>& points, double alpha, const Method& method, unsigned threads,
                     const std::function<bool(const Progress&)>& progress) {
  if (!method.leaf_capacity) {
    const auto of_one_radius = method.by_paper ? paper::rbpa : rbpa;
    return {.complex = of_one_radius(points, alpha, {.threads = threads, .progress = progress}), .levels = {}};
  }
  const auto by_levels = method.by_paper ? paper::hrbpa : hrbpa;
  return by_levels(points, alpha, {.leaf_capacity = *method.leaf_capacity, .threads = threads, .progress = progress});
}

/// Returns the boundary edges of the complex in the form of AlphaComplex::boundary.
std::vector<std::array<std::uint32_t, 2>> boundary_of(const SolidAlphaComplex& complex) {
  std::vector<std::array<std::uint32_t, 2>> boundary;
  const Mesh& mesh = complex.mesh;
  const auto point = [&](meshops::Vertex v) { return complex.input_index[static_cast<std::size_t>(v.idx())]; };
  InterruptibleSteps step;
  for (const meshops::Halfedge halfedge : mesh.halfedges()) {  // halfedges on the boundary run against the triangles
    step();
    if (mesh.is_boundary(halfedge))
      boundary.push_back({point(mesh.to_vertex_handle(halfedge)), point(mesh.from_vertex_handle(halfedge))});
  }
  sort(boundary);
  return boundary;
}

/// Returns the number of the level of each triangle. Requires: `triangles` are sorted.
std::vector<std::uint16_t> levels_of(const std::vector<Triangle>& triangles, const Hierarchy& made) {
  std::vector<std::uint16_t> level(triangles.size());
  InterruptibleSteps step;
  for (const auto face : made.complex.mesh.faces()) {
    step();
    Triangle corners{};
    std::size_t i = 0;
    for (const auto v : face.vertices()) corners[i++] = made.complex.input_index[static_cast<std::size_t>(v.idx())];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const auto at = std::lower_bound(triangles.begin(), triangles.end(), corners) - triangles.begin();
    const std::size_t position = level_of(made, static_cast<std::size_t>(face.idx()));
    level[static_cast<std::size_t>(at)] = static_cast<std::uint16_t>(made.levels[position].number);
  }
  return level;
}

Built build_levels(const std::vector<Point>& points, double alpha, std::size_t leaf_capacity, Links links,
                   unsigned threads, const std::function<bool(const Progress&)>& progress) {
  TrianglesByLevel made = triangles_by_level(points, alpha,
                                             {.leaf_capacity = leaf_capacity,
                                              .neighbors = links == Links::neighbors,
                                              .boundary = links == Links::boundary,
                                              .threads = threads,
                                              .progress = progress});
  for (std::uint16_t& level : made.level) level = static_cast<std::uint16_t>(made.levels[level].number);
  return {.complex = std::move(made.complex), .level = std::move(made.level)};
}

}  // namespace

Built build(const std::vector<Point>& points, double alpha, const Method& method, ComplexKind kind, Links links,
            const RunOptions& run, bool with_mesh) {
  Built built;
  AlphaComplex& arrays = built.complex;
  {
    TriangleProgress progress(!run.quiet, "triangulating", progress_text);
    if (!method.by_paper && !with_mesh)
      return method.leaf_capacity
                 ? build_levels(points, alpha, *method.leaf_capacity, links, run.threads, progress.watch())
                 : Built{.complex = alpha_complex(points, alpha,
                                                  {.complex = kind,
                                                   .neighbors = links == Links::neighbors,
                                                   .boundary = links == Links::boundary,
                                                   .threads = run.threads,
                                                   .progress = progress.watch()}),
                         .level = {}};
    Hierarchy made = build_mesh(points, alpha, method, run.threads, progress.watch());
    arrays.triangles = triangles(made.complex);
    arrays.isolated = made.complex.isolated;
    arrays.duplicates = made.complex.duplicates;
    arrays.distinct = made.complex.distinct;
    if (method.leaf_capacity) built.level = levels_of(arrays.triangles, made);
    if (links == Links::boundary) arrays.boundary = boundary_of(made.complex);
    if (with_mesh) built.mesh = std::move(made);
  }  // free the mesh before neighbors are computed
  if (links == Links::neighbors)
    arrays.neighbors = link_triangles(arrays.triangles, points.size(), until_interrupted());
  return built;
}

Delaunay build_delaunay(const std::vector<Point>& points, const RunOptions& run) {
  TriangleProgress progress(!run.quiet, "triangulating", progress_text);
  return Delaunay(points, {.threads = run.threads, .progress = progress.watch()});
}

}  // namespace rbpa::app
