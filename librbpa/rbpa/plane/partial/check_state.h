// What: checks a PartialState that was read from bytes: whether to_bytes() could have written it.
#pragma once

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Checks a state that was read.
/// Throws: InvalidInput that names the error: a number of an item that does not exist, a wrong order, coordinates that
///         are not finite.
/// Cost:   linear, and n log n in the corners of the cover.
void check_state(const PartialState& state);

}  // namespace rbpa
