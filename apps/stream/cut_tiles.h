// What: the points of the input in the files of their tiles, and in those of the tiles in whose halo they are.
// Law:  the file of a tile has every point of its box, and every other within 2 alpha of it.
// Cost: reading the input and writing it once; memory as the points that may wait.
#pragma once

#include <cstdint>
#include <vector>

#include "stream/budget.h"
#include "stream/manifest.h"
#include "stream/request.h"
#include "stream/scratch.h"

namespace rbpa::app {

/// Resumes where the manifest records a stop; when the input is read, the manifest lists what the files have.
/// Throws as read_points(), Failure, Cancelled.
void cut_tiles(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

/// Makes the file of one tile again.
void cut_again(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest,
               std::uint32_t tile);

/// Cuts tiles that turned out larger than they may be, as long as there are any. Throws Failure where no cut helps.
void cut_smaller(const StreamRequest& request, const Budget& budget, const Scratch& scratch, Manifest& manifest);

}  // namespace rbpa::app
