#include "rbpa/core/complex.h"

#include <algorithm>
#include <numeric>

namespace rbpa {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The corners of face `f` as input indices, the smallest first.
Triangle triangle(const SolidAlphaComplex& complex, std::size_t f) {
  Triangle corners;
  auto h = complex.mesh.halfedge_handle(Mesh::FaceHandle(static_cast<int>(f)));
  for (std::uint32_t& corner : corners) {
    corner = complex.input_index[static_cast<std::size_t>(complex.mesh.to_vertex_handle(h).idx())];
    h = complex.mesh.next_halfedge_handle(h);
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

std::vector<Triangle> triangles(const SolidAlphaComplex& complex) {
  std::vector<Triangle> unsorted(complex.mesh.n_faces());
  std::size_t bound = 0;  // above every smallest corner
  for (std::size_t f = 0; f < unsorted.size(); ++f) {
    unsorted[f] = triangle(complex, f);
    bound = std::max(bound, unsorted[f][0] + std::size_t{1});
  }

  // Few triangles share their smallest corner i: counting brings them together, from next[i] on, and leaves little to
  // sort.
  std::vector<std::uint32_t> next(bound + 1);
  for (const Triangle& t : unsorted) ++next[t[0] + std::size_t{1}];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Triangle> result(unsorted.size());
  for (const Triangle& t : unsorted) result[next[t[0]]++] = t;

  auto first = result.begin();
  for (std::size_t i = 0; i < bound; ++i) {
    const auto last = result.begin() + next[i];  // all of i are put, so next[i] is where those of i + 1 begin
    std::sort(first, last);
    first = last;
  }
  return result;
}

}  // namespace rbpa
