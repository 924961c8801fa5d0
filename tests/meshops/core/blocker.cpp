#include "meshops/core/blocker.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "meshops/core/live.h"
#include "support/meshes.h"

using namespace meshops;
using namespace meshops::test;

TEST_SUITE("blocker") {
  TEST_CASE("every kind has a name and a text of its own, which names the element and its number") {
    std::set<std::string> names, texts;
    const int kinds = static_cast<int>(BlockerKind::no_triangulation) + 1;
    for (int i = 0; i < kinds; ++i) {
      const auto kind = static_cast<BlockerKind>(i);
      names.insert(std::string(name(kind)));
      const std::string text = describe(Blocker(kind, Halfedge(7), 4));
      texts.insert(text);
      CHECK(text.starts_with("halfedge 7 ") == (kind > BlockerKind::none_given));
      CHECK(text.find('#') == std::string::npos);
    }
    CHECK(names.size() == static_cast<std::size_t>(kinds));
    CHECK(texts.size() == static_cast<std::size_t>(kinds));
    CHECK(names.count("") == 0);
  }

  TEST_CASE("a reason is described with its element and its number") {
    CHECK(describe(Blocker(BlockerKind::not_triangle, Face(7))) == "face 7 is not a triangle");
    CHECK(describe(Blocker(BlockerKind::missing, Edge())) == "edge -1 does not exist or is deleted");
    CHECK(describe(Blocker(BlockerKind::wrong_degree, Vertex(2), 4)) == "vertex 2 does not have 4 edges");
    CHECK(describe(Blocker(BlockerKind::curve_length, Halfedge(5), 12)) ==
          "halfedge 5 is on a curve of 12 edges, and the other halfedge on one of another number");
    CHECK(describe(Blocker(BlockerKind::no_status)) ==
          "the mesh needs status to mark what is deleted (request_status() requests every kind)");
    CHECK(name(BlockerKind::double_triangle) == "double triangle");
  }

  TEST_CASE("request_status() requests what is missing, and can be called again") {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    mesh.request_edge_status();
    CHECK_FALSE(has_status(mesh));
    request_status(mesh);
    request_status(mesh);
    CHECK(has_status(mesh));
    mesh.release_edge_status();
    CHECK_FALSE(has_status(mesh));  // it was requested once
  }
}
