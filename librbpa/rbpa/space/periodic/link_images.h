// What: neighbors of tetrahedra across the sides of the box.
// Law:  a face is known by its three points and by how many boxes they are apart: that is the same for all of its images.
// Cost: a sort of the faces.
#pragma once

#include <cstdint>
#include <span>

#include "rbpa/periodic_solid.h"

namespace rbpa::space {

/// Makes those neighbors that have images of one face. A face is known by 4 t + k: across from corner k of tetrahedron t.
void link_images(std::span<const std::uint32_t> faces, PeriodicSolid& solid);

}  // namespace rbpa::space
