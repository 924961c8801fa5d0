#include "rbpa/core/complex.h"

#include <algorithm>

namespace rbpa {

std::vector<std::array<std::uint32_t, 3>> triangles(const SolidAlphaComplex& complex) {
  std::vector<std::array<std::uint32_t, 3>> result(complex.mesh.n_faces());
  for (std::size_t f = 0; f < result.size(); ++f) {
    auto h = complex.mesh.halfedge_handle(Mesh::FaceHandle(static_cast<int>(f)));
    for (std::uint32_t& corner : result[f]) {
      corner = complex.input_index[static_cast<std::size_t>(complex.mesh.to_vertex_handle(h).idx())];
      h = complex.mesh.next_halfedge_handle(h);
    }
    std::rotate(result[f].begin(), std::min_element(result[f].begin(), result[f].end()), result[f].end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace rbpa
