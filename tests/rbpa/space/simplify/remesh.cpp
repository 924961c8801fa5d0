// Remeshing: topology, evenness, curves and distance, on bundled and random meshes; refusals.
#include "rbpa/space/simplify/remesh.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/stellar/collapse.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "space/simplify/placed.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using meshops::Vertex;
using rbpa::Remeshing;
using rbpa::RemeshOptions;

TEST_SUITE_BEGIN("space");

namespace {

struct RemeshedMesh : Placed {
  explicit RemeshedMesh(const Triangles& t) : Placed(t, false) {}
  const Point3& at(Vertex v) const { return places[static_cast<std::size_t>(v.idx())]; }
  double length(meshops::Edge e) const {
    const auto h = mesh.halfedge_handle(e, 0);
    const Point3 &a = at(mesh.from_vertex_handle(h)), &b = at(mesh.to_vertex_handle(h));
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  }
  double mean_length() const {
    double sum = 0;
    for (const auto e : mesh.edges()) sum += length(e);
    return sum / static_cast<double>(mesh.n_edges());
  }
  /// Returns the scalar product of twice the area's vector of a face with the vector to its first corner.
  double volume_of(meshops::Face f) const {
    std::array<Point3, 3> p;
    std::size_t k = 0;
    for (const Vertex v : mesh.fv_range(f)) p[k++] = at(v);
    return p[0].x * (p[1].y * p[2].z - p[1].z * p[2].y) + p[0].y * (p[1].z * p[2].x - p[1].x * p[2].z) +
           p[0].z * (p[1].x * p[2].y - p[1].y * p[2].x);
  }
};

/// Checks that the mesh is sound, and has the topology of the report.
void check_topology(const meshops::Connectivity& mesh, const meshops::TopologyReport& before) {
  CHECK(meshops::validate(mesh).empty());
  const meshops::TopologyReport now = meshops::report(mesh);
  CHECK(now.betti == before.betti);
  CHECK(now.boundary_curves == before.boundary_curves);
  CHECK(now.genus == before.genus);
  CHECK(now.solid_components == before.solid_components);
}

/// The share of inner vertices with six edges, and the share of edges from 4/5 to 4/3 of the length.
struct Evenness {
  Evenness(const RemeshedMesh& with, double length) {
    double inner = 0;
    for (const Vertex v : with.mesh.vertices())
      if (!with.mesh.is_isolated(v) && !with.mesh.is_boundary(v)) {
        ++inner;
        regular += with.mesh.valence(v) == 6;
      }
    regular /= inner;
    for (const auto e : with.mesh.edges())
      near_length += with.length(e) >= length * 4 / 5 && with.length(e) <= length * 4 / 3;
    near_length /= static_cast<double>(with.mesh.n_edges());
  }
  double regular = 0, near_length = 0;
};

/// Returns whether a point is on an edge of the cube from 0 to 1, up to rounding.
int sides_of_cube(const Point3& p) {
  int sides = 0;
  for (const double x : {p.x, p.y, p.z}) sides += std::min(std::abs(x), std::abs(x - 1)) < 1e-12;
  return sides;
}

/// A sphere, or a sheet, from which triangles are removed at random, so that it has boundary curves and pinches.
Triangles torn(unsigned seed) {
  std::mt19937 random(seed);
  Triangles t = seed % 2 == 0 ? sphere(3) : sheet(12, seed);
  std::erase_if(t.corners, [&](const auto&) { return random() % 9 == 0; });
  for (Point3& p : t.points) p.z += 0.1 * std::sin(3 * p.x);
  return t;
}

using Ring = std::vector<std::uint32_t>;

/// Adds a copy of the ring at each height, and the walls between the copies in order, as a CAD program writes them: two
/// triangles for each side.
std::vector<Ring> extrude(Triangles& t, const std::vector<Point3>& ring, const std::vector<double>& heights) {
  std::vector<Ring> rings;
  for (const double z : heights) {
    Ring& copy = rings.emplace_back();
    for (const Point3& p : ring) {
      copy.push_back(static_cast<std::uint32_t>(t.points.size()));
      t.points.push_back({p.x, p.y, z});
    }
  }
  for (std::size_t k = 1; k < rings.size(); ++k)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      t.corners.push_back({rings[k - 1][i], rings[k - 1][j], rings[k][j]});
      t.corners.push_back({rings[k - 1][i], rings[k][j], rings[k][i]});
    }
  return rings;
}

std::vector<Point3> circle(std::uint32_t sides, double radius, double turn) {
  std::vector<Point3> ring;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = turn * 2 * 3.14159265358979 * (i + 0.5) / sides;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return ring;
}

/// A convex prism, whose ends are fans of triangles.
Triangles prism(const std::vector<Point3>& ring, double height) {
  Triangles t;
  const auto rings = extrude(t, ring, {0, height});
  for (std::size_t i = 2; i < ring.size(); ++i) {
    t.corners.push_back({rings[0][0], rings[0][i], rings[0][i - 1]});
    t.corners.push_back({rings[1][0], rings[1][i - 1], rings[1][i]});
  }
  return t;
}

/// A square plate with a round hole of a multiple of four sides, which turn by less than the sharp angle.
Triangles plate(std::uint32_t sides) {
  Triangles t;
  const auto outer = extrude(t, circle(4, 30, 1), {0, 5}), inner = extrude(t, circle(sides, 4, -1), {0, 5});
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides, a = 3 - i / (sides / 4), b = 3 - j / (sides / 4);
    for (const std::size_t k : {0U, 1U}) {
      const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
        t.corners.push_back(k == 1 ? std::array{p, q, r} : std::array{p, r, q});
      };
      add(inner[k][i], inner[k][j], outer[k][a]);
      if (a != b) add(inner[k][j], outer[k][b], outer[k][a]);
    }
  }
  return t;
}

}  // namespace

TEST_CASE("with an error, the result is within it, and near all of the given mesh, of parts from CAD as well") {
  struct Row {
    const char* name;
    Triangles given;
    double length;
    double uncrossed = 1;  // greatest error, in lengths, at which no triangles cross: none is promised
  };
  // Edges that turn by up to 60 degrees, which are not sharp, beside large flat faces.
  const std::vector<Row> rows = {
      {"prism of 6 sides", prism(circle(6, 5, 1), 40), 5},
      {"prism of 8 sides", prism(circle(8, 5, 1), 40), 5},
      {"prism of 32 sides", prism(circle(32, 5, 1), 40), 5},
      {"plate with a hole of 8 sides", plate(8), 5},
      {"plate with a hole of 32 sides", plate(32), 5},
      {"chamfer", prism({{0, 0, 0}, {40, 0, 0}, {40, 29, 0}, {39, 30, 0}, {0, 30, 0}}, 20), 5},
      {"m3_spot.off", read_off(bundled_data() / "m3_spot.off"), 0.3},
      {"m3_plate_holes.off", read_off(bundled_data() / "m3_plate_holes.off"), 20, 0.01},
      {"sphere", sphere(3), 0.3},
  };
  for (const Row& row : rows)
    for (const double part : {0.02, 0.005}) {
      INFO(std::string(row.name) << " " << part);
      RemeshedMesh with(row.given);
      const auto before = meshops::report(with.mesh);
      const double error = part * row.length;
      const Remeshing counts =
          rbpa::remesh(with.mesh, with.places, {.length = row.length, .error = error, .rounds = 5, .measured = true});
      check_topology(with.mesh, before);
      CHECK(counts.distance.value() <= error);
      CHECK(counts.distance_back.value() <= 1.2 * error);
      if (part <= row.uncrossed)
        CHECK(rbpa::crossing_triangles(with.places, rbpa::space::corners_of(with.mesh), 1).empty());
      CHECK(Evenness(with, row.length).regular >= 0.5);
      // The distances are those of the arrays.
      const RemeshedMesh given(row.given);
      const auto triangles = rbpa::space::corners_of(with.mesh), first = rbpa::space::corners_of(given.mesh);
      const rbpa::space::SurfaceDistance from_given(given.places, first), from_result(with.places, triangles);
      CHECK(rbpa::space::distance_of(with.mesh, with.places, from_given, {}) <= 1.05 * error);
      CHECK(rbpa::space::distance_of(given.mesh, given.places, from_result, {}) == counts.distance_back);
    }
}

TEST_CASE("remesh makes edges of about one length and six at a vertex, near the input, with the same topology") {
  struct Row {
    const char* name;
    double factor;                          // of the mean length of edges
    double regular, near_length, distance;  // the last in lengths
  };
  for (const Row& row : {
           Row{"m3_bob.off", 0.5, 0.8, 0.99, 0.4},
           {"m3_bob.off", 1, 0.7, 0.98, 0.5},
           {"m3_cube_no_bottom.off", 0.5, 0.9, 0.99, 1e-9},
           {"m3_cube_no_bottom.off", 1, 0.75, 0.99, 1e-9},
           {"m3_plate_holes.off", 0.5, 0.75, 0.95, 0.5},
           {"m3_plate_holes.off", 1, 0.6, 0.9, 0.4},
           {"m3_spot.off", 0.5, 0.9, 0.98, 0.3},
           {"m3_spot.off", 1, 0.85, 0.98, 0.3},
           {"m3_torus.off", 1, 0.8, 0.98, 0.12},
           {"m3_torus.off", 2, 0.8, 0.98, 0.2},
       }) {
    INFO(std::string(row.name) << " " << row.factor);
    RemeshedMesh with(read_off(bundled_data() / row.name));
    const auto before = meshops::report(with.mesh);
    const double length = row.factor * with.mean_length();
    const std::size_t given = with.mesh.n_faces();
    const Remeshing counts = rbpa::remesh(with.mesh, with.places, {.length = length, .measured = true});
    CHECK(counts.given == given);
    CHECK(counts.left == with.mesh.n_faces());
    CHECK(with.places.size() == with.mesh.n_vertices());
    check_topology(with.mesh, before);
    const Evenness found(with, length);
    CHECK(found.regular >= row.regular);
    CHECK(found.near_length >= row.near_length);
    CHECK(counts.distance.value() <= row.distance * length);
  }
}

TEST_CASE("remesh keeps the topology of torn and touching meshes, down to lengths of their size") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    INFO(seed);
    const Triangles t = torn(seed);
    const double size = seed % 2 == 0 ? 1 : 12;
    for (const double length : {0.1 * size, 0.3 * size, size}) {
      RemeshedMesh with(t);
      const auto before = meshops::report(with.mesh);
      rbpa::remesh(with.mesh, with.places, {.length = length, .rounds = 3, .keep_boundary = seed % 3 == 0});
      check_topology(with.mesh, before);
      CHECK(std::is_sorted(with.places.begin(), with.places.end()));
    }
  }
}

TEST_CASE("the remeshed mesh is the same, numbers included, for shuffled vertices and faces") {
  std::mt19937 random(11);
  std::vector<Triangles> all = {sheet(15, 4), sphere(4)};
  for (const char* name : {"m3_spot.off", "m3_cube_no_bottom.off", "m3_plate_holes.off"})
    all.push_back(read_off(bundled_data() / name));
  for (const Triangles& t : all) {
    RemeshedMesh one(t), other(shuffled(t, random));
    const RemeshOptions options{.length = 1.3 * one.mean_length(), .rounds = 4};
    rbpa::remesh(one.mesh, one.places, options);
    rbpa::remesh(other.mesh, other.places, options);
    CHECK(one.places == other.places);
    CHECK(meshops::soup_of(one.mesh).corners == meshops::soup_of(other.mesh).corners);
  }
}

TEST_CASE("lengths at vertices are those of the list, grow slowly, and make the same mesh in any order") {
  std::mt19937 random(12);
  const auto wanted = [](const Point3& p) { return p.x < 7 ? 0.3 : 9.0; };
  const Triangles t = sheet(40, 4);
  RemeshedMesh one(t), other(shuffled(t, random)), even(t);
  const auto before = meshops::report(one.mesh);
  for (RemeshedMesh* with : {&one, &other}) {
    std::vector<double> lengths;
    for (const Point3& p : with->places) lengths.push_back(wanted(p));
    rbpa::remesh(with->mesh, with->places, {.length = 2, .lengths = lengths});
  }
  CHECK(one.places == other.places);
  CHECK(meshops::soup_of(one.mesh).corners == meshops::soup_of(other.mesh).corners);
  check_topology(one.mesh, before);
  std::array<double, 3> sum{}, count{};  // left, where the length grows, right
  for (const auto e : one.mesh.edges()) {
    const double x = one.at(one.mesh.to_vertex_handle(one.mesh.halfedge_handle(e, 0))).x, length = one.length(e);
    const std::size_t part = x < 6 ? 0 : x < 12 ? 1 : 2;
    sum[part] += length;
    ++count[part];
    CHECK(length <= 4.0 / 3 * std::clamp(0.3 + 0.5 * (x - 5), 0.3, 2.0) + 0.5);
  }
  CHECK(sum[0] / count[0] == doctest::Approx(0.3).epsilon(0.1));
  CHECK(sum[2] / count[2] == doctest::Approx(2).epsilon(0.15));
  // A list without shorter lengths is none.
  RemeshedMesh same(t);
  rbpa::remesh(even.mesh, even.places, {.length = 2});
  rbpa::remesh(same.mesh, same.places, {.length = 2, .lengths = std::vector<double>(t.points.size(), 3)});
  CHECK(even.places == same.places);
}

TEST_CASE("with an error, edges are as long as the curvature allows, also between coarse triangles, and no shorter") {
  const auto remeshed = [](RemeshedMesh& with, double length, double error) {
    return rbpa::remesh(with.mesh, with.places, {.length = length, .error = error, .measured = true});
  };
  for (const double error : {0.003, 0.012}) {
    INFO(error);
    RemeshedMesh ball(sphere(6));
    CHECK(remeshed(ball, 1, error).distance.value() < 1.5 * error);
    CHECK(ball.mean_length() == doctest::Approx(std::sqrt(6 * error)).epsilon(0.12));
    // Points of a cylinder of height 6 at its ends only.
    Triangles tube;
    constexpr std::uint32_t sides = 48;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * 3.14159265358979 * i / sides;
      for (const double z : {0.0, 6.0}) tube.points.push_back({std::cos(angle), std::sin(angle), z});
      const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
      tube.corners.push_back({a, b, b + 1});
      tube.corners.push_back({a, b + 1, a + 1});
    }
    RemeshedMesh round(tube);
    remeshed(round, 1, error);
    for (const auto e : round.mesh.edges()) CHECK(round.length(e) < 4.0 / 3 * std::sqrt(6 * error) + 1e-9);
    CHECK(round.mean_length() > 0.75 * std::sqrt(6 * error));
  }
  // Powers of two keep all digits.
  RemeshedMesh ball(sphere(3));
  remeshed(ball, 1, 0.012);
  for (const double unit : {0x1p-160, 0x1p+160}) {
    Triangles t = sphere(3);
    for (Point3& p : t.points) p = {unit * p.x, unit * p.y, unit * p.z};
    RemeshedMesh scaled(t);
    remeshed(scaled, unit, unit * 0.012);
    CHECK(scaled.places.size() == ball.places.size());
    CHECK(scaled.mean_length() == unit * ball.mean_length());
  }
  // A plane, with a triangle whose corners are on one line.
  RemeshedMesh flat({.points = {{0, 0, 0}, {8, 0, -8}, {4, 0, -4}, {4, -3, -1}, {4, 3, -7}},
                     .corners = {{0, 1, 3}, {1, 0, 2}, {0, 4, 2}, {4, 1, 2}}});
  RemeshedMesh plain = flat;
  remeshed(flat, 3, 0.01);
  rbpa::remesh(plain.mesh, plain.places, {.length = 3});
  CHECK(flat.places == plain.places);
  // The faces of a cube are flat, and its edges sharp.
  RemeshedMesh cube(read_off(bundled_data() / "m3_cube_no_bottom.off")), even = cube;
  const double length = cube.mean_length();
  remeshed(cube, length, length / 1000);
  rbpa::remesh(even.mesh, even.places, {.length = length});
  CHECK(cube.places == even.places);
}

TEST_CASE("sharp edges and the boundary of a cube without bottom stay straight, and its corners stay") {
  const Triangles t = read_off(bundled_data() / "m3_cube_no_bottom.off");
  Point3 low = t.points[0], high = low;
  for (const Point3& p : t.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  for (const double length : {0.07, 0.3}) {
    RemeshedMesh with(t);
    for (Point3& p : with.places)
      p = {(p.x - low.x) / (high.x - low.x), (p.y - low.y) / (high.y - low.y), (p.z - low.z) / (high.z - low.z)};
    const Remeshing counts = rbpa::remesh(with.mesh, with.places, {.length = length, .measured = true});
    CHECK(counts.distance.value() < 1e-9);
    std::size_t corners = 0, on_edges = 0;
    for (const Point3& p : with.places) {
      CHECK(sides_of_cube(p) >= 1);
      corners += sides_of_cube(p) == 3;
      on_edges += sides_of_cube(p) == 2;
    }
    CHECK(corners == 8);
    CHECK(on_edges >= static_cast<std::size_t>(12 * (0.75 / length - 1)));
    for (const auto e : with.mesh.edges()) {
      if (!with.mesh.is_boundary(e)) continue;
      const auto h = with.mesh.halfedge_handle(e, 0);
      CHECK(sides_of_cube(with.at(with.mesh.to_vertex_handle(h))) >= 2);
    }
  }
}

TEST_CASE("with keep_boundary, boundary vertices and edges are those of the input") {
  const auto boundary_of = [](const RemeshedMesh& with) {
    std::set<std::array<Point3, 2>> all;
    for (const auto h : with.mesh.halfedges())
      if (with.mesh.is_boundary(h))
        all.insert({with.at(with.mesh.from_vertex_handle(h)), with.at(with.mesh.to_vertex_handle(h))});
    return all;
  };
  for (const double factor : {0.3, 3.0}) {
    RemeshedMesh with(sheet(10, 3));
    const auto before = boundary_of(with);
    CHECK(before.size() == 40);
    rbpa::remesh(with.mesh, with.places, {.length = factor, .keep_boundary = true});
    CHECK(boundary_of(with) == before);
    RemeshedMesh moved(sheet(10, 3));
    rbpa::remesh(moved.mesh, moved.places, {.length = factor});
    CHECK(boundary_of(moved).size() == doctest::Approx(40 / factor).epsilon(0.2));
  }
}

TEST_CASE("no triangle of a sphere or of a plane sheet turns over, and a sheet stays in its plane with its area") {
  for (const double length : {0.05, 0.3, 0.9}) {
    RemeshedMesh ball(sphere(4));
    rbpa::remesh(ball.mesh, ball.places, {.length = length});
    for (const auto f : ball.mesh.faces()) CHECK(ball.volume_of(f) > 0);
    for (const Point3& p : ball.places) CHECK(std::hypot(p.x, p.y, p.z) == doctest::Approx(1).epsilon(0.01));
    RemeshedMesh flat(sheet(8, 5));
    for (Point3& p : flat.places) p.z = 1;
    rbpa::remesh(flat.mesh, flat.places, {.length = 3 * length});
    double sum = 0;
    for (const auto f : flat.mesh.faces()) {
      CHECK(flat.volume_of(f) > 0);
      sum += flat.volume_of(f);
    }
    for (const Point3& p : flat.places) CHECK(p.z == 1);
    CHECK(sum == doctest::Approx(2 * 64));
  }
}

TEST_CASE("options that do not suit the mesh are refused, and so are polygons, double edges and wrong places") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Triangles t = read_off(bundled_data() / "m3_spot.off");
  RemeshedMesh with(t);
  const std::vector<Point3> places = with.places;
  for (const double length : {nan, infinity, -infinity, 0.0, -1.0, 1e-300, 1e-61, 1e-9, 1e-4, 100.0, 1e300}) {
    INFO(length);
    CHECK_THROWS_AS(rbpa::remesh(with.mesh, with.places, {.length = length}), rbpa::InvalidInput);
  }
  for (const double angle : {nan, -1.0, 181.0})
    CHECK_THROWS_AS(rbpa::remesh(with.mesh, with.places, {.length = 0.1, .sharp_angle = angle}), rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(rbpa::remesh(with.mesh, with.places, {.length = 0}),
                       "remesh: found the length 0, expected a number from 1e-60 to 1e60", rbpa::InvalidInput);
  const std::vector<double> lengths(t.points.size(), 0.1);
  CHECK_THROWS_WITH_AS(
      rbpa::remesh(with.mesh, with.places, {.length = 0.1, .lengths = std::span(lengths).first(lengths.size() - 1)}),
      doctest::Contains("expected one for each of "), rbpa::InvalidInput);
  for (const double wrong : {nan, infinity, 0.0, -1.0}) {
    std::vector<double> of_vertices = lengths;
    of_vertices.back() = wrong;
    CHECK_THROWS_AS(rbpa::remesh(with.mesh, with.places, {.length = 0.1, .lengths = of_vertices}), rbpa::InvalidInput);
    CHECK_THROWS_AS(rbpa::remesh(with.mesh, with.places, {.length = 0.1, .error = wrong}), rbpa::InvalidInput);
  }
  CHECK_THROWS_WITH_AS(rbpa::remesh(with.mesh, with.places, {.length = 0.1, .error = 1e-9}),
                       doctest::Contains("(a greater error, or greater lengths)"), rbpa::InvalidInput);
  // The length that the message of a limit names is accepted, and the limit is kept.
  std::string message;
  try {
    rbpa::remesh(with.mesh, with.places, {.length = 1e-3, .most_faces = 30000});
  } catch (const rbpa::InvalidInput& error) {
    message = error.what();
  }
  const std::string before = "remesh: found the length 0.001, expected at least ";
  REQUIRE(message.starts_with(before));
  CHECK(message.ends_with(", which makes at most 30000 triangles of this mesh"));
  CHECK(with.places == places);
  CHECK(with.mesh.n_faces() == t.corners.size());
  const double least = std::stod(message.substr(before.size()));
  CHECK(rbpa::remesh(with.mesh, with.places, {.length = least, .rounds = 1, .most_faces = 30000}).left <= 30000);

  RemeshedMesh wrong(t);
  wrong.places[17].y = nan;
  CHECK_THROWS_WITH_AS(rbpa::remesh(wrong.mesh, wrong.places, {.length = 0.1}),
                       "remesh: found coordinates of vertex 17 that are not finite, expected numbers",
                       rbpa::InvalidInput);
  wrong.places[17].y = 1e61;
  CHECK_THROWS_AS(rbpa::remesh(wrong.mesh, wrong.places, {.length = 0.1}), rbpa::InvalidInput);
  wrong.places[17].y = 1e39;  // infinite as a float
  CHECK_THROWS_AS(rbpa::remesh(wrong.mesh, wrong.places, {.length = 1e38, .single_precision = true}),
                  rbpa::InvalidInput);
  wrong.places.pop_back();
  CHECK_THROWS_AS(rbpa::remesh(wrong.mesh, wrong.places, {.length = 0.1}), meshops::ContractViolation);

  RemeshedMesh few({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}});
  meshops::request_status(few.mesh);
  RemeshedMesh square({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {}});
  square.mesh.add_face({Vertex(0), Vertex(1), Vertex(2), Vertex(3)});
  CHECK_THROWS_WITH_AS(rbpa::remesh(square.mesh, square.places, {.length = 0.5}), "remesh: face 0 is not a triangle",
                       meshops::ContractViolation);
  // Two triangles over each other become two edges between two vertices when a side collapses.
  RemeshedMesh pillow({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}});
  meshops::request_status(pillow.mesh);
  meshops::collapse(pillow.mesh, pillow.mesh.halfedge_handle(0), meshops::Keep::manifold);
  CHECK_THROWS_AS(rbpa::remesh(pillow.mesh, pillow.places, {.length = 0.5}), meshops::ContractViolation);

  OpenMesh::PolyConnectivity empty;
  std::vector<Point3> none;
  CHECK(rbpa::remesh(empty, none, {.length = 1}).left == 0);
  const std::size_t faces = with.mesh.n_faces();
  CHECK(rbpa::remesh(with.mesh, with.places, {.length = 0.1, .rounds = 0}).left == faces);
}

TEST_CASE("a remeshing that is cancelled changes nothing") {
  const Triangles t = sphere(5);
  for (const int most : {0, 2, 20}) {
    RemeshedMesh with(t);
    const std::vector<Point3> places = with.places;
    int calls = 0;
    CHECK_THROWS_AS(rbpa::remesh(with.mesh, with.places, {.length = 0.02, .go_on = [&] { return ++calls <= most; }}),
                    rbpa::Cancelled);
    CHECK(with.places == places);
    CHECK(meshops::soup_of(with.mesh).corners == meshops::soup_of(RemeshedMesh(t).mesh).corners);
  }
}

TEST_CASE("a mesh with points gets the new points, rounded once where they are floats") {
  using FloatMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
  const Triangles t = sphere(3);
  FloatMesh mesh;
  for (const Point3& p : t.points)
    mesh.add_vertex({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  for (const auto& [a, b, c] : t.corners)
    mesh.add_face(Vertex(static_cast<int>(a)), Vertex(static_cast<int>(b)), Vertex(static_cast<int>(c)));
  std::vector<Point3> places = rbpa::places_of(mesh);
  OpenMesh::PolyConnectivity apart = mesh;
  const Remeshing counts = rbpa::remesh(mesh, {.length = 0.1});
  rbpa::remesh(apart, places, {.length = 0.1, .single_precision = true});
  CHECK(mesh.n_faces() == counts.left);
  CHECK(rbpa::places_of(mesh) == places);
  CHECK(meshops::soup_of(mesh).corners == meshops::soup_of(apart).corners);
  // The result can be remeshed again.
  CHECK(rbpa::remesh(mesh, {.length = 0.4}).left < counts.left / 8);
  check_topology(mesh, meshops::report(apart));
}

TEST_SUITE_END();
