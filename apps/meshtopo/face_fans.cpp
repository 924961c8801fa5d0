#include "meshtopo/face_fans.h"

#include <algorithm>
#include <compare>
#include <cstdint>

#include "io/interrupt.h"
#include "io/mesh/fan_triangles.h"
#include "io/sort.h"

namespace rbpa::app {
namespace {

/// A side of a triangle that is also a side of the face. The side is opposite to the corner `corner` of the triangle.
struct FanSide {
  std::uint32_t low, high;  // vertices at the ends of the side
  std::uint32_t triangle, corner;
  friend auto operator<=>(const FanSide&, const FanSide&) = default;
};

}  // namespace

FaceFans::FaceFans(const meshops::Repair& repaired, std::span<const std::array<double, 3>> positions) {
  std::vector<std::array<double, 3>> places;
  for (const std::uint32_t p : repaired.stands_on) {
    places.push_back(positions[p]);
    points.push_back({positions[p][0], positions[p][1], positions[p][2]});
  }
  std::vector<FanSide> sides;
  for (std::size_t f = 0; f < repaired.soup.faces(); ++f) {
    if (f % 16384 == 0) stop_if_interrupted();
    const auto first = static_cast<std::uint32_t>(surface.triangles.size());
    for_each_fan_triangle(repaired.soup.face(f), places, [&](const std::array<std::uint32_t, 3>& triangle) {
      surface.triangles.push_back(triangle);
      face.push_back(f);
    });
    const auto end = static_cast<std::uint32_t>(surface.triangles.size());
    for (std::uint32_t t = first; t < end; ++t) {
      const auto side_of = [&](std::uint32_t corner) {
        const std::uint32_t a = surface.triangles[t][(corner + 1) % 3], b = surface.triangles[t][(corner + 2) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), t, corner});
      };
      // Take corner 0 as the center of the fan. The next triangle of the fan is then opposite to corner 1, the previous
      // triangle opposite to corner 2.
      surface.neighbors.push_back(
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
    surface.neighbors[a.triangle][a.corner] = b.triangle;
    surface.neighbors[b.triangle][b.corner] = a.triangle;
  }
}

}  // namespace rbpa::app
