// What: the properties of a soup that report() and find_defects() both need, computed once.
// Cost: most of the cost of either function.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "meshops/topology/soup_sides.h"

namespace meshops::detail {

/// Faults, sides, pieces and fans of a soup. Keeps a reference to the soup, which must outlive this object.
struct SoupAnatomy {
  /// Throws as find_face_faults().
  SoupAnatomy(const PolygonSoup& given, const GoOn& go_on);

  const PolygonSoup& soup;
  FaceFaults faults;
  SoupSides sides;
  bool has_non_manifold_edge = false;                    ///< whether more than two faces meet at some edge
  std::vector<std::span<const SoupSide>> disagreeing{};  ///< edges of two faces that no reversal makes agree
  DisjointSets pieces;                                   ///< sets of faces
  DisjointSets fans;                                     ///< sets of corners, joined at every edge
  std::vector<std::uint32_t> fans_at;                    ///< for each point: the number of fans

  bool is_sound(std::size_t f) const { return faults.of[f] == FaceFault::none; }

  /// Calls fan(point, face) for every fan, with the first face of it.
  template <typename Fan>
  void for_each_fan(Steps& step, Fan fan) const {
    for (std::size_t f = 0; f < soup.faces(); ++f) {
      if (!is_sound(f)) continue;
      for (std::size_t c = soup.begin[f]; c < soup.begin[f + 1]; ++c) {
        step();
        if (fans.is_least(static_cast<std::uint32_t>(c))) fan(soup.corners[c], f);
      }
    }
  }
};

/// Documented at report() and find_defects().
TopologyReport report_of(SoupAnatomy& anatomy, const GoOn& go_on);
std::vector<SoupDefect> defects_of(SoupAnatomy& anatomy, const GoOn& go_on);

}  // namespace meshops::detail
