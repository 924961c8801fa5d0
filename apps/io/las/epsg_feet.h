// What: the unit of a projected system of EPSG that is in feet.
// Source: EPSG dataset 10.076, as PROJ 9.1.1 has it.
#pragma once

#include <optional>

namespace rbpa::app {

/// The unit of EPSG that the coordinates of system `code` are in: 9003, the US survey foot, or 9002, the foot; nothing
/// where it is no foot, or the code was not given out yet.
std::optional<unsigned> feet_of_epsg(unsigned code);

}  // namespace rbpa::app
