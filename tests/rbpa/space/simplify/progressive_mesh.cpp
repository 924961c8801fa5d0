// Progressive meshes: the way back from a decimated mesh, in memory and in bytes.
#include "rbpa/space/simplify/progressive_mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"
#include "rbpa/base/error.h"
#include "space/simplify/triangle_sets.h"
#include "support/data_folder.h"

using namespace rbpa_test;
using rbpa::ProgressiveMesh;

TEST_SUITE_BEGIN("space");

namespace {

using Bytes = std::vector<std::byte>;

meshops::Connectivity linked(const Triangles& t) {
  meshops::PolygonSoup soup;
  soup.points = t.points.size();
  for (const auto& corners : t.corners) soup.add_face(corners);
  meshops::Connectivity mesh;
  meshops::build_mesh(mesh, soup);
  return mesh;
}

ProgressiveMesh progressive(const Triangles& t, bool at_ends, std::size_t faces = 0) {
  return {linked(t), t.points, {.faces = faces}, {.at_ends = at_ends}};
}

/// Returns every record of the mesh, of deleted elements too, and the bits of the places of vertices that are there.
std::vector<std::uint64_t> records(const ProgressiveMesh& of) {
  const meshops::Connectivity& mesh = of.mesh();
  std::vector<std::uint64_t> all;
  const auto add = [&](auto handle) { all.push_back(static_cast<std::uint64_t>(handle.idx())); };
  for (const auto v : mesh.all_vertices()) {
    add(mesh.halfedge_handle(v));
    all.push_back(mesh.status(v).bits());
    if (mesh.status(v).deleted()) continue;
    const Point3& p = of.places()[static_cast<std::size_t>(v.idx())];
    for (const double x : {p.x, p.y, p.z}) all.push_back(std::bit_cast<std::uint64_t>(x));
  }
  for (const auto h : mesh.all_halfedges()) {
    add(mesh.to_vertex_handle(h));
    add(mesh.next_halfedge_handle(h));
    add(mesh.prev_halfedge_handle(h));
    add(mesh.face_handle(h));
    all.push_back(mesh.status(h).bits());
    all.push_back(mesh.status(mesh.edge_handle(h)).bits());
  }
  for (const auto f : mesh.all_faces()) {
    add(mesh.halfedge_handle(f));
    all.push_back(mesh.status(f).bits());
  }
  return all;
}

/// A sphere, a torus, sheets with one and several boundary curves, and several components.
std::vector<Triangles> meshes() {
  std::vector<Triangles> all = {sphere(3), sheet(9, 2)};
  for (const char* name : {"m3_torus.off", "m3_cube_no_bottom.off", "m3_plate_holes.off"})
    all.push_back(read_off(bundled_data() / name));
  Triangles two = sphere(2);
  for (const Point3& p : sphere(2).points) two.points.push_back({p.x + 5, -0.0, p.z});
  for (const auto& [a, b, c] : sphere(2).corners) two.corners.push_back({a + 66, b + 66, c + 66});
  two.points.push_back({9, 9, 9});  // an isolated vertex
  all.push_back(two);
  return all;
}

/// Checks that both have the same bits.
void check_same(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  REQUIRE(a.size() == b.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += std::bit_cast<std::array<std::uint64_t, 3>>(a[i]) != std::bit_cast<std::array<std::uint64_t, 3>>(b[i]);
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("walks up and down restore every record and position, and each number of triangles has one mesh") {
  std::mt19937 random(1);
  for (const Triangles& t : meshes())
    for (const bool at_ends : {false, true}) {
      ProgressiveMesh mesh = progressive(t, at_ends);
      const std::size_t least = mesh.least(), most = mesh.most();
      CHECK((most == t.corners.size() && mesh.faces() == least && least < most / 10 + 20));
      CHECK(meshops::validate(mesh.mesh()).empty());
      const auto coarse = records(mesh);
      mesh.go_to(most);
      CHECK(mesh.triangles() == t.corners);
      check_same(mesh.positions(), t.points);
      // The full mesh is the given one, in every record.
      ProgressiveMesh given(linked(t), t.points, {.faces = most});
      CHECK(records(mesh) == records(given));
      const auto full = records(mesh);
      const meshops::TopologyReport topology = meshops::report(mesh.mesh());
      std::map<std::size_t, std::vector<std::uint64_t>> known;
      const int walks = t.corners.size() < 600 ? 1000 : 30;
      for (int i = 0; i < walks; ++i) {
        const std::size_t wanted = random() % 4 == 0 ? most + random() % 2 : random() % (most + 2);
        mesh.go_to(wanted);
        CHECK((mesh.faces() <= std::max(wanted, least) && mesh.faces() + 2 > std::min(wanted, most)));
        CHECK(mesh.triangles().size() == mesh.faces());
        if (mesh.faces() == most) CHECK(records(mesh) == full);
        if (mesh.faces() == least) CHECK(records(mesh) == coarse);
        if (known.size() < 40 || known.contains(mesh.faces())) {
          const auto [slot, is_new] = known.try_emplace(mesh.faces(), records(mesh));
          if (!is_new) CHECK(slot->second == records(mesh));
          if (is_new) CHECK(meshops::report(mesh.mesh()).betti == topology.betti);
        }
      }
      mesh.go_to(most);
      CHECK(records(mesh) == full);
    }
}

TEST_CASE("what is written and read has the same triangles at every number of them, and writes the same bytes") {
  std::mt19937 random(2);
  for (const Triangles& t : meshes())
    for (const bool at_ends : {false, true}) {
      ProgressiveMesh mesh = progressive(t, at_ends);
      mesh.go_to(random() % mesh.most());
      const auto before = records(mesh);
      const Bytes bytes = mesh.write();
      CHECK(records(mesh) == before);
      ProgressiveMesh again = ProgressiveMesh::read(bytes);
      CHECK((again.least() == mesh.least() && again.most() == mesh.most() && again.faces() == mesh.most()));
      CHECK(again.decimation().collapses == mesh.decimation().collapses);
      CHECK(again.triangles() == t.corners);
      check_same(again.positions(), t.points);
      CHECK(meshops::validate(again.mesh()).empty());
      CHECK(again.write() == bytes);
      for (int i = 0; i < 20; ++i) {
        const std::size_t wanted = i == 0 ? 0 : random() % mesh.most();
        mesh.go_to(wanted);
        again.go_to(wanted);
        CHECK(again.triangles() == mesh.triangles());
        std::vector<Point3> here = mesh.positions(), there = again.positions();
        std::vector<bool> used(here.size(), false);
        for (const auto& corners : mesh.triangles())
          for (const std::uint32_t v : corners) used[v] = true;
        for (std::size_t v = 0; v < used.size(); ++v)
          if (!used[v]) here[v] = there[v] = {};
        check_same(here, there);
      }
      CHECK(again.write() == bytes);
      mesh.go_to(0);
      const std::size_t splits = t.points.size() - meshops::report(mesh.mesh()).vertices;
      CHECK(bytes.size() == 32 + 28 * (t.points.size() - splits) + 16 * mesh.least() + (at_ends ? 45 : 69) * splits);
    }
}

TEST_CASE("meshes that cannot be decimated, and an empty one, are written and read") {
  for (const Triangles& t : {Triangles{}, Triangles{{{1, 2, 3}}, {}}, sphere(0)}) {
    const ProgressiveMesh mesh = progressive(t, true, 8);
    CHECK(mesh.least() == mesh.most());
    const ProgressiveMesh again = ProgressiveMesh::read(mesh.write());
    CHECK(again.triangles() == t.corners);
    check_same(again.positions(), t.points);
  }
}

TEST_CASE("bytes that lie are refused, or make a sound mesh that goes both ways") {
  std::mt19937 random(3);
  const std::string of = "progressive mesh: ";
  for (const Triangles& t : {sphere(1), sheet(3, 5)})
    for (const bool at_ends : {false, true}) {
      const Bytes bytes = progressive(t, at_ends).write();
      for (std::size_t size = 0; size < bytes.size(); ++size)
        CHECK_THROWS_AS(ProgressiveMesh::read(std::span(bytes).first(size)), rbpa::InvalidInput);
      Bytes more = bytes;
      more.push_back({});
      CHECK_THROWS_WITH_AS(ProgressiveMesh::read(more),
                           (of + "found " + std::to_string(more.size()) + " bytes, expected " +
                            std::to_string(bytes.size()) + " by the numbers in the head")
                               .c_str(),
                           rbpa::InvalidInput);
      std::size_t refused = 0, taken = 0;
      for (std::size_t i = 0; i < bytes.size(); ++i)
        for (const unsigned change : {1U, 255U, static_cast<unsigned>(random() % 255 + 1)}) {
          Bytes wrong = bytes;
          wrong[i] ^= static_cast<std::byte>(change);
          try {
            ProgressiveMesh mesh = ProgressiveMesh::read(wrong);
            ++taken;
            CHECK(meshops::validate(mesh.mesh()).empty());
            const auto full = records(mesh);
            mesh.go_to(0);
            CHECK(mesh.faces() == mesh.least());
            CHECK(meshops::validate(mesh.mesh()).empty());
            mesh.go_to(mesh.most());
            CHECK(records(mesh) == full);
          } catch (const rbpa::InvalidInput& why) {
            ++refused;
            CHECK(std::string(why.what()).starts_with(of));
            CHECK(std::string(why.what()).find("build_mesh") == std::string::npos);
          }
        }
      CHECK(refused > bytes.size() / 2);
      CHECK(taken > bytes.size() / 2);  // coordinates may be any finite numbers
    }
}

TEST_CASE("wrong meshes are refused") {
  meshops::Connectivity mesh = linked(sphere(1));
  CHECK_THROWS_AS(ProgressiveMesh(mesh, std::vector<Point3>(3), {}), meshops::ContractViolation);
  meshops::request_status(mesh);
  mesh.delete_face(meshops::Face(2), false);
  CHECK_THROWS_WITH_AS(ProgressiveMesh(mesh, sphere(1).points, {}),
                       "ProgressiveMesh: element 2 is marked deleted, expected none (call garbage_collection() before)",
                       meshops::ContractViolation);
}

TEST_SUITE_END();
