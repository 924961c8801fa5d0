#include "meshtopo/generators.h"

#include <algorithm>
#include <cmath>

#include "io/interrupt.h"
#include "meshops/core/live.h"
#include "meshops/topology/homology.h"

namespace rbpa::app {
namespace {

using meshops::Connectivity;

/// By edge index. Coordinates are scaled into [−1, 1], so that no length and no sum of lengths overflows.
std::vector<double> edge_lengths(const Connectivity& mesh, std::span<const std::uint32_t> point_of,
                                 std::span<const std::array<double, 3>> positions) {
  double greatest = 0;
  for (const auto& p : positions)
    for (const double coordinate : p) greatest = std::max(greatest, std::abs(coordinate));
  const int exponent = greatest > 0 ? std::ilogb(greatest) + 1 : 0;
  std::vector<double> lengths(mesh.n_edges(), 0);
  std::size_t done = 0;
  meshops::for_each_edge(mesh, [&](meshops::Edge e) {
    if (++done % 16384 == 0) stop_if_interrupted();
    const auto position = [&](meshops::Vertex v) { return positions[point_of[static_cast<std::size_t>(v.idx())]]; };
    const meshops::Halfedge h = mesh.halfedge_handle(e, 0);
    const std::array<double, 3> a = position(mesh.from_vertex_handle(h)), b = position(mesh.to_vertex_handle(h));
    const auto difference = [&](std::size_t i) { return std::scalbn(a[i], -exponent) - std::scalbn(b[i], -exponent); };
    lengths[static_cast<std::size_t>(e.idx())] = std::hypot(difference(0), difference(1), difference(2));
  });
  return lengths;
}

}  // namespace

std::vector<Polyline> generators(const Connectivity& mesh, std::span<const std::uint32_t> point_of,
                                 std::span<const std::array<double, 3>> positions) {
  std::vector<Polyline> polylines;
  const std::vector<double> lengths = edge_lengths(mesh, point_of, positions);
  for (const meshops::Loop& loop : meshops::homology_generators(mesh, lengths, until_interrupted())) {
    Polyline& polyline = polylines.emplace_back();
    for (const meshops::Halfedge h : loop)
      polyline.push_back(point_of[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())]);
  }
  return polylines;
}

}  // namespace rbpa::app
