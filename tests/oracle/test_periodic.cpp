#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "oracle/cgal_dangling.h"
#include "oracle/cgal_periodic.h"
#include "oracle/cgal_tetrahedra.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/periodic_topology.h"
#include "rbpa/space/solid/periodic_solid.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/arguments.h"
#include "support/periodic_sets.h"

using namespace rbpa_test;
using rbpa::PeriodicSolid;
using rbpa::Point3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns a text for people: points and sides as doubles that read back.
std::string text(const PeriodicSet& set) {
  std::ostringstream out;
  out << std::hexfloat << set.name << ", box " << set.box.x << " " << set.box.y << " " << set.box.z << ", points";
  for (const Point3& p : set.points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  return out.str();
}

std::vector<std::array<PeriodicCorner, 4>> sorted_rows(const PeriodicSolid& solid) {
  std::vector<std::array<PeriodicCorner, 4>> rows;
  for (const PeriodicCorners& corners : rows_of(solid)) {
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [point, offset] = corners[k];
      row[k] = {static_cast<int>(point), offset[0], offset[1], offset[2]};
    }
    std::sort(row.begin(), row.end());
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

using Vertices = std::vector<rbpa::PeriodicVertex>;  // ascending
using Boxes = std::array<int, 3>;

Boxes boxes_of(const rbpa::PeriodicVertex& vertex) { return {vertex.offset[0], vertex.offset[1], vertex.offset[2]}; }
/// Returns the image whose first corner is in the box.
Vertices in_box(Vertices corners) {
  const auto first = corners[0].offset;
  for (auto& corner : corners)
    for (std::size_t axis = 0; axis < 3; ++axis)
      corner.offset[axis] = static_cast<std::int8_t>(corner.offset[axis] - first[axis]);
  return corners;
}

std::size_t rank(const std::vector<Boxes>& vectors) {
  std::size_t most = 0;
  const auto cross = [](const Boxes& a, const Boxes& b) {
    return Boxes{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  for (const Boxes& a : vectors) {
    if (a != Boxes{}) most = std::max(most, std::size_t{1});
    for (const Boxes& b : vectors) {
      const Boxes n = cross(a, b);
      if (n == Boxes{}) continue;
      most = std::max(most, std::size_t{2});
      for (const Boxes& c : vectors)
        if (n[0] * c[0] + n[1] * c[1] + n[2] * c[2] != 0) return 3;
    }
  }
  return most;
}

/// Returns for each void of the full complex the numbers of its tetrahedra and of the directions in which it
/// percolates, sorted: by CGAL's triangulation of 27 images and its classification of their triangles, and by
/// union–find over the cells in the box, each with its place. Requires: tetrahedra that fill the box.
std::vector<std::array<std::size_t, 2>> voids_by_images(const AllImages& all, const DelaunayByCgal& delaunay,
                                                        AlphaShapeByCgal& shape, double alpha) {
  const auto named = [&](const auto& corners) {
    Vertices vertices;
    for (const std::uint32_t corner : corners) vertices.push_back(all.vertices[corner]);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  const auto is_in_box = [](const Vertices& corners) { return boxes_of(corners[0]) == Boxes{}; };
  std::set<Vertices> filled, walls;
  for (const auto& row : delaunay.within(alpha).simplices)
    if (const Vertices corners = named(row); is_in_box(corners)) filled.insert(corners);
  for (const auto& triangle : shape.dangling(alpha).triangles)
    if (const Vertices corners = named(triangle); is_in_box(corners)) walls.insert(corners);
  std::vector<Vertices> cells;  // cells outside the complex
  std::map<Vertices, std::vector<std::pair<std::size_t, Boxes>>> at_face;
  for (const auto& row : delaunay.within(infinity).simplices) {
    const Vertices corners = named(row);
    if (!is_in_box(corners) || filled.contains(corners)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      Vertices face = corners;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
      const Boxes place = boxes_of(face[0]);
      face = in_box(face);
      if (!walls.contains(face)) at_face[face].emplace_back(cells.size(), place);
    }
    cells.push_back(corners);
  }
  std::vector<std::size_t> set(cells.size());
  std::iota(set.begin(), set.end(), std::size_t{0});
  std::vector<Boxes> place(cells.size(), Boxes{});
  std::vector<std::vector<Boxes>> around(cells.size());
  for (const auto& [face, both] : at_face) {
    if (both.size() != 2) continue;  // beside a tetrahedron of the complex
    const auto& [a, at_a] = both[0];
    const auto& [b, at_b] = both[1];
    Boxes step{};  // from the place of b to the place where it meets a
    for (std::size_t axis = 0; axis < 3; ++axis) step[axis] = place[a][axis] + at_a[axis] - at_b[axis] - place[b][axis];
    const std::size_t from = set[b], to = set[a];
    if (from == to) {
      around[to].push_back(step);
      continue;
    }
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (set[c] == from) {
        set[c] = to;
        for (std::size_t axis = 0; axis < 3; ++axis) place[c][axis] += step[axis];
      }
    around[to].insert(around[to].end(), around[from].begin(), around[from].end());
  }
  std::vector<std::array<std::size_t, 2>> voids;
  for (std::size_t s = 0; s < cells.size(); ++s)
    if (const auto count = std::count(set.begin(), set.end(), s); count > 0) {
      std::sort(around[s].begin(), around[s].end());
      around[s].erase(std::unique(around[s].begin(), around[s].end()), around[s].end());
      voids.push_back({static_cast<std::size_t>(count), rank(around[s])});
    }
  std::sort(voids.begin(), voids.end());
  return voids;
}

}  // namespace

TEST_CASE("periodic cubes have CGAL's periodic Delaunay tetrahedra") {
  const std::uint64_t sets = argument("count", 100);
  std::size_t compared = 0, tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Random random(600 + trial);
    PeriodicSet set = periodic_set(trial, 20 + random.below(200), random);
    set.box = {8, 8, 8};
    set.points = wrapped(set, set.box);
    std::sort(set.points.begin(), set.points.end());
    set.points.erase(std::unique(set.points.begin(), set.points.end()), set.points.end());
    random.shuffle(set.points);
    PeriodicSolid actual;
    try {
      actual = rbpa::periodic_solid(set.points, set.box, infinity);
    } catch (const rbpa::InvalidInput&) {
      continue;
    }
    if (sorted_rows(actual) != periodic_by_cgal(set.points, 8)) FAIL_CHECK(text(set));
    ++compared;
    tetrahedra += actual.simplices.size();
  }
  CHECK(compared > sets / 3);
  CHECK(tetrahedra > 200 * compared);
}

TEST_CASE("periodic boxes have those of CGAL's Delaunay tetrahedra of 27 images that are within alpha") {
  const std::uint64_t sets = argument("count", 100);
  std::size_t tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Random random(700'000 + trial);
    const PeriodicSet set = periodic_set(trial, 2 + random.below(40), random);
    const double least = std::min({set.box.x, set.box.y, set.box.z});
    const double alpha = trial % 4 == 0 ? std::sqrt(3.0) / 2 : least * random.between(0.05, 0.499);
    const PeriodicSolid actual = rbpa::periodic_solid(set.points, set.box, std::min(alpha, 0.499 * least));
    const AllImages all = all_images(wrapped(set, actual.box), actual.box);
    const TetrahedraByCgal around = DelaunayByCgal(all.positions).within(std::min(alpha, 0.499 * least));
    std::vector<PeriodicCorners> expected;
    for (const auto& row : around.simplices)
      if (all.vertices[row[0]].offset == std::array<std::int8_t, 3>{0, 0, 0})
        expected.push_back({all.vertices[row[0]], all.vertices[row[1]], all.vertices[row[2]], all.vertices[row[3]]});
    if (rows_of(actual) != expected) FAIL_CHECK(text(set));
    tetrahedra += expected.size();
  }
  CHECK(tetrahedra > 20 * sets);
}

TEST_CASE("voids of periodic full complexes are those of CGAL's triangles of 27 images, with their directions") {
  const std::uint64_t sets = argument("count", 100);
  std::array<std::size_t, 4> dimensions{};
  std::size_t compared = 0, only_full = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Random random(800'000 + trial);
    PeriodicSet set = periodic_set(trial, 30 + random.below(50), random);
    PeriodicSolid delaunay;
    try {
      delaunay = rbpa::periodic_solid(set.points, set.box, infinity);
    } catch (const rbpa::InvalidInput&) {
      continue;
    }
    const std::vector<double> radii = rbpa::circumradii(delaunay.positions, delaunay.simplices);
    Points3 points = wrapped(set, delaunay.box);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const AllImages all = all_images(points, delaunay.box);
    const DelaunayByCgal expected(all.positions);
    AlphaShapeByCgal shape(all.positions);
    for (const double share : {0.1, 0.3, 0.6, 0.9}) {
      std::vector<double> sorted = radii;
      std::sort(sorted.begin(), sorted.end());
      // The square is a double, as CGAL requires.
      const double alpha = std::round(256 * sorted[static_cast<std::size_t>(share * double(sorted.size()))]) / 256;
      if (!(alpha > 0)) continue;
      std::vector<std::array<std::size_t, 2>> found;
      const auto topology = rbpa::periodic_topology(delaunay, radii, alpha);
      for (const rbpa::PeriodicPart& hollow : topology.voids) {
        found.push_back({hollow.tetrahedra, hollow.dimension});
        ++dimensions[hollow.dimension];
      }
      std::sort(found.begin(), found.end());
      if (found != voids_by_images(all, expected, shape, alpha)) FAIL_CHECK(text(set) << ", alpha " << alpha);
      const auto solid = rbpa::periodic_topology(delaunay, radii, alpha, rbpa::ComplexKind::solid);
      only_full += found.size() > solid.voids.size() ? 1u : 0u;
      ++compared;
    }
  }
  CHECK(compared > sets);
  CHECK(only_full > compared / 4);
  for (const std::size_t count : dimensions) CHECK(count > 0);
}
