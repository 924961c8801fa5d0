// What: writes the files of `rbpa surface`: meshes, pictures, boundary curves.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "io/mesh/single_precision.h"
#include "io/point_columns.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/split_fans.h"
#include "space/surface_report.h"

namespace rbpa::app {

/// A view of the data to write; owns nothing.
struct SurfaceFiles {
  const SurfaceFacts& facts;             ///< the reconstruction; if facts.manifold, files have a vertex for each fan
  const SplitFans& fans;                 ///< the fans of the surface
  std::span<const std::uint32_t> order;  ///< numbers of the triangles in the order of mesh files; empty: the surface's
  std::span<const Point3> seen;          ///< positions of the points in pictures
  std::span<const std::array<std::uint8_t, 3>> colors;  ///< empty, or one for each point
  bool compact;
  std::optional<Shift> shift = std::nullopt;  ///< subtracted from coordinates of STL and GLB
  std::span<const std::uint32_t> index = {};  ///< input index of each point; empty if point i has index i
  std::span<const PointColumn> fields = {};

  /// Writes a mesh or a picture; `width` is the width of the picture in pixels. Throws as write_surface() and
  /// write_surface_png().
  void write(OutputFile& file, Format format, int width) const;
  /// Writes the boundary curves as OBJ, with a group for each kind of curve.
  void write_curves(OutputFile& file) const;
};

/// Returns a color for each confidence, which is from 0 (orange) to 1 (blue).
std::vector<std::array<std::uint8_t, 3>> colors_of(std::span<const double> confidence);

}  // namespace rbpa::app
