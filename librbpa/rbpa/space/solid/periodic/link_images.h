// What: links tetrahedra that are neighbors across the sides of a periodic box.
// Law:  a face is identified by its three points and their offsets in boxes relative to each other, which all its
//       images share.
// Cost: a sort of the faces.
#pragma once

#include <cstdint>
#include <span>

#include "rbpa/space/solid/periodic_solid.h"

namespace rbpa::space {

/// Links the tetrahedra that have images of one face. A face is given by 4 t + k: across from corner k of tetrahedron
/// t.
void link_images(std::span<const std::uint32_t> faces, PeriodicSolid& solid);

}  // namespace rbpa::space
