#include "meshops/topology/orient.h"

#include <algorithm>
#include <span>

#include "meshops/core/contract.h"
#include "meshops/topology/soup_sides.h"

namespace meshops {

Orientation orient(const PolygonSoup& soup, const GoOn& go_on) {
  const detail::FaceFaults faults = detail::find_face_faults(soup, go_on);
  const detail::SoupSides sides(soup, faults, go_on);
  std::vector<std::uint32_t> disagreeing;  // a face of each piece that is not orientable
  DisjointSets sets = detail::pieces_of(
      soup, sides, [&](std::span<const detail::SoupSide> edge) { disagreeing.push_back(edge[0].face()); }, go_on);

  Steps step(go_on);
  Orientation result;
  result.piece.assign(soup.faces(), Orientation::none);
  result.reversed.assign(soup.faces(), false);
  std::vector<std::size_t> odd;  // for each piece, the number of faces that disagree with its first face
  for (std::uint32_t f = 0; f < soup.faces(); ++f) {
    step();
    if (faults.of[f] != detail::FaceFault::none) continue;
    const std::uint32_t first = sets.find(f);
    if (first == f) {
      result.piece[f] = static_cast<std::uint32_t>(result.pieces.size());
      result.pieces.push_back({.first_face = f});
      odd.push_back(0);
    } else {
      result.piece[f] = result.piece[first];
    }
    ++result.pieces[result.piece[f]].faces;
    odd[result.piece[f]] += sets.is_odd(f);
  }
  for (const std::uint32_t f : disagreeing) result.pieces[result.piece[f]].orientable = false;
  for (std::size_t e = 0; e < sides.edges(); ++e) {
    step();
    if (sides.edge(e).size() == 2) continue;
    for (const detail::SoupSide& side : sides.edge(e)) result.pieces[result.piece[side.face()]].closed = false;
  }
  for (std::uint32_t f = 0; f < soup.faces(); ++f) {
    step();
    if (result.piece[f] == Orientation::none) continue;
    const SurfacePiece& piece = result.pieces[result.piece[f]];
    const bool reverse_odd = 2 * odd[result.piece[f]] <= piece.faces;
    result.reversed[f] = piece.orientable && sets.is_odd(f) == reverse_odd;
  }
  return result;
}

void reverse_faces(PolygonSoup& soup, const std::vector<bool>& reversed) {
  require_parted(soup);
  require_one_each("reverse_faces", reversed.size(), "values", soup.faces(), "faces");
  for (std::size_t f = 0; f < soup.faces(); ++f)
    if (reversed[f] && soup.begin[f] < soup.begin[f + 1])
      std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f]) + 1,
                   soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.begin[f + 1]));
}

}  // namespace meshops
