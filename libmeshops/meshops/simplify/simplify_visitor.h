// What: the events that a simplification reports.
#pragma once

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"

namespace meshops {

/// Base of visitors. A visitor overrides the events that it uses; the others cost nothing. The mesh is sound at each
/// event, and a visitor must not change it. A visitor may be a local class, and may throw to end the run.
struct SimplifyVisitor {
  /// Called when an edge has collapsed: `effect.removed.vertex` went into `effect.survivor`, as did all that had gone
  /// into it before. undo() of the effects, the last first, restores every record of the mesh.
  void collapsed(const Connectivity&, const WeldEffect& /*effect*/, double /*cost*/) {}
  /// Called when the topology does not permit the collapse of an edge, which is then tried again after a change near
  /// it.
  void refused(const Connectivity&, Edge, const Blocker&) {}
  /// Called when the policy does not allow the collapse of an edge, which is then tried again after a change near it.
  void disallowed(const Connectivity&, Edge) {}
};

}  // namespace meshops
