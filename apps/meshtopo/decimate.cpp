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

std::size_t polygons_in(const MeshFile& mesh) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) count += mesh.soup.face(f).size() != 3;
  return count;
}

DecimatedMesh decimate(const MeshFile& mesh, const DecimationOptions& choice) {
  DecimatedMesh result;
  OpenMesh::PolyConnectivity halfedges;
  std::vector<Point3> places;
  for (const std::uint32_t point : meshops::build_mesh(halfedges, mesh.soup, until_interrupted())) {
    const auto& [x, y, z] = mesh.positions[point];
    places.push_back({x, y, z});
  }
  meshops::request_status(halfedges);
  DecimationOptions options = choice;
  options.measured = true;
  options.go_on = until_interrupted();
  result.report = rbpa::decimate(halfedges, places, options);
  std::vector<std::uint32_t> number(places.size());
  for (const meshops::Vertex v : meshops::live_vertices(halfedges)) {
    const Point3& p = places[static_cast<std::size_t>(v.idx())];
    number[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(result.mesh.positions.size());
    result.mesh.positions.push_back({p.x, p.y, p.z});
  }
  result.mesh.soup = meshops::soup_of(halfedges);
  result.mesh.soup.points = result.mesh.positions.size();
  for (std::uint32_t& corner : result.mesh.soup.corners) corner = number[corner];
  return result;
}

}  // namespace rbpa::app
