#include "rbpa/space/solid/tiles/border_faces.h"

#include <vector>

namespace rbpa::space {

void link_border_faces(std::span<const BorderFace> faces, std::size_t bound, meshops::FreshVector<Row>& neighbors) {
  struct Rest {
    std::uint32_t middle, greatest;
    std::uint32_t face;
  };
  std::vector<std::uint32_t> end(bound + 1, 0);
  for (const BorderFace& face : faces) ++end[face.corners[0] + 1];
  for (std::size_t i = 1; i <= bound; ++i) end[i] += end[i - 1];
  meshops::FreshVector<Rest> rest(faces.size());
  // Before this loop, end[i] is the beginning of the faces with first corner i; afterwards, their end.
  for (const BorderFace& face : faces) rest[end[face.corners[0]]++] = {face.corners[1], face.corners[2], face.face};
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < bound; ++i) {
    for (std::uint32_t j = begin; j < end[i]; ++j)
      for (std::uint32_t k = j + 1; k < end[i]; ++k)
        if (rest[j].middle == rest[k].middle && rest[j].greatest == rest[k].greatest) {
          neighbors[rest[j].face / 4][rest[j].face % 4] = rest[k].face / 4;
          neighbors[rest[k].face / 4][rest[k].face % 4] = rest[j].face / 4;
          break;
        }
    begin = end[i];
  }
}

}  // namespace rbpa::space
