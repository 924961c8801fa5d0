// What: the label of points and balls that are in no group.
#pragma once

#include <cstdint>

namespace rbpa {

/// The label of a point, or of a ball, that is in no group.
inline constexpr std::uint32_t no_group = 0xffffffff;

}  // namespace rbpa
