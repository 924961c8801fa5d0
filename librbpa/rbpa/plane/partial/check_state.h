// What: checks that a state that was read could have been written.
#pragma once

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Checks a state.
/// Throws: InvalidInput that names the error: numbers of items that do not exist, a wrong order, coordinates that are
///         not finite.
/// Cost:   linear, and n log n in the corners of the cover.
void check_state(const PartialState& state);

}  // namespace rbpa
