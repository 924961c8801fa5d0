// Simplification by quadric errors, on files of meshes and on surfaces with a known error.
#include "rbpa/space/simplify/quadric_policy.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "meshops/stellar/undo.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"
#include "rbpa/base/mesh.h"
#include "rbpa/space/predicate/normal_sign.h"
#include "space/simplify/triangle_sets.h"
#include "support/data_folder.h"
#include "support/refusal_of.h"

using namespace rbpa_test;
using meshops::Edge;
using meshops::Face;
using meshops::Halfedge;
using meshops::Vertex;
using rbpa::Point3;
using rbpa::QuadricOptions;

TEST_SUITE_BEGIN("space");

namespace {

template <typename Mesh>
void build(const Triangles& t, Mesh& mesh) {
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
}

/// Returns the triangles of a mesh as points, each from its least corner on, sorted.
template <typename Mesh>
std::vector<std::array<Point3, 3>> canonical(const Mesh& mesh) {
  const auto places = rbpa::places_of(mesh);
  std::vector<std::array<Point3, 3>> all;
  for (const Face f : meshops::live_faces(mesh)) {
    std::array<Point3, 3> t;
    Halfedge h = mesh.halfedge_handle(f);
    for (Point3& p : t) {
      p = places[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())];
      h = mesh.next_halfedge_handle(h);
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Checks directions of triangles at every collapse, soundness and topology at every tenth, or two hundred times.
template <typename Mesh>
struct Watch : meshops::SimplifyVisitor {
  explicit Watch(const Mesh& mesh)
      : before(meshops::report(mesh)),
        places(rbpa::places_of(mesh)),
        stride(std::max<std::size_t>(10, mesh.n_faces() / 200)) {}
  void collapsed(const Mesh& mesh, const meshops::WeldEffect& effect, double) {
    effects.push_back(effect);
    check_directions(mesh, effect.survivor);
    if (effects.size() % stride == 0) check(mesh);
  }
  void check(const Mesh& mesh) const {
    CHECK(meshops::validate(mesh).empty());
    const meshops::TopologyReport now = meshops::report(mesh);
    CHECK(now.betti == before.betti);
    CHECK(now.boundary_curves == before.boundary_curves);
    CHECK(now.genus == before.genus);
    CHECK(now.solid_components == before.solid_components);
  }
  /// Checks by integers that no triangle at the survivor turned against what it was with either end in its place.
  void check_directions(const Mesh& mesh, Vertex survivor) {
    const auto at = [](Vertex v) { return static_cast<std::size_t>(v.idx()); };
    const auto& p = mesh.point(survivor);
    const Point3 now = {double(p[0]), double(p[1]), double(p[2])};
    const Vertex removed = effects.back().removed.vertex;
    for (const Halfedge out : mesh.voh_range(survivor)) {
      if (mesh.is_boundary(out)) continue;
      const Point3& a = places[at(mesh.to_vertex_handle(out))];
      const Point3& b = places[at(mesh.to_vertex_handle(mesh.next_halfedge_handle(out)))];
      const auto agrees = [&](Vertex old) {
        return rbpa::space::exact::compare_normals(places[at(old)], a, b, now, a, b) > 0;
      };
      CHECK((agrees(survivor) || agrees(removed)));
    }
    places[at(survivor)] = now;
  }
  meshops::TopologyReport before;
  std::vector<Point3> places;
  std::size_t stride;
  std::vector<meshops::WeldEffect> effects;
};

using FloatMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// Simplifies a mesh to a tenth and then as far as possible, and undoes all.
template <typename Mesh>
void check_there_and_back(const Triangles& t, const QuadricOptions& options) {
  Mesh mesh;
  build(t, mesh);
  const std::size_t faces = mesh.n_faces();
  Watch watch(mesh);
  const auto result = rbpa::simplify(mesh, {.faces = faces / 10}, options, watch);
  CHECK(result.collapses > faces / 4);
  rbpa::simplify(mesh, {}, options, watch);
  watch.check(mesh);
  for (auto effect = watch.effects.rbegin(); effect != watch.effects.rend(); ++effect) meshops::undo(mesh, *effect);
  CHECK(meshops::report(mesh).faces == faces);
  CHECK(meshops::validate(mesh).empty());
}

/// Checks the meshes of a folder. Returns: their number.
std::size_t check_files(const std::filesystem::path& folder) {
  std::size_t files = 0;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".off") continue;
    INFO(entry.path().string());
    const Triangles t = read_off(entry.path());
    check_there_and_back<rbpa::Mesh>(t, {});
    check_there_and_back<FloatMesh>(t, {.at_ends = true});
    ++files;
  }
  return files;
}

}  // namespace

TEST_CASE("meshes keep topology and directions down to the least number of triangles, and undo() leads back") {
  CHECK(check_files(bundled_data()) >= 5);
}

TEST_CASE("further meshes keep topology and directions down to the least number of triangles, and undo() leads back") {
  CHECK((check_files(further_data()) > 0) == has_further_data());
}

TEST_CASE("the result does not depend on the order of points and triangles, bit for bit") {
  std::mt19937 random(5);
  for (const char* name : {"m3_spot.off", "m3_bob.off", "m3_plate_holes.off"}) {
    const Triangles t = read_off(bundled_data() / name);
    for (const bool at_ends : {false, true}) {
      rbpa::Mesh one, other;
      build(shuffled(t, random), one);
      build(shuffled(t, random), other);
      const std::size_t faces = one.n_faces() / 5;
      rbpa::simplify(one, {.faces = faces}, {.at_ends = at_ends});
      rbpa::simplify(other, {.faces = faces}, {.at_ends = at_ends});
      CHECK(canonical(one) == canonical(other));
    }
  }
}

TEST_CASE("a sheet in a plane stays in the plane, with its outline and its area, at any size and place") {
  for (const std::pair<double, double>& at : {std::pair(0.0, 1.0), {1e6, 1.0}, {0.0, 1e150}, {0.0, 1e-200}}) {
    const double shift = at.first, size = at.second;
    CAPTURE(size);
    Triangles t = sheet(12, 3);
    for (Point3& p : t.points) p = {(p.x + shift) * size, p.y * size, 7 * size};
    rbpa::Mesh mesh;
    build(t, mesh);
    rbpa::simplify(mesh, {.faces = 30});
    CHECK(meshops::validate(mesh).empty());
    double area = 0;
    for (const Face f : meshops::live_faces(mesh)) {
      std::array<Point3, 3> c;
      Halfedge h = mesh.halfedge_handle(f);
      for (Point3& p : c) {
        const auto& q = mesh.point(mesh.to_vertex_handle(h));
        p = {q[0] / size - shift, q[1] / size, q[2] / size};
        h = mesh.next_halfedge_handle(h);
        CHECK(std::abs(p.z - 7) < 1e-6);
        CHECK((p.x > -1e-6 && p.x < 12 + 1e-6 && p.y > -1e-6 && p.y < 12 + 1e-6));
      }
      const double twice = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
      CHECK(twice > 0);
      area += twice / 2;
    }
    CHECK(area == doctest::Approx(144).epsilon(1e-6));
  }
}

TEST_CASE("with at_ends every vertex left is one of the input, and stays the vertex that it was") {
  const Triangles t = read_off(bundled_data() / "m3_spot.off");
  rbpa::Mesh mesh;
  build(t, mesh);
  const auto places = rbpa::places_of(mesh);
  rbpa::simplify(mesh, {.faces = 200}, {.at_ends = true});
  const auto now = rbpa::places_of(mesh);
  for (const Vertex v : meshops::live_vertices(mesh))
    CHECK(now[static_cast<std::size_t>(v.idx())] == places[static_cast<std::size_t>(v.idx())]);
}

TEST_CASE(
    "a sphere of 8192 triangles with 400 left is within 2 % of the sphere, and the place of least error is better") {
  double greatest[2] = {0, 0};
  for (const bool at_ends : {false, true}) {
    rbpa::Mesh mesh;
    build(sphere(5), mesh);
    rbpa::simplify(mesh, {.faces = 400}, {.at_ends = at_ends});
    for (const Face f : meshops::live_faces(mesh)) {
      rbpa::Mesh::Point middle(0, 0, 0);
      for (const Vertex v : mesh.fv_range(f)) middle += mesh.point(v) / 3;
      greatest[at_ends] = std::max(greatest[at_ends], std::abs(1 - middle.norm()));
    }
  }
  CHECK(greatest[0] < 0.02);
  CHECK(greatest[0] < greatest[1]);
}

TEST_CASE("corners and sharp edges of a cube stay where they are") {
  const Triangles t = read_off(bundled_data() / "m3_cube_no_bottom.off");
  rbpa::Mesh mesh;
  build(t, mesh);
  const auto before = rbpa::places_of(mesh);
  const auto box = [](const std::vector<Point3>& points, const rbpa::Mesh& of) {
    std::array<double, 2> range = {1e300, -1e300};
    for (const Vertex v : meshops::live_vertices(of)) {
      const Point3& p = points[static_cast<std::size_t>(v.idx())];
      range = {std::min({range[0], p.x, p.y, p.z}), std::max({range[1], p.x, p.y, p.z})};
    }
    return range;
  };
  const auto whole = box(before, mesh);
  const auto result = rbpa::simplify(mesh, {.cost = 1e-4});
  CHECK(result.end != meshops::SimplifyEnd::faces);
  CHECK(result.faces <= 14);
  const auto left = box(rbpa::places_of(mesh), mesh);
  CHECK(left[0] == doctest::Approx(whole[0]).epsilon(0.01));
  CHECK(left[1] == doctest::Approx(whole[1]).epsilon(0.01));
}

namespace {

/// Policy that allows every collapse that MeshQuadrics allows, and counts them.
template <typename Mesh>
struct Counting : rbpa::MeshQuadrics<Mesh> {
  using rbpa::MeshQuadrics<Mesh>::MeshQuadrics;
  bool allows(const Mesh& mesh, Edge e, const Point3& place) {
    const bool is_allowed = rbpa::MeshQuadrics<Mesh>::allows(mesh, e, place);
    allowed += is_allowed;
    return is_allowed;
  }
  std::size_t allowed = 0;
};

template <typename Mesh>
void check_derived() {
  Mesh one, other;
  build(read_off(bundled_data() / "m3_spot.off"), one);
  build(read_off(bundled_data() / "m3_spot.off"), other);
  Counting<Mesh> policy(one);
  const auto made = meshops::simplify(one, policy, {.faces = 500});
  rbpa::simplify(other, {.faces = 500});
  CHECK(policy.allowed == made.collapses);
  CHECK(canonical(one) == canonical(other));
  for (const Vertex v : meshops::live_vertices(one))
    CHECK(rbpa::places_of(one)[static_cast<std::size_t>(v.idx())] ==
          policy.places()[static_cast<std::size_t>(v.idx())]);
}

}  // namespace

TEST_CASE(
    "a class derived from MeshQuadrics moves the points of the mesh as rbpa::simplify() does, in double and float") {
  check_derived<rbpa::Mesh>();
  check_derived<FloatMesh>();
}

TEST_CASE("places that are not finite are refused with the mesh untouched, and fewer places than vertices too") {
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    rbpa::Mesh mesh;
    build(sheet(4, 1), mesh);
    mesh.set_point(Vertex(12), {0, wrong, 0});
    for (const std::size_t faces : {std::size_t{0}, std::size_t{32}})
      CHECK(refusal_of<meshops::ContractViolation>([&] { rbpa::simplify(mesh, {.faces = faces}); }) ==
            "simplify: found coordinates of vertex 12 that are not finite, expected numbers");
    CHECK_THROWS_AS(meshops::simplify(mesh, rbpa::MeshQuadrics(mesh)), meshops::ContractViolation);
    CHECK(meshops::report(mesh).faces == 32);
  }
  rbpa::Mesh mesh;
  build(sheet(4, 1), mesh);
  CHECK_THROWS_AS(rbpa::QuadricPolicy(mesh, std::vector<Point3>(3)), meshops::ContractViolation);
  rbpa::Mesh empty;
  meshops::request_status(empty);
  CHECK(rbpa::simplify(empty, {}).collapses == 0);
}

TEST_CASE("options of quadrics that are out of their range are refused by name") {
  rbpa::Mesh mesh;
  build(sheet(4, 1), mesh);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto refusal = [&](const QuadricOptions& options) {
    return refusal_of<meshops::ContractViolation>([&] { rbpa::simplify(mesh, {.faces = 30}, options); });
  };
  for (const double wrong : {-1.0, nan, infinite}) {
    CHECK(refusal({.boundary_weight = wrong}) == "QuadricOptions: boundary_weight is not a finite number, at least 0");
    CHECK(refusal({.sharp_weight = wrong}) == "QuadricOptions: sharp_weight is not a finite number, at least 0");
    CHECK(refusal({.normal_deviation = wrong}) ==
          "QuadricOptions: normal_deviation is not a finite number, at least 0");
    CHECK(refusal({.sharp_angle = wrong}) == "QuadricOptions: sharp_angle is not an angle from 0 to 180 degrees");
  }
  CHECK(refusal({.boundary_weight = 0, .sharp_weight = 0, .sharp_angle = 180, .normal_deviation = 0}).empty());
}

TEST_CASE("the minimum of a quadric is where its planes meet, and none is given where they leave it open") {
  rbpa::Quadric q = rbpa::Quadric::plane({1, 0, 0}, {3, 9, 9}, 2) + rbpa::Quadric::plane({0, 0.6, 0.8}, {0, 5, 0}, 1);
  CHECK_FALSE(q.minimum());
  CHECK(q({3, 5, 0}) == doctest::Approx(0));
  CHECK(q({5, 5, 0}) == doctest::Approx(8));
  q += rbpa::Quadric::plane({0, 0, 1}, {0, 0, -2}, 5);
  const auto least = q.minimum();
  REQUIRE(least);
  CHECK(least->x == doctest::Approx(3));
  CHECK(least->z == doctest::Approx(-2));
  CHECK(0.6 * (least->y - 5) + 0.8 * least->z == doctest::Approx(0));
  const rbpa::Quadric noisy = rbpa::Quadric::plane({0, 0, 1}, {1, 2, 3}, 2, 0.25);
  CHECK(noisy({1, 2, 3}) == doctest::Approx(0));
  CHECK(noisy({1, 4, 3}) == doctest::Approx(2));
  CHECK(noisy.minimum()->y == doctest::Approx(2));
}

TEST_CASE("the sign of the product of two normals is exact where rounding decides nothing") {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  const double tiny = std::ldexp(1.0, -1060);
  CHECK(rbpa::space::compare_normals(a, b, c, a, b, {0, tiny, 1}) == 1);
  CHECK(rbpa::space::compare_normals(a, b, c, a, b, {0, -tiny, 1}) == -1);
  CHECK(rbpa::space::compare_normals(a, b, c, a, b, {0, 0, 1}) == 0);
  CHECK(rbpa::space::compare_normals(a, b, c, a, b, {2, 0, 0}) == 0);
  std::mt19937_64 random(9);
  for (int i = 0; i < 2000; ++i) {
    std::array<Point3, 6> p;
    for (Point3& q : p) q = {double(random() % 5), double(random() % 5), double(random() % 5) * 1e-9};
    CHECK(rbpa::space::compare_normals(p[0], p[1], p[2], p[3], p[4], p[5]) ==
          rbpa::space::exact::compare_normals(p[0], p[1], p[2], p[3], p[4], p[5]));
  }
  for (int i = 0; i < 2000; ++i) {  // where products of doubles underflow or overflow
    std::array<Point3, 6> p;
    for (std::size_t t = 0; t < 6; t += 3) {
      const int exponent = t == 0 ? static_cast<int>(random() % 12) - 542 : static_cast<int>(random() % 1000) - 480;
      const auto number = [&] { return std::ldexp(double(random() >> 11), exponent - 53); };
      for (std::size_t k = t; k < t + 3; ++k) p[k] = {number(), number(), number()};
    }
    CHECK(rbpa::space::compare_normals(p[0], p[1], p[2], p[3], p[4], p[5]) ==
          rbpa::space::exact::compare_normals(p[0], p[1], p[2], p[3], p[4], p[5]));
  }
}

TEST_SUITE_END();
