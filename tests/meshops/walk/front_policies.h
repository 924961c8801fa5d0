// What: advances fronts by policies that return anything. Whatever they return, the mesh stays sound, and the events
//       are correct.
#pragma once

#include <cstddef>

#include "walk/choices.h"
#include "walk/law.h"

namespace meshops::test {

/// Events that occurred, to check that a walk reaches everything.
struct AdvanceCounts {
  std::size_t proposals = 0, attached = 0, frozen = 0, refused = 0, detached = 0, seeded = 0, seeds_refused = 0;
  std::size_t thrown = 0, glued = 0, not_glued = 0, there = 0, deferred = 0, lists = 0, policies = 0;
};

/// Advances fronts with policies that return anything, first in first out or by keys, which may be computed again, with
/// or without glues(). Policies and visitors throw sometimes. Ends after `questions` proposals, or when no choices are
/// left. Throws LawBroken.
void advance_at_random(Choices& choices, std::size_t questions, AdvanceCounts& counts);

}  // namespace meshops::test
