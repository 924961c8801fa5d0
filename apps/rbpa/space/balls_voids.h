// What: finds voids and pockets of the balls around atoms, and writes them as rows of a table, as JSON, or as closed
//       surfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/space/balls/ball_voids.h"
#include "space/balls_files.h"

namespace rbpa::app {

/// Finds the voids of the balls with the probe: in the cell, if the frame has one, or else with `pockets` also the
/// pockets. Throws InvalidInput, Cancelled.
void find_voids(MeasuredAtoms& frame, std::span<const Point3> centers, double probe, bool pockets, MaxThreads threads);

/// Writes voids or pockets, frame by frame; pockets with their mouths.
/// CSV:  a line for each void or pocket; in cells with the number of directions in which it percolates.
/// JSON: a list of the values of CSV without the number, and of the areas of the balls around.
/// OBJ:  a group void_1, void_2 … for each (frame_1_void_1 … with several frames) with its own vertices: the surface of
///       the tetrahedra. Triangles face outward from the void, as if the void were a body.
/// PML, CXC: for each, commands of PyMOL or ChimeraX that name and color the atoms around by their serial numbers, and
///       show the largest ball that fits in.
class BallVoidRows {
 public:
  /// Begins the file. Keeps a reference to `file`. Requires: `format` is one of Use::lined; for frames with cells it is
  /// not obj, and the rows are not those of pockets.
  BallVoidRows(OutputFile& file, Format format, bool has_frames, bool has_cells, bool of_pockets);

  void write(const MeasuredAtoms& frame);
  void finish();

 private:
  void write_row(const MeasuredAtoms& frame, const BallVoid& hollow, std::uint64_t number);
  void write_json(const MeasuredAtoms& frame, const BallVoid& hollow);
  void write_surface(const MeasuredAtoms& frame, const BallVoid& hollow, const std::string& name);
  void write_commands(const MeasuredAtoms& frame, const BallVoid& hollow, const std::string& name);

  OutputFile& file_;
  Format format_;
  bool has_frames_, has_cells_, of_pockets_;
  std::size_t size_ = 0, vertices_ = 0;
};

}  // namespace rbpa::app
