#include "meshops/topology/keep_faces.h"

#include <string>

#include "meshops/core/contract.h"

namespace meshops {

SoupPart keep_faces(const PolygonSoup& soup, const std::vector<bool>& kept, const GoOn& go_on) {
  require_parted(soup);
  require_one_each("keep_faces", kept.size(), "values", soup.faces(), "faces");
  Steps step(go_on);
  std::vector<bool> is_used(soup.points, false);
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step();
    if (!kept[f]) continue;
    for (const std::uint32_t corner : soup.face(f)) {
      if (corner >= soup.points)
        throw ContractViolation("keep_faces: a corner of face " + std::to_string(f) + " is not a point");
      is_used[corner] = true;
    }
  }
  SoupPart part;
  std::vector<std::uint32_t> number(soup.points);
  for (std::uint32_t p = 0; p < soup.points; ++p) {
    step();
    if (!is_used[p]) continue;
    number[p] = static_cast<std::uint32_t>(part.point_was.size());
    part.point_was.push_back(p);
  }
  part.soup.points = part.point_was.size();
  std::vector<std::uint32_t> cycle;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    step();
    if (!kept[f]) continue;
    cycle.clear();
    for (const std::uint32_t corner : soup.face(f)) cycle.push_back(number[corner]);
    part.soup.add_face(cycle);
    part.face_was.push_back(f);
  }
  return part;
}

}  // namespace meshops
