// What: detects faces without area.
// Law:  exact. Rounded numbers decide only if their error bound allows it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/mesh/equal_positions.h"

namespace rbpa::app {

/// Returns whether all corners of `face` are on one line. Requires: finite positions.
bool is_on_a_line(std::span<const std::uint32_t> face, std::span<const Position> positions);

}  // namespace rbpa::app
