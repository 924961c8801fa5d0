// What: the events that a simplification reports.
#pragma once

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Base of visitors. A visitor declares the events that it uses, by the same names; the others cost nothing. At each
/// event, the mesh is sound if it was at first; a visitor must not change the mesh. A visitor may throw to end the run.
struct SimplifyVisitor {
  /// Called when an edge has collapsed: `effect.removed.vertex` went into `effect.survivor`, and with it all vertices
  /// that had gone into it. undo() of the effects, the last first, restores every record of the mesh, but no property.
  void collapsed(const Connectivity&, const WeldEffect& /*effect*/, double /*cost*/) {}
  /// Called when collapse_blocker() refuses the collapse of an edge, which is tried again after a change near it.
  void refused(const Connectivity&, Edge, const Blocker&) {}
  /// Called when allows() forbids the collapse of an edge, which is tried again after a change near it.
  void disallowed(const Connectivity&, Edge) {}
};

}  // namespace meshops
