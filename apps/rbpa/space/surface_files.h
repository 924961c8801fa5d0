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
  const SurfaceFacts& facts;             ///< the reconstruction; with facts.manifold, mesh files have one vertex a fan
  const SplitFans& fans;                 ///< the fans of the surface
  std::span<const std::uint32_t> order;  ///< numbers of the triangles as mesh files order them; empty: as the surface
  std::span<const Point3> seen;          ///< positions of the points in pictures
  std::span<const std::array<std::uint8_t, 3>> colors;  ///< empty, or a color for each point
  bool compact;
  std::optional<Shift> shift = std::nullopt;  ///< subtracted from the coordinates in STL and GLB
  std::span<const std::uint32_t> index = {};  ///< input index of each point; empty if point i has input index i
  std::span<const PointColumn> fields = {};

  /// Writes a mesh or a picture; `width` is the width of the picture in pixels. Throws as write_surface() and
  /// write_surface_png() do.
  void write(OutputFile& file, Format format, int width) const;
  /// Writes the boundary curves as OBJ, with a group for each kind of curve.
  void write_curves(OutputFile& file) const;
};

/// Returns a color for each confidence, from orange for 0 to blue for 1.
std::vector<std::array<std::uint8_t, 3>> colors_of(std::span<const double> confidence);

}  // namespace rbpa::app
