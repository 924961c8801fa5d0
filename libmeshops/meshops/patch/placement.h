// What: where a patch goes in the mesh: what PatchAssembler::place() decides and fill() writes.
// Why:  only the rim of a patch depends on other patches. What is left, nearly all, can be written by another thread
//       while the next patch is placed.
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
  /// Of a side, as others store it: at the rim place(), of a hole the number of its place, else the side across. What is
  /// across at the rim is not used.
  Halfedge& at(int side) { return *(of_side_.data() - Patch::nothing + side); }

  int first_face_ = 0, first_edge_ = 0, first_hole_ = 0;
  std::vector<Vertex> of_fan_;     // of each hole, the vertex between it and the next; invalid where not determined yet
  std::vector<Halfedge> of_side_;  // behind those that stand for no side
};

}  // namespace meshops
