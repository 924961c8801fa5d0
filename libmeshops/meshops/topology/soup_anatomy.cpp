#include "meshops/topology/soup_anatomy.h"

namespace meshops::detail {

SoupAnatomy::SoupAnatomy(const PolygonSoup& given, const GoOn& go_on)
    : soup(given),
      faults(find_face_faults(given, go_on)),
      sides(given, faults, go_on),
      pieces(pieces_of(
          given, sides, [this](std::span<const SoupSide> edge) { disagreeing.push_back(edge); }, go_on)),
      fans(fans_of(
          given, sides,
          [this](std::span<const SoupSide> edge) {
            has_non_manifold_edge = has_non_manifold_edge || edge.size() > 2;
            return true;
          },
          go_on)),
      fans_at(given.points, 0) {
  Steps step(go_on);
  for_each_fan(step, [this](std::uint32_t point, std::size_t) { ++fans_at[point]; });
}

}  // namespace meshops::detail
