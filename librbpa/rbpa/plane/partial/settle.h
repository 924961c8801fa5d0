// What: brings a state into canonical form: components without an open rim become polygons, the rest is numbered.
// Why:  a single region and a merged pair end in the same way, so that the form of a state depends on its regions only.
#pragma once

#include "rbpa/plane/partial/state.h"

namespace rbpa {

/// Brings a state into canonical form. Calls `checkpoint`, if any, repeatedly; `checkpoint` may throw.
/// Requires: shared triangles sorted by corners, none twice; chains that do not join; components and groups in any
///           numbering; the members of pinches after the components are numbers of held polygons.
/// Throws:   InvalidInput when a component without shared triangles has a chain, or no counter-clockwise ring.
/// Cost:     n log n in the open rims.
void settle(PartialState& state, const Checkpoint& checkpoint = {});

}  // namespace rbpa
