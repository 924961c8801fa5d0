// Simplification that lets no triangles cross, checked by crossing_triangles().
#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"
#include "rbpa/base/mesh.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/simplify/quadric_policy.h"
#include "space/simplify/triangle_sets.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using meshops::Vertex;

TEST_SUITE_BEGIN("space");

namespace {

using FloatMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using CornersOfPair = std::array<std::array<Point3, 3>, 2>;

template <typename Mesh>
Mesh crossing_mesh(const Triangles& t) {
  Mesh mesh;
  meshops::PolygonSoup soup;
  soup.points = t.points.size();
  for (const auto& corners : t.corners) soup.add_face(corners);
  const auto point_of = meshops::build_mesh(mesh, soup);
  using Number = typename Mesh::Point::value_type;
  for (const Vertex v : mesh.vertices()) {
    const Point3& p = t.points[point_of[static_cast<std::size_t>(v.idx())]];
    mesh.set_point(v, {static_cast<Number>(p.x), static_cast<Number>(p.y), static_cast<Number>(p.z)});
  }
  meshops::request_status(mesh);
  return mesh;
}

/// Returns the corners of each pair of triangles that cross, each triangle from its least corner on, sorted.
template <typename Mesh>
std::vector<CornersOfPair> crossings(const Mesh& mesh) {
  const std::vector<Point3> places = rbpa::places_of(mesh);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const meshops::Face f : meshops::live_faces(mesh)) {
    meshops::Halfedge h = mesh.halfedge_handle(f);
    for (std::uint32_t& corner : triangles.emplace_back()) {
      corner = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
  }
  std::vector<CornersOfPair> all;
  for (const auto& [s, t] : rbpa::crossing_triangles(places, triangles, std::numeric_limits<std::size_t>::max())) {
    CornersOfPair pair{};
    for (std::size_t k = 0; k < 3; ++k) pair[0][k] = places[triangles[s][k]], pair[1][k] = places[triangles[t][k]];
    for (auto& corners : pair)
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::sort(pair.begin(), pair.end());
    all.push_back(pair);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Simplifies the mesh step by step. Checks after each that only triangles cross that did before. Returns the number of
/// faces that are left.
template <typename Mesh>
std::size_t check_steps(Mesh mesh, bool at_ends) {
  const auto before = crossings(mesh);
  const auto topology = meshops::report(mesh).betti;
  std::size_t faces = meshops::report(mesh).faces;
  for (;;) {
    const auto made = rbpa::simplify(mesh, {.faces = faces * 3 / 4}, {.at_ends = at_ends, .no_crossings = true});
    const auto after = crossings(mesh);
    CHECK(std::includes(before.begin(), before.end(), after.begin(), after.end()));
    CHECK(meshops::report(mesh).betti == topology);
    faces = made.faces;
    if (made.end == meshops::SimplifyEnd::exhausted) return faces;
  }
}

/// Sphere whose points are moved along their rays at random, each to a radius from `least` to `least` + `range`.
Triangles rough_sphere(int times, double least, double range, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(least, least + range);
  Triangles t = sphere(times);
  for (Point3& p : t.points) {
    const double r = radius(random);
    p = {p.x * r, p.y * r, p.z * r};
  }
  return t;
}

/// Spheres within each other, with thin gaps.
Triangles onion(int times, std::size_t skins, double gap) {
  Triangles all;
  for (std::size_t i = 0; i < skins; ++i) append(all, rough_sphere(times, 1 - static_cast<double>(i) * gap, 0, 1));
  return all;
}

}  // namespace

TEST_CASE("boxes that are replaced are found where they are") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(0, 10);
  const auto some_box = [&] {
    rbpa::space::Box box;
    if (random() % 5 == 0) return box;
    const Point3 p{at(random), at(random), at(random)};
    box.include(p);
    box.include(Point3{p.x + at(random) / 5, p.y + at(random) / 5, p.z + at(random) / 5});
    return box;
  };
  for (const std::size_t count : {1U, 6U, 7U, 200U}) {
    std::vector<rbpa::space::Box> boxes;
    while (boxes.size() < count)
      if (const auto box = some_box(); box.low.x <= box.high.x) boxes.push_back(box);
    const rbpa::GoOn always;
    meshops::Steps step(always);
    rbpa::space::BoxTree tree(boxes, step);
    for (int i = 0; i < 500; ++i) {
      const auto k = static_cast<std::uint32_t>(random() % count);
      boxes[k] = some_box();
      tree.replace(k, boxes[k]);
      const rbpa::space::Box wanted = some_box();
      std::vector<std::uint32_t> found, expected;
      tree.for_each_meeting(wanted, [&](std::uint32_t j) { found.push_back(j); });
      for (std::uint32_t j = 0; j < count; ++j)
        if (boxes[j].meets(wanted)) expected.push_back(j);
      std::sort(found.begin(), found.end());
      CHECK(found == expected);
    }
  }
}

TEST_CASE("no triangles begin to cross on bundled meshes, to the least number of faces") {
  for (const char* name :
       {"m3_spot.off", "m3_torus.off", "m3_plate_holes.off", "m3_cube_no_bottom.off", "m3_bob.off"}) {
    CAPTURE(name);
    const Triangles t = read_off(bundled_data() / name);
    for (const bool at_ends : {false, true}) {
      check_steps(crossing_mesh<rbpa::Mesh>(t), at_ends);
      check_steps(crossing_mesh<FloatMesh>(t), at_ends);
    }
  }
}

TEST_CASE("sheets near each other cross after simplification, but not with no_crossings") {
  for (const bool at_ends : {false, true}) {
    const Triangles t = onion(3, 4, 0.04);
    auto mesh = crossing_mesh<rbpa::Mesh>(t);
    REQUIRE(crossings(mesh).empty());
    rbpa::simplify(mesh, {.faces = 200}, {.at_ends = at_ends});
    CHECK_FALSE(crossings(mesh).empty());
    mesh = crossing_mesh<rbpa::Mesh>(t);
    const auto made = rbpa::simplify(mesh, {.faces = 200}, {.at_ends = at_ends, .no_crossings = true});
    CHECK(crossings(mesh).empty());
    CHECK(made.faces < t.corners.size() / 2);
    check_steps(crossing_mesh<FloatMesh>(t), at_ends);
  }
}

TEST_CASE("random meshes, with spikes, pinches, boundaries and crossings, get no new crossings") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    Triangles t = rough_sphere(2, 0.2, 1, seed);
    append(t, rough_sphere(2, 0.1, seed % 3 == 0 ? 1.5 : 0.05, seed + 100));
    Triangles flat = sheet(6, seed);
    for (Point3& p : flat.points)
      p = {p.x / 2 - 1.5, p.y / 2 - 1.5, seed % 2 == 0 ? 3.0 : 0.01 * double(random() % 100)};
    append(t, flat);
    std::erase_if(t.corners, [&](const auto&) { return random() % 40 == 0; });  // holes; fans that meet in points
    check_steps(crossing_mesh<rbpa::Mesh>(t), seed % 2 == 1);
  }
}

TEST_CASE("triangles without an area cross nothing, and points on a small lattice make every kind of contact") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    Triangles t = sphere(1);
    append(t, sheet(3, seed));
    for (Point3& p : t.points) p = {double(random() % 4), double(random() % 4), double(random() % 3)};
    check_steps(crossing_mesh<rbpa::Mesh>(t), seed % 2 == 1);
  }
}

TEST_CASE("decimation names what it refused, and takes crossings of the input") {
  const Triangles t = onion(3, 3, 0.01);
  OpenMesh::PolyConnectivity mesh = crossing_mesh<rbpa::Mesh>(t);
  std::vector<Point3> places = t.points;
  const auto counts = rbpa::decimate(mesh, places, {.faces = 100, .no_crossings = true});
  REQUIRE(counts.refused.contains(rbpa::Decimation::crossing));
  CHECK(counts.refused.at(rbpa::Decimation::crossing) > 0);
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto broken = crossing_mesh<rbpa::Mesh>(sheet(4, 1));
    broken.set_point(Vertex(12), {0, wrong, 0});
    CHECK_THROWS_WITH_AS(rbpa::simplify(broken, {}, {.no_crossings = true}),
                         "simplify: found coordinates of vertex 12 that are not finite, expected numbers",
                         meshops::ContractViolation);
    CHECK(meshops::report(broken).faces == 32);
  }
}

TEST_CASE("a cone of many triangles, each of which is near all others, is simplified as any mesh") {
  const std::uint32_t n = 800;
  Triangles cone{{{0, 0, 1}}, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    cone.points.push_back({std::cos(angle), std::sin(angle), 0});
    cone.corners.push_back({0, i + 1, (i + 1) % n + 1});
  }
  auto mesh = crossing_mesh<rbpa::Mesh>(cone);
  rbpa::simplify(mesh, {.faces = 10}, {.no_crossings = true});
  CHECK(crossings(mesh).empty());
  CHECK(meshops::report(mesh).faces == 10);
}

TEST_SUITE_END();
