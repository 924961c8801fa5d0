// What: the events that a simplification reports.
#pragma once

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Base of visitors. A visitor declares the events that it uses, by the same names; other events cost nothing. At each
/// event, the mesh is sound if it was sound at first. A visitor must not change the mesh; it may throw to end the run.
struct SimplifyVisitor {
  /// Called after an edge collapsed: `effect.removed.vertex` was merged into `effect.survivor`, together with all
  /// vertices merged into it before. undo() of the effects, from the last to the first, restores every record of the
  /// mesh, but no property.
  void collapsed(const Connectivity&, const WeldEffect& /*effect*/, double /*cost*/) {}
  /// Called when collapse_blocker() refuses the collapse of an edge. The edge is tried again after a change near it.
  void refused(const Connectivity&, Edge, const Blocker&) {}
  /// Called when allows() forbids the collapse of an edge. The edge is tried again after a change near it.
  void disallowed(const Connectivity&, Edge) {}
};

}  // namespace meshops
