// What: the place of a patch in the mesh, which PatchAssembler::place() decides and fill() reads.
// Why:  only the rim of a patch depends on other patches. All the rest, which is nearly everything, can be written by
//       another thread while the next patch is placed.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/patch/patch.h"

namespace meshops {

/// Place of one patch, from its place() until its fill(). Only PatchAssembler reads it.
class Placement {
  friend class PatchAssembler;

  void make_room(std::size_t sides) {
    sides += static_cast<std::size_t>(-Patch::nothing);
    if (of_side_.size() < sides) of_side_.resize(sides);
  }
  /// Returns the entry of a side, the halfedge that the side gets, or of `open` or `nothing`, which receive values that
  /// nobody reads. place() sets the entries of sides at the rim; fill() sets the entries of holes, and of the side
  /// across each side that it fills.
  Halfedge& at(int side) { return *(of_side_.data() - Patch::nothing + side); }

  int first_face_ = 0, first_edge_ = 0, first_hole_ = 0;
  std::vector<Vertex> of_fan_;     // for each hole, the vertex between it and the next; invalid where join() decides
  std::vector<Halfedge> of_side_;  // the entries of sides follow two entries for `open` and `nothing`
};

}  // namespace meshops
