// What: random calls of all functions of libmeshops, most of them wrong: handles that are deleted, out of range or of
//       another mesh, effects that are used twice or come from elsewhere, lists of another length, hooks and weights
//       that throw.
// Law:  a call is done, or throws ContractViolation (exceptions of a hook pass through) and changes no bit; the mesh is
//       sound.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "walk/choices.h"
#include "walk/judge.h"

namespace meshops::test {

/// Makes `calls` calls on one mesh. Returns: by the name of the function, how many were done and refused. Throws
/// WalkFailure.
std::map<std::string, Judge::Tally> call_wrongly(Choices& choices, std::size_t calls);

}  // namespace meshops::test
