// What: the place of a patch in the mesh, which PatchAssembler::place() decides and fill() reads.
// Why:  only the rim of a patch depends on other patches. All the rest, which is nearly everything, can be written by
//       another thread while the next patch is placed.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/patch/patch.h"

namespace meshops {

class Placement {
  friend class PatchAssembler;

  void make_room(std::size_t sides) {
    sides += static_cast<std::size_t>(-Patch::nothing);
    if (of_side_.size() < sides) of_side_.resize(sides);
  }
  /// The entry of a side, as other sides store it: place() fills it at the rim; at a hole it comes from the number of
  /// the hole, elsewhere from the side across. The halfedge across is not used at the rim.
  Halfedge& at(int side) { return *(of_side_.data() - Patch::nothing + side); }

  int first_face_ = 0, first_edge_ = 0, first_hole_ = 0;
  std::vector<Vertex> of_fan_;     // for each hole, the vertex between it and the next; invalid until determined
  std::vector<Halfedge> of_side_;  // the entries of sides follow two entries for `open` and `nothing`
};

}  // namespace meshops
