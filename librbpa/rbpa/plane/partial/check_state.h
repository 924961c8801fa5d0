// What: checks whether the values, orders and numbers of a PartialState that was read are as to_bytes() writes them.
#pragma once

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Checks a state that was read.
/// Throws: InvalidInput that names the broken rule, for example a wrong order or coordinates that are not finite.
/// Cost:   linear, and n log n in the corners of the cover.
void check_state(const PartialState& state);

}  // namespace rbpa
