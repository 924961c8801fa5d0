#include "rbpa/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/input.h"
#include "rbpa/collinear.h"
#include "rbpa/plane/arrays/boundary_sides.h"
#include "rbpa/plane/arrays/dangling.h"
#include "rbpa/plane/arrays/keep_triangles.h"
#include "rbpa/plane/arrays/linked_triangles.h"
#include "rbpa/plane/arrays/outlined_triangles.h"
#include "rbpa/plane/arrays/triangle_list.h"
#include "rbpa/plane/divide/small_set.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/patches/for_each_patch.h"

namespace rbpa {
namespace {

/// Puts patches into a list, which is TriangleList or LinkedTriangles.
template <typename List>
struct ListSink {
  using Share = typename List::Place;
  static constexpr bool needs_outline = false;

  void prepare(const TilePatch& tile, Share& share) { list.prepare(tile.patch, share); }
  void place(const TilePatch& tile, Share& share) { list.place(tile.patch, share); }
  void fill(const TilePatch& tile, Share& share) { list.fill(tile.patch, share); }
  void worked() {
    if (progress && !progress({list.size(), points})) throw Cancelled();
  }

  List& list;
  std::size_t points;
  const std::function<bool(const Progress&)>& progress;
};

template <typename List>
void find_triangles(const Sites& sites, double alpha, const std::function<bool(const Progress&)>& progress,
                    Threads& threads, List& list) {
  ListSink<List> sink{list, sites.size(), progress};
  const meshops::Patch rest = for_each_patch(sites, Radius::of(alpha), threads, sink);
  typename List::Place place;
  list.prepare(rest, place);
  list.place(rest, place);
  list.fill(rest, place);
  sink.worked();
}

std::vector<std::array<std::uint32_t, 2>> boundary_of(const Triangulation& of, const std::function<void()>& ask) {
  return boundary_sides(of, [&ask, t = 0u]() mutable {
    if (t++ % (1u << 18) == 0 && ask) ask();
  });
}

void triangulate_on_tiles(std::span<const Point> points, double alpha, const TriangulationOptions& options,
                          Triangulation& result) {
  Threads threads = threads_for(points.size(), options.threads);
  std::optional<Sites> sites(std::in_place, points, threads, asking(options.progress, points.size()));
  result.distinct = sites->size();
  result.duplicates = sites->duplicates();
  const bool are_on_a_line = are_collinear(points);
  const auto find = [&](auto& list) {
    if (!are_on_a_line) find_triangles(*sites, alpha, options.progress, threads, list);
    const std::function<void()> ask = asking(options.progress, result.distinct, list.size());
    sites.reset();  // its memory is not needed where the list becomes the result
    return list.sorted(threads, ask);
  };
  if (options.neighbors) {
    LinkedTriangles list(sites->size(), sites->input_index(), points.size(), threads);
    OwnedTriangles sorted = find(list);
    result.triangles = std::move(sorted.triangles);
    result.neighbors = std::move(sorted.neighbors);
  } else if (options.boundary) {
    OutlinedTriangles list(sites->size(), sites->input_index(), points.size(), threads);
    result.triangles = find(list);
    result.boundary = list.boundary();
  } else {
    TriangleList list(sites->size(), sites->input_index(), points.size(), threads);
    result.triangles = find(list);
  }
  // Without a radius all points are in triangles, if there are any.
  if (are_on_a_line || std::isfinite(alpha)) result.isolated = isolated_in(result, points.size());
}

/// The triangles of a radius, and what becomes of points.
Triangulation solid(std::span<const Point> points, double alpha, const TriangulationOptions& options) {
  Triangulation result;
  if (points.size() >= small_set_limit || !triangulate_small_set(points, alpha, options, result))
    triangulate_on_tiles(points, alpha, options, result);
  const std::function<void()> ask = asking(options.progress, result.distinct, result.triangles.size());
  if (options.boundary && result.boundary.empty()) result.boundary = boundary_of(result, ask);
  if (!options.neighbors) result.neighbors = std::vector<Triangle>();
  return result;
}

}  // namespace

Triangulation triangulate(std::span<const Point> points, double alpha, const TriangulationOptions& options) {
  check(points, alpha);
  if (options.complex == Complex::solid) return solid(points, alpha, options);
  TriangulationOptions of_delaunay = options;
  of_delaunay.neighbors = true;
  of_delaunay.boundary = false;
  Triangulation result = solid(points, std::numeric_limits<double>::infinity(), of_delaunay);
  result.edges = dangling_edges(points, alpha, result);
  keep_within(points, alpha, result);
  result.isolated = isolated_in(result, points.size());
  std::vector<std::uint8_t> covered(points.size(), 1);
  for (const std::uint32_t i : result.isolated) covered[i] = 0;
  for (const auto& [a, b] : result.edges) covered[a] = covered[b] = 1;
  result.points = unmarked(covered, result.duplicates);
  if (options.boundary)
    result.boundary = boundary_of(result, asking(options.progress, result.distinct, result.triangles.size()));
  if (!options.neighbors) result.neighbors = std::vector<Triangle>();
  return result;
}

}  // namespace rbpa
