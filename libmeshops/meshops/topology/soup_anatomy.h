// What: the properties of a soup that both report() and find_defects() need, computed once.
// Cost: most of the cost of report() or find_defects().
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "meshops/topology/soup_sides.h"

namespace meshops::detail {

/// Faults, sides, pieces and fans of a soup. Keeps a reference to the soup, which must outlive the object.
struct SoupAnatomy {
  /// Computes all members. Throws what find_face_faults() throws.
  SoupAnatomy(const PolygonSoup& given, const GoOn& go_on);

  const PolygonSoup& soup;
  FaceFaults faults;
  SoupSides sides;
  bool has_non_manifold_edge = false;                    ///< whether more than two faces meet at some edge
  std::vector<std::span<const SoupSide>> disagreeing{};  ///< edges of two faces that no reversal makes agree
  DisjointSets pieces;                                   ///< sets of faces
  DisjointSets fans;                                     ///< sets of corners on one point, joined at every edge
  std::vector<std::uint32_t> fans_at;                    ///< for each point, the number of fans on it

  bool is_sound(std::size_t f) const { return faults.of[f] == FaceFault::none; }

  /// Calls fan(point, face) for every fan, where `face` is the first face of the fan.
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

// report() and find_defects() document these functions.
TopologyReport report_of(SoupAnatomy& anatomy, const GoOn& go_on);
std::vector<SoupDefect> defects_of(SoupAnatomy& anatomy, const GoOn& go_on);

}  // namespace meshops::detail
