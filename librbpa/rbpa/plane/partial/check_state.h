// What: checks a PartialState that was read from bytes: whether to_bytes() could have written it.
#pragma once

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Checks a state that was read.
/// Throws: InvalidInput that names the broken rule, for example a wrong order or coordinates that are not finite.
/// Cost:   linear, and n log n in the corners of the cover.
void check_state(const PartialState& state);

}  // namespace rbpa
