// What: finds voids or pockets of the balls around atoms, and writes them as rows of a table, as JSON, or as closed
//       surfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/space/balls/ball_voids.h"
#include "space/balls_files.h"

namespace rbpa::app {

/// Finds the voids of the balls with this probe, and with `pockets` its pockets. Throws InvalidInput, Cancelled.
void find_voids(MeasuredAtoms& frame, double probe, bool pockets, MaxThreads threads);

/// Writes voids or, with their mouths, pockets, frame by frame.
/// CSV:  a line for each. JSON: a list of the same values without the number, and of the areas of the balls around.
/// OBJ:  a group void_1, void_2 … for each, frame_1_void_1 … with several frames, with vertices of its own: the
///       surface of its tetrahedra. Triangles face outward from the void, as if it were a body.
class BallVoidRows {
 public:
  /// Keeps a reference to `file`. Requires: a format of Use::voids.
  BallVoidRows(OutputFile& file, Format format, bool has_frames, bool of_pockets);

  void write(const MeasuredAtoms& frame);
  void finish();

 private:
  void write_row(const MeasuredAtoms& frame, const BallVoid& hollow, std::uint64_t number);
  void write_json(const MeasuredAtoms& frame, const BallVoid& hollow);
  void write_surface(const MeasuredAtoms& frame, const BallVoid& hollow, std::uint64_t number);

  OutputFile& file_;
  Format format_;
  bool has_frames_, of_pockets_;
  std::size_t size_ = 0, vertices_ = 0;
};

}  // namespace rbpa::app
