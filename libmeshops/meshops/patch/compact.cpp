#include "meshops/patch/compact.h"

#include <numeric>

#include "meshops/patch/assembled.h"

namespace meshops {
namespace {

/// Moves the vertices from `first` to `end` to their new numbers. A vertex without triangles has the number of the next
/// vertex, which then overwrites it; this avoids a branch that would be mispredicted. Only deleted edges refer to
/// vertices from `end` on.
void renumber(Connectivity& mesh, std::size_t edges, std::size_t first, std::size_t end,
              const std::vector<int>& number) {
  for (auto property = mesh.vprops_begin(); property != mesh.vprops_end(); ++property) {
    if (*property == nullptr) continue;
    for (std::size_t i = first; i < end; ++i) (*property)->copy(i, static_cast<std::size_t>(number[i]));
  }
  for (std::size_t i = first; i < end; ++i)
    mesh.set_halfedge_handle(Vertex(number[i]), mesh.halfedge_handle(Vertex(static_cast<int>(i))));
  for (int i = 0; i < static_cast<int>(2 * edges); ++i) {
    const Halfedge h(i);
    mesh.set_vertex_handle(h, Vertex(number[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())]));
  }
}

}  // namespace

std::vector<Site> detail::compact(Connectivity& mesh, const SiteVertices& vertices, std::size_t edges,
                                  std::size_t faces) {
  const auto is_unused = [&](std::size_t i) { return mesh.is_isolated(Vertex(static_cast<int>(i))); };
  const auto site = [&](std::size_t i) { return vertices.site(Vertex(static_cast<int>(i))); };
  // Vertices of fans that were merged into others are often at the end. If all unused vertices are at the end, no
  // vertex needs a new number.
  std::size_t end = mesh.n_vertices(), left = 0;
  while (end > 0 && is_unused(end - 1)) --end;
  std::vector<Site> site_of(end);
  for (; left < site_of.size() && !is_unused(left); ++left) site_of[left] = site(left);
  if (const std::size_t first = left; first < site_of.size()) {
    std::vector<int> number(mesh.n_vertices());
    std::iota(number.begin(), number.begin() + static_cast<std::ptrdiff_t>(first), 0);
    for (std::size_t i = first; i < end; ++i) {
      site_of[left] = site(i);
      number[i] = static_cast<int>(left);
      left += !is_unused(i);
    }
    renumber(mesh, edges, first, end, number);
    site_of.resize(left);
  }
  mesh.resize(site_of.size(), edges, faces);
  return site_of;
}

Connectivity& AssembledPatches::unchanged() const {
  require(vertices_.vertices() == counts_.vertices, "AssembledPatches: finished, or moved to a front already");
  if (const auto found = ElementCounts::of(mesh_); found != counts_)
    throw ContractViolation("AssembledPatches: the mesh was changed by others: it has " + describe(found) +
                            "; expected " + describe(counts_));
  return mesh_;
}

std::vector<Site> AssembledPatches::finish() && {
  unchanged();
  const SiteVertices vertices = std::move(vertices_);
  return detail::compact(mesh_, vertices, mesh_.n_edges(), mesh_.n_faces());
}

}  // namespace meshops
