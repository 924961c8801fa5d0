#include "rbpa/space/solid/periodic/link_images.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {
namespace {

/// A face: its points, ascending, and the offsets in boxes of the second and the third point from the first.
struct Face {
  std::array<std::uint32_t, 3> points;
  std::array<std::int8_t, 6> apart;
  std::uint32_t at;

  bool operator==(const Face& other) const { return points == other.points && apart == other.apart; }
  bool operator<(const Face& other) const {
    return std::tie(points, apart, at) < std::tie(other.points, other.apart, other.at);
  }
};

Face face_at(const PeriodicSolid& solid, std::uint32_t at) {
  Triangle ascending = outer_face(solid.simplices[at / 4], at % 4);
  std::sort(ascending.begin(), ascending.end());  // by their points
  Face face{.points = {}, .apart = {}, .at = at};
  const PeriodicVertex& first = solid.vertices[ascending[0]];
  face.points[0] = first.point;
  for (std::size_t i = 1; i < 3; ++i) {
    const PeriodicVertex& other = solid.vertices[ascending[i]];
    face.points[i] = other.point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      face.apart[3 * i - 3 + axis] = static_cast<std::int8_t>(other.offset[axis] - first.offset[axis]);
  }
  return face;
}

}  // namespace

void link_images(std::span<const std::uint32_t> faces, PeriodicSolid& solid) {
  std::vector<Face> sorted;
  sorted.reserve(faces.size());
  for (const std::uint32_t at : faces) sorted.push_back(face_at(solid, at));
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (!(sorted[i] == sorted[i - 1])) continue;
    const std::uint32_t a = sorted[i - 1].at, b = sorted[i].at;
    solid.neighbors[a / 4][a % 4] = b / 4;
    solid.neighbors[b / 4][b % 4] = a / 4;
  }
}

}  // namespace rbpa::space
