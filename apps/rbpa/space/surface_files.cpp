#include "space/surface_files.h"

#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "io/mesh/vertices_of_points.h"
#include "io/mesh/write_mesh.h"
#include "io/values_at.h"
#include "picture/surface_picture.h"

namespace rbpa::app {
namespace {

/// Returns the triangles with vertices renumbered; points that no triangle uses are left out.
SplitFans without_unused(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t points) {
  SplitFans result{.triangles = {triangles.begin(), triangles.end()}, .point = {}};
  std::vector<std::uint32_t> place(points, 0);
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle) place[corner] = 1;
  for (std::uint32_t i = 0; i < points; ++i) {
    if (place[i] == 0) continue;
    place[i] = static_cast<std::uint32_t>(result.point.size());
    result.point.push_back(i);
  }
  for (auto& triangle : result.triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
  return result;
}

void write_picture(OutputFile& file, const SurfaceFiles& of, int width) {
  std::array<std::vector<std::array<std::uint32_t, 2>>, 3> sides;  // sides of the curves of each kind
  for (std::size_t i = 0; i < of.facts.holes.size(); ++i)
    for (const RimEdge& edge : of.facts.holes[i].edges)
      sides[static_cast<std::size_t>(of.facts.kinds[i])].push_back({edge.from, edge.to});
  std::vector<std::uint32_t> unused;
  for (const UnusedPoint& point : of.facts.unused) unused.push_back(point.index);
  write_surface_png(
      file, {of.seen, of.facts.surface.triangles, sides[0], sides[1], sides[2], unused, of.colors, of.facts.filled},
      width);
}

}  // namespace

void SurfaceFiles::write(OutputFile& file, Format format, int width) const {
  if (format == Format::png) return write_picture(file, *this, width);
  const std::vector<Point3>& points = facts.points;
  const auto& triangles = facts.surface.triangles;
  // Write an .npy file in canonical order, whatever the order of other files is.
  if (format == Format::npy)
    return write_surface(file, format, {.vertices = points, .triangles = triangles, .index = index});
  SpaceMesh mesh{.vertices = points,
                 .triangles = triangles,
                 .normals = facts.normals,
                 .colors = colors,
                 .confidence = facts.confidence,
                 .shift = shift,
                 .index = index,
                 .fields = {fields, {}}};
  SplitFans used;
  std::optional<VerticesOfPoints> own;
  const bool splits = facts.manifold || format == Format::glb;  // splitting a scene is safe: no other file refers to
                                                                // its vertices
  if (splits || compact) {
    if (!splits) used = without_unused(triangles, points.size());
    const SplitFans& of = splits ? fans : used;
    own.emplace(mesh, of.triangles, of.point, splits);
    mesh = own->mesh();
  }
  std::vector<std::array<std::uint32_t, 3>> ordered;
  if (!order.empty()) {
    ordered = values_at(mesh.triangles, order);
    mesh.triangles = ordered;
  }
  write_surface(file, format, mesh);
}

std::vector<std::array<std::uint8_t, 3>> colors_of(std::span<const double> confidence) {
  constexpr std::array sure{0x86, 0xBC, 0xE4}, in_doubt{0xD5, 0x5E, 0x00};
  std::vector<std::array<std::uint8_t, 3>> colors;
  colors.reserve(confidence.size());
  for (const double share : confidence) {
    auto& color = colors.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<std::uint8_t>(std::lround(in_doubt[k] + share * (sure[k] - in_doubt[k])));
  }
  return colors;
}

void SurfaceFiles::write_curves(OutputFile& file) const {
  std::vector<std::array<double, 3>> positions;
  positions.reserve(facts.points.size());
  for (const Point3& p : facts.points) positions.push_back({p.x, p.y, p.z});
  std::vector<Polyline> loops;
  std::vector<std::string_view> groups;
  for (std::size_t kind = 0; kind < kind_names.size(); ++kind)
    for (std::size_t i = 0; i < facts.holes.size(); ++i) {
      if (facts.kinds[i] != static_cast<CurveKind>(kind)) continue;
      groups.emplace_back(kind_names[kind]);
      Polyline& loop = loops.emplace_back();
      for (const RimEdge& edge : facts.holes[i].edges) loop.push_back(edge.from);
    }
  write_polylines(file, Format::obj, positions, loops, groups);
}

}  // namespace rbpa::app
