#include "rbpa/triangulate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "rbpa/arrays/canonical_order.h"
#include "rbpa/arrays/dangling.h"
#include "rbpa/arrays/triangle_list.h"
#include "rbpa/collinear.h"
#include "rbpa/core/error.h"
#include "rbpa/patches/for_each_patch.h"
#include "rbpa/run/input.h"
#include "rbpa/search/sites.h"

namespace rbpa {
namespace {

constexpr std::size_t triangles_at_a_time = 1u << 16;

/// All but what is told of points.
struct Run {
  std::span<const Point> points;
  double alpha;
  const TriangulationOptions& options;
  bool with_neighbors;
  Threads& threads;

  /// Tiles tell what they can, and the remainder what is missing.
  TriangleList::Lists find_triangles(const Sites& sites) const {
    TriangleList list(sites.size(), sites.input_index(), with_neighbors);
    const auto worked = [&] {
      if (options.progress && !options.progress({list.size(), sites.size()})) throw Cancelled();
    };
    using Place = TriangleList::Place;
    const meshops::Patch rest =
        for_each_patch<Place>(
            sites, Radius::of(alpha), threads,
            [&](const TilePatch& tile, Place& place) { list.prepare(tile.patch, place); },
            [&](const TilePatch& tile, Place& place) { list.place(tile.patch, place); },
            [&](const TilePatch& tile, Place& place) { list.fill(tile.patch, place); }, worked, false)
            .patch;
    Place place;
    list.prepare(rest, place);
    list.place(rest, place);
    list.fill(rest, place);
    worked();
    return list.take();
  }

  void sort(TriangleList::Lists lists, Triangulation& result) const {
    if (!with_neighbors) {
      sort_canonically(lists.triangles, points.size(), threads);
      result.triangles.assign(lists.triangles.begin(), lists.triangles.end());
      return;
    }
    meshops::FreshVector<std::uint32_t> rank;
    sort_canonically(lists.triangles, points.size(), threads, &rank);
    result.triangles.assign(lists.triangles.begin(), lists.triangles.end());
    lists.triangles = {};
    result.neighbors.resize(rank.size());
    for_each_part(threads, rank.size(), triangles_at_a_time, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t other = lists.neighbors[t][k];
          result.neighbors[rank[t]][k] = other == TriangleList::none ? Triangulation::none : rank[other];
        }
    });
  }
};

/// The sides at which nothing lies, by the triangles and their neighbours.
std::vector<std::array<std::uint32_t, 2>> boundary_of(const Triangulation& of) {
  std::vector<std::array<std::uint32_t, 2>> boundary;
  for (std::size_t t = 0; t < of.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (of.neighbors[t][k] == Triangulation::none)
        boundary.push_back({of.triangles[t][(k + 1) % 3], of.triangles[t][(k + 2) % 3]});
  std::sort(boundary.begin(), boundary.end());
  return boundary;
}

/// The indices that are not marked and not those of duplicates, ascending.
std::vector<std::uint32_t> others(const std::vector<std::uint8_t>& marked, const std::vector<Duplicate>& duplicates) {
  std::vector<std::uint32_t> found;
  auto duplicate = duplicates.begin();
  for (std::uint32_t i = 0; i < marked.size(); ++i) {
    if (duplicate != duplicates.end() && duplicate->index == i)
      ++duplicate;
    else if (marked[i] == 0)
      found.push_back(i);
  }
  return found;
}

std::vector<std::uint32_t> isolated_in(const Triangulation& of, std::size_t points) {
  std::vector<std::uint8_t> covered(points, 0);
  for (const auto& t : of.triangles)
    for (const std::uint32_t i : t) covered[i] = 1;
  return others(covered, of.duplicates);
}

/// The triangles of a radius and what is told of them.
Triangulation solid(std::span<const Point> points, double alpha, const TriangulationOptions& options) {
  Triangulation result;
  Threads threads = threads_for(points.size(), options.threads);
  const Run run{points, alpha, options, options.neighbors || options.boundary, threads};
  std::optional<TriangleList::Lists> lists;
  {
    const Sites sites(points, threads, asking(options.progress, points.size()));
    result.distinct = sites.size();
    result.duplicates = sites.duplicates();
    if (!are_collinear(points)) lists = run.find_triangles(sites);
  }
  if (lists) run.sort(std::move(*lists), result);
  result.isolated = isolated_in(result, points.size());
  if (options.boundary) result.boundary = boundary_of(result);
  if (!options.neighbors) result.neighbors = {};
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
  result.points = others(covered, result.duplicates);
  if (options.boundary) result.boundary = boundary_of(result);
  if (!options.neighbors) result.neighbors = {};
  return result;
}

}  // namespace rbpa
