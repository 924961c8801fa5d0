#include "meshops/stellar/split_hooks.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <limits>
#include <stdexcept>

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "stellar/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Mesh with points and links only: OpenMesh's meshes require three coordinates for their normals.
template <typename Vector>
struct PointTraits : OpenMesh::DefaultTraits {
  using Point = Vector;
};
template <typename Vector>
using PointMesh = OpenMesh::AttribKernelT<OpenMesh::FinalMeshItemsT<PointTraits<Vector>, false>, Connectivity>;

using FloatTriangles = OpenMesh::TriMesh_ArrayKernelT<>;
using DoublePolygons = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

static_assert(HasPoints<FloatTriangles> && HasPoints<DoublePolygons> && HasPoints<TestMesh>);
static_assert(HasPoints<PointMesh<OpenMesh::Vec2f>> && HasPoints<PointMesh<OpenMesh::Vec2d>>);
static_assert(!HasPoints<Connectivity> && !HasPoints<PointMesh<OpenMesh::Vec3i>>);

/// The triangle (0, 0), (6, 0), (0, 6).
template <typename Mesh>
void triangle(Mesh& mesh) {
  for (const auto& [x, y] : {std::pair(0, 0), {6, 0}, {0, 6}}) {
    const Vertex v = mesh.new_vertex();
    typename Mesh::Point p;
    p.vectorize(0);
    using Scalar = typename Mesh::Point::value_type;
    p[0] = static_cast<Scalar>(x);
    p[1] = static_cast<Scalar>(y);
    mesh.set_point(v, p);
  }
  Connectivity& links = mesh;
  links.add_face(Vertex(0), Vertex(1), Vertex(2));
}

template <typename Mesh>
std::pair<double, double> place(const Mesh& mesh, Vertex v) {
  return {static_cast<double>(mesh.point(v)[0]), static_cast<double>(mesh.point(v)[1])};
}

/// Every bit of the links, and the numbers of elements; points and the values of a property at each element.
struct Content {
  explicit Content(const TestMesh& mesh) : records(snapshot(mesh)) {
    for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) points.push_back(mesh.point(Vertex(v)));
  }
  std::vector<int> records;
  std::vector<TestMesh::Point> points;
  friend bool operator==(const Content&, const Content&) = default;
};

struct Stop : std::runtime_error {
  Stop() : runtime_error("stop") {}
};

constexpr auto stop = [](auto&, const auto&) { throw Stop(); };

}  // namespace

TEST_SUITE("split hooks") {
  TEST_CASE_TEMPLATE("without a hook a split places the new vertex, on meshes of any points", Mesh, FloatTriangles,
                     DoublePolygons, PointMesh<OpenMesh::Vec2f>, PointMesh<OpenMesh::Vec2d>,
                     PointMesh<OpenMesh::Vec3d>) {
    using Place = std::pair<double, double>;
    Mesh mesh;
    triangle(mesh);
    const Vertex center = split_face(mesh, Face(0)).added.vertex;
    CHECK(place(mesh, center).first == doctest::Approx(2));
    CHECK(place(mesh, center).second == doctest::Approx(2));
    const Halfedge h = mesh.find_halfedge(Vertex(0), Vertex(1));
    CHECK(place(mesh, split_edge(mesh, h).added.vertex) == Place(3, 0));
    CHECK(place(mesh, split_edge(mesh, mesh.edge_handle(h)).added.vertex).first == 1.5);
    const Halfedge inner = mesh.find_halfedge(Vertex(1), Vertex(2));
    CHECK(place(mesh, split_edge(mesh, inner, Keep::manifold).added.vertex) == Place(3, 3));
    const Halfedge left = mesh.halfedge_handle(Vertex(2));
    const Vertex twin = split_vertex(mesh, left, std::nullopt, Keep::manifold).added.vertex;
    CHECK(place(mesh, twin) == Place(0, 6));
  }

  TEST_CASE("the middle of finite points does not overflow") {
    DoublePolygons mesh;
    triangle(mesh);
    const double most = std::numeric_limits<double>::max();
    for (int v = 0; v < 3; ++v) mesh.set_point(Vertex(v), {most, -most, most / 2});
    for (const Vertex v : {split_face(mesh, Face(0)).added.vertex, split_edge(mesh, Halfedge(0)).added.vertex}) {
      CHECK(mesh.point(v)[0] == doctest::Approx(most));
      CHECK(mesh.point(v)[1] == doctest::Approx(-most));
    }
  }

  TEST_CASE("a split of a mesh as Connectivity does not read its points") {
    TestMesh mesh;
    triangle(mesh);
    mesh.set_point(Vertex(0), {1, 1, 1});
    mesh.set_point(Vertex(1), {1, 1, 1});
    mesh.reserve(10, 20, 20);
    mesh.set_point(mesh.new_vertex(), {7, 7, 7});  // content of the memory of the next vertex
    mesh.resize(3, 3, 1);
    Connectivity& links = mesh;
    const Vertex v = split_edge(links, Halfedge(0)).added.vertex;
    CHECK(mesh.point(v) != TestMesh::Point(1, 1, 1));
  }

  TEST_CASE("any callable is a hook, and receives the effect") {
    TestMesh mesh;
    triangle(mesh);
    Vertex added;
    const auto hook = [&](TestMesh& m, const SplitEffect& effect) {
      CHECK(&m == &mesh);
      added = effect.added.vertex;
      m.set_point(added, {1, 2, 3});
    };
    CHECK(split_face(mesh, Face(0), hook).added.vertex == added);
    CHECK(mesh.point(added) == TestMesh::Point(1, 2, 3));
    CHECK(split_edge(mesh, Halfedge(0), hook, Keep::manifold).added.vertex == added);
    CHECK(split_edge(mesh, Edge(1), hook).added.vertex == added);
    CHECK(split_vertex(mesh, Halfedge(0), std::nullopt, hook, Keep::manifold).added.vertex == added);
    check_sound(mesh);
    int calls = 0;
    Connectivity& links = mesh;
    split_edge(links, Halfedge(0), [&](Connectivity&, const SplitEdgeEffect& effect) {
      CHECK(effect.line == Halfedge(0));
      ++calls;
    });
    CHECK(calls == 1);
  }

  TEST_CASE("CarryOver gives the new half, the new faces and the new vertex the old properties") {
    TestMesh mesh;
    triangle(mesh);
    mesh.request_face_colors();
    OpenMesh::EPropHandleT<int> crease;
    OpenMesh::HPropHandleT<int> corner;
    OpenMesh::FPropHandleT<std::string> name;
    OpenMesh::VPropHandleT<int> weight;
    mesh.add_property(crease);
    mesh.add_property(corner);
    mesh.add_property(name);
    mesh.add_property(weight);
    const Halfedge h(0), o(1);
    mesh.property(crease, mesh.edge_handle(h)) = 7;
    mesh.property(corner, h) = 8;
    mesh.property(corner, o) = 9;
    mesh.property(name, Face(0)) = "roof";
    mesh.set_color(Face(0), {1, 2, 3});
    mesh.status(mesh.edge_handle(h)).set_feature(true);

    const SplitEdgeEffect cut = split_edge(mesh, h, CarryOver());
    CHECK(mesh.property(crease, mesh.edge_handle(cut.halfedge)) == 7);
    CHECK(mesh.property(corner, cut.halfedge) == 8);
    CHECK(mesh.property(corner, mesh.opposite_halfedge_handle(cut.halfedge)) == 9);
    CHECK(mesh.status(mesh.edge_handle(cut.halfedge)).feature());
    CHECK(mesh.property(crease, cut.added.edge[1]) == 0);
    CHECK(mesh.property(name, cut.added.face[0]) == "roof");
    CHECK(mesh.point(cut.added.vertex) == TestMesh::Point(3, 0, 0));

    const SplitFaceEffect star = split_face(mesh, Face(0), CarryOver());
    for (const Face f : star.added.faces()) {
      CHECK(mesh.property(name, f) == "roof");
      CHECK(mesh.color(f) == TestMesh::Color(1, 2, 3));
    }

    // Both sides of an inner edge, each with its own face.
    mesh.property(name, star.added.face[0]) = "left";
    mesh.property(name, star.added.face[1]) = "right";
    const SplitEdgeEffect inner = split_edge(mesh, star.halfedge, CarryOver());
    CHECK(mesh.property(name, inner.added.face[0]) == mesh.property(name, mesh.face_handle(inner.line)));
    CHECK(mesh.property(name, inner.added.face[1]) ==
          mesh.property(name, mesh.face_handle(mesh.opposite_halfedge_handle(inner.line))));
    CHECK(mesh.property(name, inner.added.face[0]) != mesh.property(name, inner.added.face[1]));

    // When a vertex opens, both vertices, and both parts of each edge that opens with it, have the old properties.
    const Vertex w = inner.added.vertex;
    mesh.property(weight, w) = 5;
    mesh.set_point(w, {4, 5, 6});
    const Halfedge left = mesh.halfedge_handle(w);
    const Halfedge right = mesh.opposite_halfedge_handle(
        mesh.prev_halfedge_handle(mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(left))));
    for (const Halfedge side : {left, right}) {
      mesh.property(crease, mesh.edge_handle(side)) = 10 + side.idx();
      mesh.property(corner, side) = 100 + side.idx();
      mesh.property(corner, mesh.opposite_halfedge_handle(side)) = 200 + side.idx();
    }
    const SplitVertexEffect twins = split_vertex(mesh, left, right, CarryOver());
    const Vertex v = twins.added.vertex;
    CHECK(mesh.property(weight, v) == 5);
    CHECK(mesh.point(v) == TestMesh::Point(4, 5, 6));
    for (const Halfedge side : {left, right}) {
      const Halfedge twin = mesh.find_halfedge(v, mesh.to_vertex_handle(side));
      CHECK(mesh.property(crease, mesh.edge_handle(twin)) == 10 + side.idx());
      CHECK(mesh.property(corner, twin) == 100 + side.idx());
      CHECK(mesh.property(corner, mesh.opposite_halfedge_handle(twin)) == 200 + side.idx());
    }
    for (const Face f : twins.added.faces()) CHECK(mesh.property(name, f).empty());
    check_sound(mesh);
  }

  TEST_CASE("a hook that throws leaves the mesh as it was, bit for bit, wherever it splits") {
    int thrown = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) mesh.set_point(Vertex(v), {float(v), 0, 1});
      const Content before(mesh);
      const auto try_to = [&](auto split) {
        CHECK_THROWS_AS(split(), Stop);
        CHECK(Content(mesh) == before);
        ++thrown;
      };
      for_each_halfedge(mesh, [&](Halfedge h) {
        if (is_large(mesh) && h.idx() % 61) return;
        if (!split_edge_blocker(mesh, h, keep)) try_to([&] { split_edge(mesh, h, stop, keep); });
        for (const Halfedge right : mesh.voh_range(mesh.from_vertex_handle(h)))
          if (!split_vertex_blocker(mesh, h, right, keep)) try_to([&] { split_vertex(mesh, h, right, stop, keep); });
        for (const bool is_left : {false, true}) {
          const auto left = is_left ? std::optional(h) : std::nullopt,
                     right = is_left ? std::nullopt : std::optional(h);
          if (!split_vertex_blocker(mesh, left, right, keep))
            try_to([&] { split_vertex(mesh, left, right, stop, keep); });
        }
      });
      for_each_face(mesh, [&](Face f) {
        if (is_large(mesh) && f.idx() % 61) return;
        try_to([&] { split_face(mesh, f, stop); });
      });
    });
    CHECK(thrown > 10000);
  }

  TEST_CASE("a hook that throws leaves a mesh without status as it was") {
    FloatTriangles mesh;
    triangle(mesh);
    const auto before = snapshot(mesh);
    CHECK_THROWS_AS(split_edge(mesh, Halfedge(0), stop), Stop);
    CHECK_THROWS_AS(split_face(mesh, Face(0), stop), Stop);
    CHECK(snapshot(mesh) == before);
    CHECK(mesh.n_vertices() == 3);
  }

  TEST_CASE("a hook that adds elements or changes links, and throws, leaves a sound mesh") {
    TestMesh mesh;
    triangle(mesh);
    const auto live = live_snapshot(mesh);
    CHECK_THROWS_AS(split_face(mesh, Face(0),
                               [](TestMesh& m, const SplitEffect&) {
                                 m.set_point(m.new_vertex(), {0, 0, 0});
                                 throw Stop();
                               }),
                    Stop);
    check_sound(mesh);
    CHECK(mesh.status(Vertex(3)).deleted());  // the split is undone, the vertex of the hook exists
    CHECK_FALSE(mesh.status(Vertex(4)).deleted());
    CHECK(counts(mesh).faces == 1);
    mesh.status(Vertex(4)).set_deleted(true);
    CHECK(live_snapshot(mesh) == live);

    TestMesh disc;
    corpus()[3].build(disc);
    for (int f = 0; f < static_cast<int>(disc.n_faces()); ++f) {
      TestMesh copy = disc;
      CHECK_THROWS_AS(split_face(copy, Face(f),
                                 [](TestMesh& m, const SplitFaceEffect& effect) {
                                   const Edge side = m.edge_handle(m.next_halfedge_handle(effect.halfedge));
                                   if (!flip_blocker(m, side)) flip(m, side);
                                   throw Stop();
                                 }),
                      Stop);
      check_sound(copy);
      TestMesh collapsed = disc;
      CHECK_THROWS_AS(split_face(collapsed, Face(f),
                                 [](TestMesh& m, const SplitFaceEffect& effect) {
                                   collapse(m, effect.halfedge);
                                   throw Stop();
                                 }),
                      Stop);
      check_sound(collapsed);
    }
  }
}
