#include "rbpa/space/solid/periodic_solid.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/distinct.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/solid/periodic/torus.h"

namespace rbpa {
namespace {

using Row = std::array<std::uint32_t, 4>;

/// A face of a tetrahedron, identified by data that all images of the face share: `points`, ascending, and `apart`, the
/// offsets in boxes of the second and the third point from the first. `at` is 4 t + k for the face across from corner k
/// of tetrahedron t.
struct ImageFace {
  std::array<std::uint32_t, 3> points;
  std::array<std::int8_t, 6> apart;
  std::uint32_t at;

  bool operator==(const ImageFace& other) const { return points == other.points && apart == other.apart; }
  bool operator<(const ImageFace& other) const {
    return std::tie(points, apart, at) < std::tie(other.points, other.apart, other.at);
  }
};

ImageFace face_at(const PeriodicSolid& solid, std::uint32_t at) {
  Triangle ascending = space::outer_face(solid.simplices[at / 4], at % 4);
  std::sort(ascending.begin(), ascending.end());  // by their points
  ImageFace face{.points = {}, .apart = {}, .at = at};
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

/// Links tetrahedra that have images of one face as neighbors, by a sort. `faces` has the number 4 t + k of the face
/// across from corner k of tetrahedron t.
void link_images(std::span<const std::uint32_t> faces, PeriodicSolid& solid) {
  std::vector<ImageFace> sorted;
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

/// Points of the box and their images, in the order of PeriodicSolid::vertices.
struct Images {
  std::vector<PeriodicVertex> vertices;
  std::vector<Point3> positions;
};

/// Returns the points of the box, and their images at most `margin` outside of the box.
Images images_of(std::span<const Point3> wrapped, const space::Torus& torus, double margin) {
  // Returns the offsets at which a coordinate is in the box or at most `margin` outside of it. Differences are exact.
  struct Range {
    std::int8_t first, last;
  };
  const auto range = [margin](double x, double side) {
    return Range{static_cast<std::int8_t>(side - x <= margin ? -1 : 0), static_cast<std::int8_t>(x <= margin ? 1 : 0)};
  };
  Images images;
  for (std::uint32_t i = 0; i < wrapped.size(); ++i) {
    const Point3& p = wrapped[i];
    const Range along_x = range(p.x, torus.box().x), along_y = range(p.y, torus.box().y),
                along_z = range(p.z, torus.box().z);
    for (std::int8_t x = along_x.first; x <= along_x.last; ++x)
      for (std::int8_t y = along_y.first; y <= along_y.last; ++y)
        for (std::int8_t z = along_z.first; z <= along_z.last; ++z) {
          images.vertices.push_back({i, {x, y, z}});
          images.positions.push_back(torus.image(p, {x, y, z}));
        }
  }
  return images;
}

/// Keeps the vertices that are corners of tetrahedra. Vertices and rows keep their order.
void keep_corners(PeriodicSolid& solid) {
  std::vector<std::uint32_t> number(solid.vertices.size(), Solid::none);
  for (const Row& row : solid.simplices)
    for (const std::uint32_t corner : row) number[corner] = 0;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == Solid::none) continue;
    number[v] = count;
    solid.vertices[count] = solid.vertices[v];
    solid.positions[count++] = solid.positions[v];
  }
  solid.vertices.resize(count);
  solid.positions.resize(count);
  for (Row& row : solid.simplices)
    for (std::uint32_t& corner : row) corner = number[corner];
}

void list_isolated(std::size_t points, PeriodicSolid& solid) {
  std::vector<bool> is_corner(points, false);
  for (const PeriodicVertex& vertex : solid.vertices) is_corner[vertex.point] = true;
  solid.isolated.clear();
  for_each_distinct(points, solid.duplicates, [&](std::uint32_t i) {
    if (!is_corner[i]) solid.isolated.push_back(i);
  });
}

/// Finds the tetrahedra of circumradius at most `radius`. All points and images within twice the radius of the box are
/// included, so every tetrahedron with a corner in the box is right. Each has an image with a corner in the box.
PeriodicSolid find_within(std::span<const Point3> wrapped, const space::Torus& torus, double radius,
                          const SolidOptions& options) {
  Images images = images_of(wrapped, torus, 2 * radius);
  Solid around = rbpa::solid(images.positions, radius,
                             {.neighbors = true, .threads = options.threads, .progress = options.progress});
  const auto is_in_box = [&](std::uint32_t v) { return images.vertices[v].offset == space::Offset{0, 0, 0}; };

  PeriodicSolid found;
  found.box = torus.box();
  std::vector<std::uint32_t> number(around.simplices.size(), Solid::none), kept;
  for (std::uint32_t t = 0; t < number.size(); ++t) {
    if (!is_in_box(around.simplices[t][0])) continue;  // this corner is an image of the point of least index
    number[t] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(t);
  }
  std::vector<std::uint32_t> at_sides;  // faces whose neighbor is not kept; an image of the neighbor may be
  found.simplices.reserve(kept.size());
  found.neighbors.reserve(kept.size());
  for (const std::uint32_t t : kept) {
    found.simplices.push_back(around.simplices[t]);
    Row neighbors = around.neighbors[t];
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (neighbors[k] != Solid::none) neighbors[k] = number[neighbors[k]];
      if (neighbors[k] == Solid::none) at_sides.push_back(4 * number[t] + k);
    }
    found.neighbors.push_back(neighbors);
  }
  for (const Duplicate& duplicate : around.duplicates)
    if (is_in_box(duplicate.index))
      found.duplicates.push_back({images.vertices[duplicate.index].point, images.vertices[duplicate.stands_for].point});
  found.distinct = wrapped.size() - found.duplicates.size();
  around = {};
  found.vertices = std::move(images.vertices);
  found.positions = std::move(images.positions);
  link_images(at_sides, found);
  keep_corners(found);
  list_isolated(wrapped.size(), found);
  return found;
}

/// Returns whether the tetrahedra fill the space: whether there is one, and every triangle has one on both sides.
bool is_complete(const PeriodicSolid& solid) {
  const auto has_all = [](const Row& row) { return std::find(row.begin(), row.end(), Solid::none) == row.end(); };
  return !solid.neighbors.empty() && std::all_of(solid.neighbors.begin(), solid.neighbors.end(), has_all);
}

}  // namespace

PeriodicSolid periodic_solid(std::span<const Point3> points, const Point3& box, double alpha,
                             const SolidOptions& options) {
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  space::check_points(points);
  const space::Torus torus(box);
  std::vector<Point3> wrapped;
  wrapped.reserve(points.size());
  for (const Point3& p : points) wrapped.push_back(torus.wrapped(p));

  // Most tetrahedra are small. If the tetrahedra within a radius below alpha fill the space, there are no other
  // tetrahedra, and images farther out are not needed.
  constexpr double first_in_spacings = 2;
  const double spacing = std::cbrt(torus.box().x) * std::cbrt(torus.box().y) * std::cbrt(torus.box().z) /
                         std::cbrt(static_cast<double>(std::max<std::size_t>(points.size(), 1)));
  const double last = std::min(alpha, torus.most_radius());
  double radius = std::min(first_in_spacings * spacing, last);
  PeriodicSolid found = find_within(wrapped, torus, radius, options);
  bool complete = is_complete(found);
  while (radius < last && !complete) {
    radius = std::min(2 * radius, last);
    found = find_within(wrapped, torus, radius, options);
    complete = is_complete(found);
  }
  if (last < alpha && !complete)
    throw InvalidInput(
        "a ball with a radius of half of the box's least side, " +
        text(std::min({torus.box().x, torus.box().y, torus.box().z})) + ", has no point inside: expected " +
        (std::isfinite(alpha) ? "alpha below that half, not " + text(alpha) + ", or " : "") + "more points in the box");
  if (!options.neighbors) found.neighbors = {};
  return found;
}

Solid without_offsets(const PeriodicSolid& solid) {
  Solid result;
  result.simplices = solid.simplices;
  for (Row& row : result.simplices)
    for (std::uint32_t& corner : row) corner = solid.vertices[corner].point;
  result.neighbors = solid.neighbors;
  result.duplicates = solid.duplicates;
  result.isolated = solid.isolated;
  result.distinct = solid.distinct;
  return result;
}

std::vector<Triangle> periodic_boundary(const PeriodicSolid& solid) {
  meshops::require(
      solid.neighbors.size() == solid.simplices.size(),
      "periodic_boundary: the solid has no neighbors, expected periodic_solid() with the option neighbors");
  std::vector<Triangle> boundary;
  for (std::size_t t = 0; t < solid.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      if (solid.neighbors[t][k] != Solid::none) continue;
      boundary.push_back(space::outer_face(solid.simplices[t], k));
    }
  return boundary;
}

PeriodicSolid within(const PeriodicSolid& solid, std::span<const double> radii, double alpha) {
  meshops::require_one_each("radii", radii.size(), "values", solid.simplices.size(), "tetrahedra");
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  PeriodicSolid part{.box = solid.box,
                     .vertices = solid.vertices,
                     .positions = solid.positions,
                     .simplices = {},
                     .neighbors = {},
                     .duplicates = solid.duplicates,
                     .isolated = {},
                     .distinct = solid.distinct};
  std::vector<std::uint32_t> number(radii.size(), Solid::none);
  std::uint32_t count = 0;
  for (std::size_t t = 0; t < radii.size(); ++t)
    if (radii[t] <= alpha) number[t] = count++;
  for (std::size_t t = 0; t < radii.size(); ++t) {
    if (number[t] == Solid::none) continue;
    part.simplices.push_back(solid.simplices[t]);
    if (solid.neighbors.empty()) continue;
    Row neighbors = solid.neighbors[t];
    for (std::uint32_t& n : neighbors) n = n == Solid::none ? Solid::none : number[n];
    part.neighbors.push_back(neighbors);
  }
  keep_corners(part);
  list_isolated(solid.distinct + solid.duplicates.size(), part);
  return part;
}

}  // namespace rbpa
