#include "meshtopo/generators.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <cmath>

#include "io/interrupt.h"
#include "meshops/core/live.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/shortest_loops.h"

namespace rbpa::app {
namespace {

using meshops::Connectivity;

/// Coordinates times the power of two are in [−1, 1], so that no length and no sum of lengths overflows.
int scale_of(std::span<const std::array<double, 3>> positions) {
  double greatest = 0;
  for (const auto& p : positions)
    for (const double coordinate : p) greatest = std::max(greatest, std::abs(coordinate));
  return greatest > 0 ? -(std::ilogb(greatest) + 1) : 0;
}

/// By edge index.
std::vector<double> edge_lengths(const Connectivity& mesh, std::span<const std::uint32_t> point_of,
                                 std::span<const std::array<double, 3>> positions, int exponent) {
  std::vector<double> lengths(mesh.n_edges(), 0);
  std::size_t done = 0;
  meshops::for_each_edge(mesh, [&](meshops::Edge e) {
    if (++done % 16384 == 0) stop_if_interrupted();
    const auto position = [&](meshops::Vertex v) { return positions[point_of[static_cast<std::size_t>(v.idx())]]; };
    const meshops::Halfedge h = mesh.halfedge_handle(e, 0);
    const std::array<double, 3> a = position(mesh.from_vertex_handle(h)), b = position(mesh.to_vertex_handle(h));
    const auto difference = [&](std::size_t i) { return std::scalbn(a[i], exponent) - std::scalbn(b[i], exponent); };
    lengths[static_cast<std::size_t>(e.idx())] = std::hypot(difference(0), difference(1), difference(2));
  });
  return lengths;
}

/// With find(mesh, lengths, exponent of their scale), loops.
template <typename Find>
std::vector<Polyline> find_generators(const meshops::PolygonSoup& soup,
                                      std::span<const std::array<double, 3>> positions, Find find) {
  OpenMesh::PolyConnectivity mesh;
  const std::vector<std::uint32_t> point_of = meshops::build_mesh(mesh, soup, until_interrupted());
  const int exponent = scale_of(positions);
  const std::vector<double> lengths = edge_lengths(mesh, point_of, positions, exponent);
  std::vector<Polyline> found;
  for (const meshops::Loop& loop : find(mesh, lengths, exponent)) {
    Polyline& points = found.emplace_back();
    for (const meshops::Halfedge h : loop)
      points.push_back(point_of[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())]);
  }
  return found;
}

}  // namespace

std::vector<Polyline> generators(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions) {
  return find_generators(soup, positions, [](const Connectivity& mesh, const std::vector<double>& lengths, int) {
    return meshops::homology_generators(mesh, lengths, until_interrupted());
  });
}

std::vector<Polyline> shortest_generators(const meshops::PolygonSoup& soup,
                                          std::span<const std::array<double, 3>> positions, double below) {
  return find_generators(
      soup, positions, [below](const Connectivity& mesh, const std::vector<double>& lengths, int exponent) {
        return meshops::shortest_homology_loops(mesh, lengths, std::scalbn(below, exponent), until_interrupted());
      });
}

}  // namespace rbpa::app
