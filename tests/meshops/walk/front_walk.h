// What: walks at random over all calls of a front, right and wrong, beside its model. Every step is the one that
//       the model makes, or is refused for a reason that the model has too, with not a bit of the mesh changed.
#pragma once

#include <array>
#include <cstddef>

#include "walk/choices.h"
#include "walk/law.h"

namespace meshops::test {

/// What a walk has met, to check that it meets everything.
struct FrontWalkCounts {
  std::size_t steps = 0;
  std::size_t attached = 0, created = 0, detached = 0, levels = 0, begun_on_mesh = 0;
  std::size_t joined_fans = 0, pinches = 0;
  std::array<std::size_t, 8> refused = {};  ///< by RefusalKind, but for triangle_there
};

/// Does so many steps, or fewer where the choices end. Throws LawBroken.
void walk_on_front(Choices& choices, std::size_t steps, FrontWalkCounts& counts);

}  // namespace meshops::test
