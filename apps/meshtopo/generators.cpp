#include "meshtopo/generators.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <cmath>

#include "io/interrupt.h"
#include "meshops/core/live.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/homology.h"
#include "meshops/topology/loop_kinds.h"
#include "meshops/topology/shortest_loops.h"

namespace rbpa::app {
namespace {

using meshops::Connectivity;

/// Returns the exponent of a power of two that scales coordinates into [−1, 1], so that no sum of lengths overflows.
int scale_of(std::span<const std::array<double, 3>> positions) {
  double greatest = 0;
  for (const auto& p : positions)
    for (const double coordinate : p) greatest = std::max(greatest, std::abs(coordinate));
  return greatest > 0 ? -(std::ilogb(greatest) + 1) : 0;
}

/// Returns the length of each edge, multiplied by 2^exponent, by edge index.
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

/// The surface as a halfedge mesh, with the lengths of its edges.
struct Measured {
  OpenMesh::PolyConnectivity mesh;
  std::vector<std::uint32_t> point_of;  // number of the point of each vertex
  int exponent;                         // lengths are multiplied by 2^exponent
  std::vector<double> lengths;

  Measured(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions)
      : point_of(meshops::build_mesh(mesh, soup, until_interrupted())),
        exponent(scale_of(positions)),
        lengths(edge_lengths(mesh, point_of, positions, exponent)) {}

  Polyline points_of(const meshops::Loop& loop) const {
    Polyline points;
    for (const meshops::Halfedge h : loop)
      points.push_back(point_of[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())]);
    return points;
  }
};

constexpr std::array<std::string_view, 5> kind_names{"handle", "tunnel", "neither", "both", "unknown"};

}  // namespace

Generators generators(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions,
                      bool shortest) {
  const Measured of(soup, positions);
  const std::vector<meshops::Loop> loops =
      shortest ? meshops::shortest_homology_basis(of.mesh, of.lengths, until_interrupted())
               : meshops::homology_generators(of.mesh, of.lengths, until_interrupted());
  std::vector<std::array<double, 3>> places;  // scaled position of each vertex
  for (const std::uint32_t point : of.point_of) {
    auto& place = places.emplace_back(positions[point]);
    for (double& coordinate : place) coordinate = std::scalbn(coordinate, of.exponent);
  }
  const std::vector<meshops::LoopKind> kinds = meshops::loop_kinds(of.mesh, places, loops, until_interrupted());
  Generators result;
  for (std::size_t kind = 0; kind < kind_names.size(); ++kind)
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (static_cast<std::size_t>(kinds[i]) != kind) continue;
      result.loops.push_back(of.points_of(loops[i]));
      result.kinds.push_back(kind_names[kind]);
    }
  return result;
}

std::vector<Polyline> shortest_generators(const meshops::PolygonSoup& soup,
                                          std::span<const std::array<double, 3>> positions, double below) {
  const Measured of(soup, positions);
  std::vector<Polyline> found;
  for (const meshops::Loop& loop :
       meshops::shortest_homology_loops(of.mesh, of.lengths, std::scalbn(below, of.exponent), until_interrupted()))
    found.push_back(of.points_of(loop));
  return found;
}

}  // namespace rbpa::app
