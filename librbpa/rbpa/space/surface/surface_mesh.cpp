#include "rbpa/space/surface/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/patch/assembler.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/surface/split_fans.h"

namespace rbpa {
namespace {

/// Returns the triangles as one patch, with a site for each fan.
meshops::Patch patch_of(const Surface& surface, const SplitFans& fans) {
  meshops::Patch patch;
  patch.triangles.resize(fans.triangles.size());
  patch.across.resize(fans.triangles.size());
  for (std::size_t t = 0; t < fans.triangles.size(); ++t)
    for (std::size_t side = 0; side < 3; ++side) {
      patch.triangles[t][side] = static_cast<meshops::Site>(fans.triangles[t][side]);
      // Side `side` runs from corner `side` to the next corner, and is across from the third corner. The side of the
      // other triangle begins at the next corner.
      const std::uint32_t other = surface.neighbors[t][(side + 2) % 3];
      patch.across[t][side] = meshops::Patch::nothing;
      if (other == Surface::none) continue;
      const auto& corners = surface.triangles[other];
      const auto begin = std::find(corners.begin(), corners.end(), surface.triangles[t][(side + 1) % 3]);
      patch.across[t][side] = static_cast<int>(3 * other) + static_cast<int>(begin - corners.begin());
    }
  return patch;
}

/// Makes the mesh. Calls give_back() as soon as the surface is no longer needed.
template <typename GiveBack>
SurfaceMesh mesh_of(std::span<const Point3> points, const Surface& surface, GiveBack give_back) {
  if (surface.triangles.size() > max_points)
    throw InvalidInput("surface_mesh: found " + std::to_string(surface.triangles.size()) +
                       " triangles, expected at most " + std::to_string(max_points) +
                       ", as OpenMesh numbers halfedges in int");
  for (const auto& t : surface.triangles)
    for (const std::uint32_t i : t)
      if (i >= points.size())
        throw meshops::ContractViolation("surface_mesh: corner " + std::to_string(i) + " is not one of " +
                                         std::to_string(points.size()) + " points");
  SplitFans fans = split_fans(surface);
  const meshops::Patch patch = patch_of(surface, fans);
  fans.triangles = {};
  give_back();

  SurfaceMesh result;
  meshops::PatchAssembler assembler(result.mesh, fans.point.size());
  assembler.lay(patch);
  result.input_index = std::move(assembler).join().finish();
  for (std::size_t v = 0; v < result.input_index.size(); ++v) {
    const std::uint32_t index = fans.point[result.input_index[v]];
    const Point3& p = points[index];
    result.mesh.set_point(Mesh::VertexHandle(static_cast<int>(v)), {p.x, p.y, p.z});
    result.input_index[v] = index;
  }
  return result;
}

}  // namespace

SurfaceMesh surface_mesh(std::span<const Point3> points, const Surface& surface) {
  return mesh_of(points, surface, [] {});
}

SurfaceMesh surface_mesh(std::span<const Point3> points, Surface&& surface) {
  return mesh_of(points, surface, [&] { surface = Surface(); });
}

SurfaceOfTriangles surface_of(const meshops::Connectivity& mesh, std::span<const Point3> places) {
  meshops::require(places.size() >= mesh.n_vertices(), "surface_of: expected a place for each vertex");
  std::vector<std::array<std::uint32_t, 3>> triangles, neighbors;
  std::vector<std::uint32_t> face, number(mesh.n_faces());
  for (const meshops::Face f : meshops::live_faces(mesh)) {
    number[static_cast<std::size_t>(f.idx())] = static_cast<std::uint32_t>(face.size());
    face.push_back(static_cast<std::uint32_t>(f.idx()));
  }
  for (const std::uint32_t f : face) {
    const meshops::Halfedge first = mesh.halfedge_handle(meshops::Face(static_cast<int>(f)));
    meshops::Halfedge h = first;
    auto& corners = triangles.emplace_back();
    auto& beyond = neighbors.emplace_back();
    for (std::size_t k = 0; k < 3; ++k, h = mesh.next_halfedge_handle(h)) {
      corners[k] = static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx());
      const meshops::Face other = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      beyond[(k + 2) % 3] = other.is_valid() ? number[static_cast<std::size_t>(other.idx())] : Surface::none;
    }
    if (h != first)
      throw meshops::ContractViolation("surface_of: face " + std::to_string(f) +
                                       " does not have three sides (meshops::triangulate_face() cuts it)");
    const Point3 &a = places[corners[0]], &b = places[corners[1]], &c = places[corners[2]];
    if (a == b || b == c || c == a)
      throw InvalidInput("face " + std::to_string(f) +
                         ": two corners are at one place (meshops::repair() drops such triangles)");
  }
  std::vector<std::uint32_t> vertex, number_of_vertex(mesh.n_vertices());
  std::vector<Point3> live;  // a deleted vertex is no point
  for (const meshops::Vertex v : meshops::live_vertices(mesh)) {
    const auto at = static_cast<std::size_t>(v.idx());
    number_of_vertex[at] = static_cast<std::uint32_t>(live.size());
    vertex.push_back(static_cast<std::uint32_t>(at));
    const Point3& p = places[at];
    if (!is_finite(p))
      throw InvalidInput("vertex " + std::to_string(at) + " is (" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) +
                         "), expected finite coordinates");
    live.push_back(p);
  }
  for (auto& corners : triangles)
    for (std::uint32_t& corner : corners) corner = number_of_vertex[corner];
  SurfaceOfTriangles surface = surface_of(live, triangles, neighbors);
  for (std::uint32_t& given : surface.given) given = face[given];
  for (auto& corners : surface.triangles)
    for (std::uint32_t& corner : corners) corner = vertex[corner];
  for (Duplicate& duplicate : surface.duplicates) duplicate = {vertex[duplicate.index], vertex[duplicate.stands_for]};
  return surface;
}

}  // namespace rbpa
