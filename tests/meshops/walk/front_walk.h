// What: walks at random over all that a front can be asked, right and wrong, beside its model. Every step is the one that
//       the model makes, or is refused for a reason that the model has too, with not a bit of the mesh changed.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "walk/choices.h"

namespace meshops::test {

/// A law does not hold; the message says which, and after which steps.
struct LawBroken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a walk has met, to know that it meets everything.
struct FrontWalkCounts {
  std::size_t steps = 0;
  std::size_t attached = 0, created = 0, detached = 0, levels = 0, begun_on_mesh = 0;
  std::size_t joined_fans = 0, pinches = 0;
  std::array<std::size_t, 8> refused = {};  ///< by RefusalKind
};

/// Takes so many steps, or fewer where the choices end. Throws LawBroken.
void walk_on_front(Choices& choices, std::size_t steps, FrontWalkCounts& counts);

/// What advancing fronts have met.
struct AdvanceCounts {
  std::size_t proposals = 0, attached = 0, frozen = 0, refused = 0, detached = 0, seeded = 0, seeds_refused = 0;
  std::size_t thrown = 0;
};

/// Lets a policy advance that answers anything, in its own order or first in first out, and sometimes throws; until it has
/// been asked so many questions, or the choices end. Throws LawBroken.
void advance_at_random(Choices& choices, std::size_t questions, AdvanceCounts& counts);

}  // namespace meshops::test
