#include "rbpa/space/repair/mesh_holes.h"
#include "rbpa/base/triangle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/live_range.h"
#include "meshops/front/front.h"
#include "meshops/handle/glue.h"
#include "meshops/patch/site.h"

namespace rbpa {
namespace {

std::vector<Triangle> triangles_of(const meshops::Connectivity& mesh) {
  std::vector<Triangle> triangles;
  for (const meshops::Face f : meshops::live_faces(mesh)) {
    const meshops::Halfedge first = mesh.halfedge_handle(f);
    meshops::Halfedge h = first;
    Triangle& corners = triangles.emplace_back();
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
    if (h != first)
      throw meshops::ContractViolation("fill_holes: face " + std::to_string(f.idx()) +
                                       " does not have three sides (meshops::triangulate_face() cuts it)");
  }
  return triangles;
}

/// Returns the vertices along a curve, from the vertex of lowest index on.
std::vector<std::uint32_t> loop_of(const meshops::Connectivity& mesh, const meshops::BoundaryCurve& curve) {
  std::vector<std::uint32_t> loop;
  for (const meshops::Halfedge h : curve) {
    meshops::require(meshops::is_live(mesh, h) && mesh.is_boundary(h),
                     "fill_holes: a curve has a halfedge that is not on the boundary of the mesh");
    loop.push_back(static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()));
  }
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  return loop;
}

/// Glues pairs of boundary halfedges that form a slit, as the vertices at their ends are merged.
void zip(meshops::Connectivity& mesh, std::span<const meshops::Site> site_of) {
  std::map<std::pair<meshops::Site, meshops::Site>, meshops::Halfedge> open;
  const auto site = [&](meshops::Vertex v) { return site_of[static_cast<std::size_t>(v.idx())]; };
  for (const meshops::Halfedge h : meshops::live_halfedges(mesh)) {
    if (!mesh.is_boundary(h)) continue;
    const meshops::Site from = site(mesh.from_vertex_handle(h)), to = site(mesh.to_vertex_handle(h));
    const auto other = open.find({to, from});
    if (other == open.end()) {
      open.insert({{from, to}, h});
    } else if (!meshops::glue_blocker(mesh, other->second, h)) {
      meshops::glue(mesh, other->second, h);
      open.erase(other);
    }
  }
}

}  // namespace

FilledMesh fill_holes(meshops::Connectivity& mesh, std::span<const Point3> places,
                      std::span<const meshops::BoundaryCurve> curves, const SurfaceOptions& options) {
  if (places.size() < mesh.n_vertices())
    throw meshops::ContractViolation("fill_holes: found " + std::to_string(places.size()) + " places for " +
                                     std::to_string(mesh.n_vertices()) +
                                     " vertices with the deleted ones, expected one for each");
  const std::vector<Triangle> triangles = triangles_of(mesh);
  std::vector<std::vector<std::uint32_t>> loops;
  for (const meshops::BoundaryCurve& curve : curves) loops.push_back(loop_of(mesh, curve));
  auto sorted = loops;
  std::sort(sorted.begin(), sorted.end());
  meshops::require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
                   "fill_holes: a curve is given twice, expected once");
  HoleFilling filling = fill_holes(places, triangles, loops, options);

  // Vertices that are merged are on one site of the front.
  std::vector<meshops::Site> site_of(mesh.n_vertices());
  for (std::size_t v = 0; v < site_of.size(); ++v) site_of[v] = static_cast<meshops::Site>(v);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) site_of[triangles[t][k]] = filling.triangles[t][k];
  FilledMesh filled{std::move(filling.loops), {}};
  meshops::detail::require_status(mesh, "fill_holes");
  zip(mesh, site_of);
  meshops::Front front(mesh, site_of);
  for (std::size_t t = triangles.size(); t < filling.triangles.size(); ++t) {
    const auto& [a, b, c] = filling.triangles[t];
    filled.faces.push_back(front.create(a, b, c).face);
  }
  front.finish();
  return filled;
}

}  // namespace rbpa
