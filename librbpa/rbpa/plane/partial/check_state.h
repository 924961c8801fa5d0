// What: whether a state that was read is one that could have been written.
#pragma once

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Throws: InvalidInput that names what is wrong: numbers of items that do not exist, a wrong order, coordinates that are
///         not finite. Cost: linear, and n log n in the corners of the cover.
void check_state(const PartialState& state);

}  // namespace rbpa
