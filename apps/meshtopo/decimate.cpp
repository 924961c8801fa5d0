#include "meshtopo/decimate.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <utility>
#include <vector>

#include "io/interrupt.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/topology/build_mesh.h"
#include "rbpa/space/simplify/decimate_mesh.h"

namespace rbpa::app {
namespace {

/// Calls change(halfedges, places) with the halfedge mesh of `mesh` and its positions, and returns the changed mesh.
template <typename Change>
MeshFile changed(const MeshFile& mesh, Change change) {
  OpenMesh::PolyConnectivity halfedges;
  std::vector<Point3> places;
  for (const std::uint32_t point : meshops::build_mesh(halfedges, mesh.soup, until_interrupted())) {
    const auto& [x, y, z] = mesh.positions[point];
    places.push_back({x, y, z});
  }
  meshops::request_status(halfedges);
  change(halfedges, places);
  MeshFile result;
  std::vector<std::uint32_t> number(places.size());
  for (const meshops::Vertex v : meshops::live_vertices(halfedges)) {
    const Point3& p = places[static_cast<std::size_t>(v.idx())];
    number[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(result.positions.size());
    result.positions.push_back({p.x, p.y, p.z});
  }
  result.soup = meshops::soup_of(halfedges);
  result.soup.points = result.positions.size();
  for (std::uint32_t& corner : result.soup.corners) corner = number[corner];
  return result;
}

}  // namespace

std::size_t polygons_in(const MeshFile& mesh) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) count += mesh.soup.face(f).size() != 3;
  return count;
}

DecimatedMesh decimate(const MeshFile& mesh, const DecimationOptions& choice) {
  DecimatedMesh result;
  DecimationOptions options = choice;
  options.measured = true;
  options.go_on = until_interrupted();
  result.mesh =
      changed(mesh, [&](auto& halfedges, auto& places) { result.report = rbpa::decimate(halfedges, places, options); });
  return result;
}

RemeshedMesh remesh(const MeshFile& mesh, double length) {
  RemeshedMesh result;
  const RemeshOptions options{.length = length, .measured = true, .go_on = until_interrupted()};
  result.mesh =
      changed(mesh, [&](auto& halfedges, auto& places) { result.report = rbpa::remesh(halfedges, places, options); });
  return result;
}

}  // namespace rbpa::app
