// What: random walks over all calls of a front, right and wrong, together with its model. Every step equals that of the
//       model, or is refused for a reason that the model has too, with no bit of the mesh changed.
#pragma once

#include <array>
#include <cstddef>

#include "walk/choices.h"
#include "walk/law.h"

namespace meshops::test {

/// Events that occurred, to check that a walk reaches everything.
struct FrontWalkCounts {
  std::size_t steps = 0;
  std::size_t attached = 0, created = 0, detached = 0, levels = 0, begun_on_mesh = 0;
  std::size_t joined_fans = 0, pinches = 0;
  std::array<std::size_t, 8> refused = {};  ///< by RefusalKind, except triangle_there
};

/// Does `steps` steps, or fewer if the choices end. Throws LawBroken.
void walk_on_front(Choices& choices, std::size_t steps, FrontWalkCounts& counts);

}  // namespace meshops::test
