#include "meshops/core/large_pages.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace meshops {

void prefer_large_pages([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  if (bytes < 4 * page) return;
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (address + page - 1) / page * page, last = (address + bytes) / page * page;
  // Refusal is no failure: the memory is as good, and slower.
  static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
#endif
}

void prefer_large_pages(Connectivity& mesh, std::size_t vertices, std::size_t edges, std::size_t faces) {
  if (vertices == 0 || edges == 0 || faces == 0 || mesh.n_vertices() + mesh.n_edges() + mesh.n_faces() > 0) return;
  mesh.resize(1, 1, 1);  // an element of each, to see where they are
  prefer_large_pages(&mesh.vertex(Vertex(0)), vertices * sizeof(mesh.vertex(Vertex(0))));
  prefer_large_pages(&mesh.edge(OpenMesh::EdgeHandle(0)), edges * sizeof(mesh.edge(OpenMesh::EdgeHandle(0))));
  prefer_large_pages(&mesh.face(Face(0)), faces * sizeof(mesh.face(Face(0))));
  mesh.resize(0, 0, 0);
}

}  // namespace meshops
