#include "triangulation/watertight_file.h"

#include <cstddef>
#include <vector>

#include "io/failure.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/repair/watertight.h"
#include "triangulation/surface_counts.h"

namespace rbpa::app {

std::string why_file_is_open(Format format, const std::string& file, std::span<const Point3> points,
                             std::span<const std::array<std::uint32_t, 3>> triangles, const std::optional<Shift>& shift,
                             const SurfaceOptions& options) {
  if (!has_single_precision(format)) return "";
  const SinglePositions rounded = single_positions(format, points, triangles, shift, file);
  std::string why = why_not_kept(rounded, format, points, triangles, file);
  if (!why.empty()) return why;
  if (const std::size_t edges = non_manifold_edges(triangles); format == Format::stl && edges > 0)
    return file + ": STL joins what is at equal positions, and " + counted(edges, "edge") +
           " would have more than two triangles (.ply, .obj and .off keep them apart)";
  const auto crossing = [&](const SinglePositions& positions) {
    std::vector<Point3> places;
    for (const auto& [x, y, z] : positions.at) places.push_back({x, y, z});
    return crossing_triangles(places, triangles, most_crossing_pairs, options).size();
  };
  const std::size_t pairs = crossing(rounded);
  if (pairs == 0) return "";
  return file + ": single precision makes " + (pairs < most_crossing_pairs ? "" : "at least ") +
         counted(pairs, "pair") + " of triangles cross" +
         way_to_keep((!shift || shift->by) &&
                     crossing(single_positions(format, points, triangles, Shift(), file)) == 0);
}

}  // namespace rbpa::app
