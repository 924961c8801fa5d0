// What: the number of a point on which vertices of a front stand.
#pragma once

#include <cstdint>

namespace meshops {

/// Index of a point of the user, from 0. If a complex touches itself in a point, several vertices stand on one site,
/// one for each fan of faces, so that every front curve is a simple closed curve.
using Site = std::uint32_t;

}  // namespace meshops
