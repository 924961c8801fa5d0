// What: what the vertices of a front stand on.
#pragma once

#include <cstdint>

namespace meshops {

/// A point of the user's, as an index from 0. Where a complex touches itself in a point, several vertices stand on one
/// site, one for each fan of faces: that keeps every front curve a simple closed curve.
using Site = std::uint32_t;

}  // namespace meshops
