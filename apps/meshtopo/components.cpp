#include "meshtopo/components.h"

#include <algorithm>
#include <compare>

#include "io/interrupt.h"
#include "io/sort.h"
#include "meshops/topology/repair.h"
#include "rbpa/surface.h"
#include "rbpa/surface_components.h"

namespace rbpa::app {
namespace {

/// A side of a triangle that is one of its face too; across it from corner `corner` lies a neighbour.
struct FanSide {
  std::uint32_t low, high;  // its ends
  std::uint32_t triangle, corner;
  friend auto operator<=>(const FanSide&, const FanSide&) = default;
};

/// A surface without defects as triangles with neighbours, and the face of each.
struct Fans {
  Surface surface = {};
  std::vector<std::size_t> face = {};
};

Fans fans_of_faces(const meshops::PolygonSoup& soup, std::span<const std::array<double, 3>> positions) {
  Fans fans;
  std::vector<FanSide> sides;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const auto first = static_cast<std::uint32_t>(fans.surface.triangles.size());
    for_each_fan_triangle(soup.face(f), positions, [&](const std::array<std::uint32_t, 3>& triangle) {
      fans.surface.triangles.push_back(triangle);
      fans.face.push_back(f);
    });
    const auto end = static_cast<std::uint32_t>(fans.surface.triangles.size());
    for (std::uint32_t t = first; t < end; ++t) {
      const auto side_of = [&](std::uint32_t corner) {
        const std::uint32_t a = fans.surface.triangles[t][(corner + 1) % 3],
                            b = fans.surface.triangles[t][(corner + 2) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), t, corner});
      };
      // Corner 0 is that of the fan: within it one triangle lies across corner 1 from the next, across corner 2 from the one before.
      fans.surface.neighbors.push_back(
          {Surface::none, t + 1 < end ? t + 1 : Surface::none, t > first ? t - 1 : Surface::none});
      side_of(0);
      if (t + 1 == end) side_of(1);
      if (t == first) side_of(2);
    }
  }
  sort(sides);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const FanSide &a = sides[i], &b = sides[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    fans.surface.neighbors[a.triangle][a.corner] = b.triangle;
    fans.surface.neighbors[b.triangle][b.corner] = a.triangle;
  }
  return fans;
}

}  // namespace

KeptComponents kept_components(const MeshFile& mesh, const ComponentChoice& choice) {
  // In a repaired surface all faces agree, which takes no piece apart.
  const meshops::Repair repaired = meshops::repair(mesh.soup, until_interrupted());
  std::vector<std::array<double, 3>> positions;
  std::vector<Point3> points;
  for (const std::uint32_t p : repaired.stands_on) {
    positions.push_back(mesh.positions[p]);
    points.push_back({positions.back()[0], positions.back()[1], positions.back()[2]});
  }
  const Fans fans = fans_of_faces(repaired.soup, positions);
  const SurfaceComponents components = surface_components(points, fans.surface);
  const std::vector<bool> kept = kept_components(components, {}, choice);
  KeptComponents result;
  result.faces.assign(mesh.soup.faces(), false);
  for (std::size_t t = 0; t < fans.face.size(); ++t)
    if (kept[components.number[t]]) result.faces[repaired.face_was[fans.face[t]]] = true;
  result.dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  return result;
}

}  // namespace rbpa::app
