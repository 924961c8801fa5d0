#include "rbpa/space/solid/periodic_solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/infinity.h"
#include "support/periodic_sets.h"
#include "support/refusal_of.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::PeriodicSolid;
using rbpa::PeriodicVertex;
using rbpa::Point3;
using rbpa::Solid;

TEST_SUITE_BEGIN("space");

namespace {

using Offset = std::array<std::int8_t, 3>;

double most_radius(const Point3& box) { return std::nextafter(std::min({box.x, box.y, box.z}) / 2, 0.0); }

/// Returns the Delaunay tetrahedra of the 27 images of all points that have their first corner in the box, and a
/// circumradius of at most `alpha` and below half the shortest side of the box.
std::vector<PeriodicCorners> rows_by_definition(const Points3& in_box, const Point3& box, double alpha) {
  const AllImages all = all_images(in_box, box);
  const Solid delaunay = rbpa::solid(all.positions, infinity, {.threads = 1});
  const auto radii = rbpa::circumradii(all.positions, delaunay.simplices);
  std::vector<PeriodicCorners> rows;
  for (std::size_t t = 0; t < radii.size(); ++t) {
    const auto& row = delaunay.simplices[t];
    if (radii[t] > std::min(alpha, most_radius(box)) || all.vertices[row[0]].offset != Offset{0, 0, 0}) continue;
    rows.push_back({all.vertices[row[0]], all.vertices[row[1]], all.vertices[row[2]], all.vertices[row[3]]});
  }
  return rows;
}

/// A face: its points, ascending, and their offsets in boxes from the first.
using FaceKey = std::array<std::tuple<std::uint32_t, int, int, int>, 3>;
FaceKey key_of(std::array<PeriodicVertex, 3> face) {
  std::sort(face.begin(), face.end());
  FaceKey key;
  for (std::size_t i = 0; i < 3; ++i)
    key[i] = {face[i].point, face[i].offset[0] - face[0].offset[0], face[i].offset[1] - face[0].offset[1],
              face[i].offset[2] - face[0].offset[2]};
  return key;
}

FaceKey face_across(const PeriodicSolid& solid, std::uint32_t t, std::size_t k) {
  std::array<PeriodicVertex, 3> face;
  for (std::size_t i = 0; i < 3; ++i) face[i] = solid.vertices[solid.simplices[t][(k + 1 + i) % 4]];
  return key_of(face);
}

/// Counts the errors of the neighbors.
std::size_t wrong_neighbors(const PeriodicSolid& solid) {
  std::map<FaceKey, std::vector<std::uint32_t>> at;
  for (std::uint32_t t = 0; t < solid.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) at[face_across(solid, t, k)].push_back(t);
  std::size_t wrong = 0;
  for (std::uint32_t t = 0; t < solid.simplices.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& both = at[face_across(solid, t, k)];
      const std::uint32_t expected = both.size() == 1 ? Solid::none : both[0] == t ? both[1] : both[0];
      wrong += both.size() > 2 || solid.neighbors[t][k] != expected ? 1u : 0u;
    }
  return wrong;
}

double volume_of(const PeriodicSolid& solid) {
  double six = 0;
  for (const auto& row : solid.simplices) {
    const auto edge = [&](std::size_t k) { return solid.positions[row[k]] - solid.positions[row[0]]; };
    six += dot(edge(3), cross(edge(1), edge(2)));
  }
  return six / 6;
}

std::vector<double> some_alphas(const PeriodicSet& set, Random& random) {
  const double least = std::min({set.box.x, set.box.y, set.box.z});
  const double spacing =
      std::cbrt(set.box.x * set.box.y * set.box.z / double(std::max<std::size_t>(set.points.size(), 1)));
  const double most = most_radius(set.box) * (1 - 0x1p-48);  // whatever the sides are rounded to
  return {most, std::min(most, spacing * random.between(0.4, 1.5)), least / 4, std::sqrt(3.0) / 2};
}

}  // namespace

TEST_CASE("tetrahedra of a box are those of all points and their images, once each, with their neighbors") {
  std::size_t sets = 0, tetrahedra = 0, crossing = 0, complete = 0;
  for (std::uint64_t trial = 0; trial < 180; ++trial) {
    Random random(4000 + trial);
    const PeriodicSet set = periodic_set(trial, 1 + random.below(trial % 5 == 0 ? 90 : 30), random);
    CAPTURE(set.name);
    CAPTURE(trial);
    for (const double alpha : some_alphas(set, random)) {
      CAPTURE(alpha);
      const PeriodicSolid actual = rbpa::periodic_solid(set.points, set.box, alpha);
      const Points3 in_box = wrapped(set, actual.box);
      REQUIRE(rows_of(actual) == rows_by_definition(in_box, actual.box, alpha));
      CHECK(wrong_neighbors(actual) == 0);
      CHECK(std::is_sorted(actual.vertices.begin(), actual.vertices.end()));
      std::set<std::uint32_t> corners;
      for (std::size_t v = 0; v < actual.vertices.size(); ++v) {
        const auto& [point, offset] = actual.vertices[v];
        corners.insert(point);
        crossing += offset != Offset{0, 0, 0} ? 1u : 0u;
        const Point3& p = in_box[point];
        CHECK(actual.positions[v] ==
              Point3{p.x + offset[0] * actual.box.x, p.y + offset[1] * actual.box.y, p.z + offset[2] * actual.box.z});
      }
      std::map<Point3, std::uint32_t> first;
      std::vector<std::uint32_t> isolated;
      std::size_t duplicates = 0;
      for (std::uint32_t i = 0; i < in_box.size(); ++i) {
        const auto [at, is_new] = first.emplace(in_box[i], i);
        if (is_new && !corners.contains(i)) isolated.push_back(i);
        if (is_new) continue;
        REQUIRE(duplicates < actual.duplicates.size());
        CHECK(actual.duplicates[duplicates].index == i);
        CHECK(actual.duplicates[duplicates++].stands_for == at->second);
      }
      CHECK(actual.duplicates.size() == duplicates);
      CHECK(actual.isolated == isolated);
      CHECK(actual.distinct == first.size());
      ++sets;
      tetrahedra += actual.simplices.size();
      complete += volume_of(actual) > 0.999 * actual.box.x * actual.box.y * actual.box.z ? 1u : 0u;
    }
  }
  CHECK(tetrahedra > 30 * sets);
  CHECK(crossing > 10 * sets);
  CHECK(complete > sets / 10);
}

TEST_CASE("the boundary of a periodic solid is closed, with the tetrahedra behind it") {
  std::size_t triangles = 0;
  for (std::uint64_t trial = 0; trial < 36; ++trial) {
    Random random(4200 + trial);
    const PeriodicSet set = periodic_set(trial, 60, random);
    const PeriodicSolid solid = rbpa::periodic_solid(set.points, set.box, 0.4 * most_radius(set.box));
    // Each side occurs equally often in both directions.
    std::map<std::array<std::tuple<std::uint32_t, int, int, int>, 2>, int> sides;
    const auto boundary = rbpa::periodic_boundary(solid);
    for (const auto& triangle : boundary)
      for (std::size_t k = 0; k < 3; ++k) {
        std::array<PeriodicVertex, 2> side = {solid.vertices[triangle[k]], solid.vertices[triangle[(k + 1) % 3]]};
        const int turn = side[0].point < side[1].point ? 1 : -1;
        if (turn < 0) std::swap(side[0], side[1]);
        sides[{std::tuple{side[0].point, 0, 0, 0},
               std::tuple{side[1].point, side[1].offset[0] - side[0].offset[0], side[1].offset[1] - side[0].offset[1],
                          side[1].offset[2] - side[0].offset[2]}}] += turn;
      }
    for (const auto& [side, turns] : sides) CHECK(turns == 0);
    std::size_t open = 0;
    for (const auto& row : solid.neighbors)
      open += static_cast<std::size_t>(std::count(row.begin(), row.end(), Solid::none));
    CHECK(boundary.size() == open);
    triangles += boundary.size();
  }
  CHECK(triangles > 1000);
}

TEST_CASE("tetrahedra at infinity fill the box, or it is refused") {
  std::size_t filled = 0, refused = 0;
  for (std::uint64_t trial = 0; trial < 90; ++trial) {
    Random random(4300 + trial);
    const PeriodicSet set = periodic_set(trial, 10 + random.below(300), random);
    CAPTURE(set.name);
    const PeriodicSolid most = rbpa::periodic_solid(set.points, set.box, most_radius(set.box) * (1 - 0x1p-48));
    const double box = most.box.x * most.box.y * most.box.z;
    const bool fills = std::abs(volume_of(most) - box) < 1e-9 * box;
    for (const double alpha : {infinity, 0.5 * std::min({most.box.x, most.box.y, most.box.z})}) {
      try {
        const PeriodicSolid all = rbpa::periodic_solid(set.points, set.box, alpha);
        CHECK(fills);
        CHECK(all.simplices == most.simplices);
        CHECK(all.vertices == most.vertices);
        CHECK(all.neighbors == most.neighbors);
        CHECK(all.isolated.empty());
        for (const auto& row : all.neighbors) CHECK(std::find(row.begin(), row.end(), Solid::none) == row.end());
        ++filled;
      } catch (const rbpa::InvalidInput& e) {
        CHECK(!fills);
        CHECK(std::string(e.what()).find("has no point inside") != std::string::npos);
        ++refused;
      }
    }
  }
  CHECK(filled > 40);
  CHECK(refused > 10);
}

TEST_CASE("moved points have the same tetrahedra") {
  std::size_t tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < 80; ++trial) {
    Random random(4400 + trial);
    PeriodicSet set = periodic_set(trial % 8, 8 + random.below(60), random);  // sides of few bits
    CAPTURE(set.name);
    const double alpha = most_radius(set.box) * random.between(0.3, 1);
    set.points = wrapped(set, set.box);
    const PeriodicSolid before = rbpa::periodic_solid(set.points, set.box, alpha);
    PeriodicSet moved = set;
    const auto step = [&] { return std::ldexp(random.integer(-1'000'000, 1'000'000), -16); };
    const Point3 by = {step(), step(), step()};
    for (Point3& p : moved.points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
    const Points3 in_box = wrapped(moved, set.box);
    const PeriodicSolid after = rbpa::periodic_solid(moved.points, set.box, alpha);
    // Each point was moved into the box by an integer number of boxes.
    const auto boxes = [&](std::uint32_t i) {
      const Point3 &p = moved.points[i], &q = in_box[i];
      return std::array<int, 3>{static_cast<int>(std::lround((p.x - q.x) / set.box.x)),
                                static_cast<int>(std::lround((p.y - q.y) / set.box.y)),
                                static_cast<int>(std::lround((p.z - q.z) / set.box.z))};
    };
    std::vector<PeriodicCorners> expected = rows_of(before), actual = rows_of(after);
    for (PeriodicCorners& row : expected) {
      const auto of_first = boxes(row[0].point);
      for (PeriodicVertex& vertex : row) {
        const auto own = boxes(vertex.point);
        for (std::size_t axis = 0; axis < 3; ++axis)
          vertex.offset[axis] = static_cast<std::int8_t>(vertex.offset[axis] + own[axis] - of_first[axis]);
      }
    }
    std::sort(expected.begin(), expected.end());
    std::sort(actual.begin(), actual.end());
    CHECK(actual == expected);
    tetrahedra += actual.size();
  }
  CHECK(tetrahedra > 4000);
}

TEST_CASE("a periodic solid has the same bytes for any number of threads, with tiles and triples") {
  Random random(4500);
  PeriodicSet set{.name = "large", .points = {}, .box = {30, 31, 32}};
  for (int i = 0; i < 30'000; ++i) set.points.push_back({30 * random.unit(), 31 * random.unit(), 32 * random.unit()});
  for (const double alpha : {0.7, infinity}) {
    const PeriodicSolid one = rbpa::periodic_solid(set.points, set.box, alpha, {.threads = 1});
    const PeriodicSolid three = rbpa::periodic_solid(set.points, set.box, alpha, {.threads = 3});
    CHECK(one.simplices == three.simplices);
    CHECK(one.neighbors == three.neighbors);
    CHECK(one.vertices == three.vertices);
    CHECK(one.positions == three.positions);
    CHECK(wrong_neighbors(one) == 0);
  }
  const PeriodicSolid bare = rbpa::periodic_solid(set.points, set.box, 0.7, {.neighbors = false});
  CHECK(bare.neighbors.empty());
}

TEST_CASE("within() of a periodic triangulation is the solid of that alpha") {
  Random random(4600);
  for (std::uint64_t trial = 0; trial < 9; ++trial) {
    const PeriodicSet set = periodic_set(trial, 500, random);
    PeriodicSolid all;
    try {
      all = rbpa::periodic_solid(set.points, set.box, infinity);
    } catch (const rbpa::InvalidInput&) {
      continue;
    }
    const auto radii = rbpa::circumradii(all.positions, all.simplices);
    std::vector<double> sorted = radii;
    std::sort(sorted.begin(), sorted.end());
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      const double alpha = sorted[static_cast<std::size_t>(share * double(sorted.size() - 1))];
      const PeriodicSolid part = rbpa::within(all, radii, alpha),
                          expected = rbpa::periodic_solid(set.points, set.box, alpha);
      CHECK(part.simplices == expected.simplices);
      CHECK(part.neighbors == expected.neighbors);
      CHECK(part.vertices == expected.vertices);
      CHECK(part.positions == expected.positions);
      CHECK(part.isolated == expected.isolated);
      CHECK(part.distinct == expected.distinct);
      const Solid by_points = rbpa::without_offsets(part);
      CHECK(by_points.simplices.size() == part.simplices.size());
      CHECK(by_points.neighbors == part.neighbors);
    }
    CHECK(rbpa::min_alpha(rbpa::without_offsets(all), radii) <= rbpa::auto_alpha(rbpa::without_offsets(all), radii));
  }
}

TEST_CASE("wrong input of a periodic solid is refused, and a run can be cancelled") {
  const Points3 points = {{0, 0, 0}, {1, 2, 3}};
  const auto refusal = [&](const Points3& of, const Point3& box, double alpha) -> std::string {
    return refusal_of<rbpa::InvalidInput>([&] { rbpa::periodic_solid(of, box, alpha); });
  };
  CHECK(refusal(points, {4, 4, 4}, 0).find("alpha is 0") == 0);
  CHECK(refusal(points, {4, 4, 4}, std::nan("")).find("alpha is nan") == 0);
  CHECK(refusal(points, {4, 0, 4}, 1).find("a side of the box is 0") == 0);
  CHECK(refusal({{0, infinity, 0}}, {4, 4, 4}, 1).find("point 0") != std::string::npos);
  CHECK(refusal(points, {4, 4, 4}, 2)
            .find("a ball with a radius of half of the box's least side, 4, has no point inside: expected alpha below "
                  "that half, not "
                  "2") == 0);
  CHECK(refusal({}, {4, 4, 4}, 1).empty());
  CHECK(rbpa::periodic_solid({}, {4, 4, 4}, 1).simplices.empty());
  CHECK(rbpa::periodic_solid(points, {4, 4, 4}, 1).isolated.size() == 2);
  Random random(4700);
  const PeriodicSet set = periodic_set(0, 3000, random);
  CHECK_THROWS_AS(
      rbpa::periodic_solid(set.points, set.box, 1, {.progress = [](const rbpa::Progress&) { return false; }}),
      rbpa::Cancelled);
}
