// What: finds voids or pockets of the balls around atoms, and writes them as rows of a table.
#pragma once

#include <cstddef>
#include <span>

#include "io/bytes/output_file.h"
#include "rbpa/space/balls/ball_voids.h"
#include "space/balls_files.h"

namespace rbpa::app {

/// Finds the voids of the balls with this probe, and with `pockets` its pockets. Throws InvalidInput, Cancelled.
BallVoids voids_of(const MeasuredAtoms& frame, double probe, bool pockets, MaxThreads threads);

/// Begins a table of voids or, with their mouths, of pockets: writes the names of its columns.
void begin_voids(OutputFile& file, bool has_frames, bool of_pockets);

/// Writes a row for each of the voids, the largest first. `frame` is that of the atoms.
void write_voids(OutputFile& file, bool has_frames, bool of_pockets, const MeasuredAtoms& frame,
                 std::span<const BallVoid> voids);

}  // namespace rbpa::app
