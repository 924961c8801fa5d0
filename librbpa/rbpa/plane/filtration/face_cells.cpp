#include "rbpa/plane/filtration/face_cells.h"

#include "meshops/core/connectivity.h"

namespace rbpa {

std::vector<FaceCell> face_cells(const Mesh& mesh) {
  std::vector<FaceCell> cells(mesh.n_faces());
  for (std::size_t f = 0; f < cells.size(); ++f) {
    auto h = mesh.halfedge_handle(meshops::Face(static_cast<int>(f)));
    for (unsigned side = 0; side < 3; ++side) {
      const auto beyond = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      cells[f].corners[side] = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      cells[f].neighbours[side] = beyond.is_valid() ? static_cast<std::uint32_t>(beyond.idx()) : FaceCell::none;
      h = mesh.next_halfedge_handle(h);
    }
  }
  return cells;
}

std::vector<FaceCell> face_cells(const Mesh& mesh, const std::vector<std::uint32_t>& order) {
  const std::vector<FaceCell> cells = face_cells(mesh);
  std::vector<std::uint32_t> place(cells.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<FaceCell> ordered(cells.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    ordered[i] = cells[order[i]];
    for (std::uint32_t& neighbour : ordered[i].neighbours)
      if (neighbour != FaceCell::none) neighbour = place[neighbour];
  }
  return ordered;
}

std::vector<std::uint32_t> gaps_of(const std::vector<FaceCell>& cells, std::size_t vertices) {
  std::vector<std::uint32_t> gaps(vertices);
  for (const FaceCell& cell : cells)
    for (unsigned side = 0; side < 3; ++side)
      gaps[cell.corners[side]] += cell.neighbours[side] == FaceCell::none ? 2u : 1u;
  return gaps;
}

}  // namespace rbpa
