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
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface.h"
#include "space/surface_report.h"

namespace rbpa::app {

/// A view of the data to write; owns nothing.
struct SurfaceFiles {
  std::span<const Point3> points;
  std::span<const Point3> normals;                      ///< empty, or one for each point
  std::span<const std::array<std::uint8_t, 3>> colors;  ///< empty, or one for each point
  std::span<const double> confidence;  ///< confidence of estimated normals; empty, or one for each point
  const Surface& surface;
  const SplitFans& fans;                 ///< of the surface
  std::span<const std::uint32_t> order;  ///< of triangles in mesh files; empty: that of the surface
  const SurfaceFacts& facts;             ///< its holes and unused points, and whether vertices are fans
  const std::vector<bool>& filled;       ///< for each triangle whether it fills a hole; empty: none does
  bool compact;
  std::optional<Shift> shift = std::nullopt;  ///< of STL and GLB
  std::span<const std::uint32_t> index = {};  ///< of each point in the input; empty: its own number

  /// Writes a mesh or a picture; `width` is that of the picture in pixels.
  void write(OutputFile& file, Format format, int width) const;
  /// Writes the boundary curves as OBJ, with a group for each kind.
  void write_curves(OutputFile& file) const;
};

/// Returns a color for each confidence: from orange for 0 to blue for 1.
std::vector<std::array<std::uint8_t, 3>> colors_of(std::span<const double> confidence);

}  // namespace rbpa::app
