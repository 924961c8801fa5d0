#include "rbpa/plane/filtration/growth.h"

#include <algorithm>

namespace rbpa {
namespace {

std::vector<std::uint32_t> first_vertices(const std::vector<std::uint32_t>& input_index) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  const auto last = std::max_element(input_index.begin(), input_index.end());
  std::vector<std::uint32_t> on_point(last == input_index.end() ? 0 : *last + 1u, none);
  std::vector<std::uint32_t> first(input_index.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    std::uint32_t& found = on_point[input_index[v]];
    if (found == none) found = v;
    first[v] = found;
  }
  return first;
}

}  // namespace

Growth::Growth(const SolidAlphaComplex& complex)
    : cells_(face_cells(complex.mesh)),
      first_on_point_(first_vertices(complex.input_index)),
      gaps_(gaps_of(cells_, complex.mesh.n_vertices())),
      solids_(complex.mesh.n_faces()),
      pieces_(complex.mesh.n_vertices()),
      in_(complex.mesh.n_faces()),
      on_(complex.mesh.n_vertices()),
      point_on_(complex.mesh.n_vertices()) {}

void Growth::add(std::uint32_t face) {
  const FaceCell& cell = cells_[face];
  in_[face] = true;
  ++now_.triangles;
  ++now_.solid_components;
  std::array<bool, 3> glued;
  for (unsigned side = 0; side < 3; ++side) {
    const std::uint32_t neighbour = cell.neighbours[side];
    glued[side] = neighbour != FaceCell::none && in_[neighbour];
    if (glued[side])
      now_.solid_components -= solids_.join(face, neighbour);
    else
      ++now_.edges;
  }
  for (unsigned i = 0; i < 3; ++i) {
    const std::uint32_t corner = cell.corners[i];
    const bool before = glued[i], behind = glued[(i + 1) % 3];
    --gaps_[corner];
    if (!before && !behind) ++fans_;
    // Between two faces the triangle joins their fans; unless it was the last gap, and they were one that has closed.
    if (before && behind && gaps_[corner] > 0) --fans_;
    if (!on_[corner]) cover(corner);
    now_.components -= pieces_.join(cell.corners[0], corner);
  }
}

void Growth::cover(std::uint32_t vertex) {
  on_[vertex] = true;
  const std::uint32_t first = first_on_point_[vertex];
  pieces_.join(first, vertex);
  if (point_on_[first]) return;
  point_on_[first] = true;
  ++now_.points_covered;
  ++now_.components;
}

ComplexCounts Growth::counts() const {
  ComplexCounts counts = now_;
  counts.holes = counts.components + counts.edges - counts.points_covered - counts.triangles;  // components − χ
  // A surface that lies in the plane has no handles: χ = 2 components − curves, with a vertex for each fan.
  counts.boundary_curves = 2 * counts.solid_components + counts.edges - fans_ - counts.triangles;
  return counts;
}

}  // namespace rbpa
