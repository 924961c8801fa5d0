#include "meshtopo/decimate.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <utility>
#include <vector>

#include "io/bytes/input_bytes.h"
#include "io/failure.h"
#include "io/interrupt.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/topology/build_mesh.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/progressive_mesh.h"

namespace rbpa::app {
namespace {

/// Returns the mesh of the vertices that are left, in their order. Requires: `soup` has no others.
MeshFile mesh_of(const std::vector<Point3>& places, const std::vector<bool>& is_left, meshops::PolygonSoup soup) {
  MeshFile result;
  std::vector<std::uint32_t> number(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    number[v] = static_cast<std::uint32_t>(result.positions.size());
    if (is_left[v]) result.positions.push_back({places[v].x, places[v].y, places[v].z});
  }
  result.soup = std::move(soup);
  result.soup.points = result.positions.size();
  for (std::uint32_t& corner : result.soup.corners) corner = number[corner];
  return result;
}

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
  std::vector<bool> is_left(places.size(), false);
  for (const meshops::Vertex v : meshops::live_vertices(halfedges)) is_left[static_cast<std::size_t>(v.idx())] = true;
  return mesh_of(places, is_left, meshops::soup_of(halfedges));
}

}  // namespace

std::size_t polygons_in(const MeshFile& mesh) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.soup.faces(); ++f) count += mesh.soup.face(f).size() != 3;
  return count;
}

DecimatedMesh decimate(const MeshFile& mesh, const DecimationOptions& choice, bool progressive) {
  DecimatedMesh result;
  DecimationOptions options = choice;
  options.measured = true;
  options.go_on = until_interrupted();
  result.mesh = changed(mesh, [&](auto& halfedges, auto& places) {
    if (!progressive) {
      result.report = rbpa::decimate(halfedges, places, options);
      return;
    }
    const ProgressiveMesh made(std::move(halfedges), std::move(places), options);
    result.report = made.decimation();
    result.progressive = made.write();
    halfedges = made.mesh();
    places = made.places();
  });
  return result;
}

MeshFile read_progressive(const std::string& path, std::size_t faces) try {
  const InputBytes input(path, "a progressive mesh");
  ProgressiveMesh mesh = ProgressiveMesh::read(std::as_bytes(std::span(input.bytes())));
  std::vector<bool> is_left(mesh.positions().size(), true);
  const auto soup_of_vertices = [&](bool left) {
    meshops::PolygonSoup soup;
    for (const Triangle& t : mesh.triangles()) {
      soup.add_face(t);
      for (const std::uint32_t v : t) is_left[v] = left;
    }
    return soup;
  };
  soup_of_vertices(false);  // of the full mesh; isolated vertices stay
  mesh.go_to(faces);
  meshops::PolygonSoup soup = soup_of_vertices(true);
  MeshFile result = mesh_of(mesh.positions(), is_left, std::move(soup));
  if (faces < mesh.least())
    result.warnings.push_back("the least number of faces is " + std::to_string(mesh.least()) +
                              ", more than --at-faces " + std::to_string(faces));
  return result;
} catch (const InvalidInput& error) {
  throw BadInput((path == "-" ? "standard input" : path) + ": " + error.what());
}

RemeshedMesh remesh(const MeshFile& mesh, RemeshOptions options) {
  RemeshedMesh result;
  options.measured = true;
  options.go_on = until_interrupted();
  result.mesh =
      changed(mesh, [&](auto& halfedges, auto& places) { result.report = rbpa::remesh(halfedges, places, options); });
  return result;
}

std::string_view name(SubdivisionRule rule) { return rule == SubdivisionRule::loop ? "loop" : "sqrt3"; }

SubdividedMesh subdivide(const MeshFile& mesh, SubdivisionOptions options) {
  SubdividedMesh result{.mesh = {}, .report = {options.rule, options.times, mesh.soup.faces(), 0}};
  options.go_on = until_interrupted();
  result.mesh = changed(mesh, [&](auto& halfedges, auto& places) { rbpa::subdivide(halfedges, places, options); });
  result.report.left = result.mesh.soup.faces();
  return result;
}

}  // namespace rbpa::app
