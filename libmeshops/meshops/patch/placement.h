// What: the place of a patch in the mesh, which PatchAssembler::place() decides and PatchAssembler::fill() reads.
// Why:  only the rim of a patch depends on other patches. While the next patch is placed, another thread can write
//       everything else, which is nearly all of the patch.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/patch/patch.h"

namespace meshops {

/// Place of one patch, used from its place() until its fill(). Only PatchAssembler reads the members.
class Placement {
  friend class PatchAssembler;

  void make_room(std::size_t sides) {
    sides += static_cast<std::size_t>(-Patch::nothing);
    if (of_side_.size() < sides) of_side_.resize(sides);
  }
  /// Returns the entry of a side: the halfedge that the side gets. Patch::open and Patch::nothing have entries, too,
  /// which are written but never read. place() sets the entries of sides at the rim. fill() sets the entries of holes,
  /// and for each side that it fills the entry of the side across.
  Halfedge& at(int side) { return *(of_side_.data() - Patch::nothing + side); }

  int first_face_ = 0, first_edge_ = 0, first_hole_ = 0;
  std::vector<Vertex> of_fan_;     // for each hole, the vertex between its edge and the next; invalid if join() decides
  std::vector<Halfedge> of_side_;  // the first two entries are those of Patch::nothing and Patch::open
};

}  // namespace meshops
