#include "meshops/stellar/triangulate_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "meshops/front/boundary_curve.h"
#include "meshops/handle/close_curve.h"
#include "meshops/stellar/diagonal.h"
#include "meshops/topology/build_mesh.h"
#include "stellar/laws.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/laws.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Triangle = std::array<int, 3>;  // corners of the polygon, ascending
using Triangulation = std::vector<Triangle>;

/// Returns all triangulations of the part between two corners, a Catalan number; at the side between them, the first
/// apex comes first.
std::vector<Triangulation> all_triangulations(int first, int last) {
  if (last - first < 2) return {{}};
  std::vector<Triangulation> all;
  for (int apex = first + 1; apex < last; ++apex)
    for (const Triangulation& before : all_triangulations(first, apex))
      for (const Triangulation& after : all_triangulations(apex, last)) {
        all.push_back({{first, apex, last}});
        all.back().insert(all.back().end(), before.begin(), before.end());
        all.back().insert(all.back().end(), after.begin(), after.end());
      }
  return all;
}

std::vector<Vertex> corners_of(const TestMesh& mesh, Face f) {
  std::vector<Vertex> corners;
  const Halfedge first = mesh.halfedge_handle(f);
  Halfedge h = first;
  do {
    corners.push_back(mesh.from_vertex_handle(h));
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return corners;
}

/// Returns whether a triangulation is allowed: no edge is a loop; for a simplicial mesh, no edge joins vertices that
/// are joined already.
bool is_allowed(const TestMesh& mesh, const std::vector<Vertex>& corners, const Triangulation& t, Keep keep) {
  const int k = static_cast<int>(corners.size());
  for (const Triangle& triangle : t)
    for (const auto& [i, j] :
         {std::pair(triangle[0], triangle[1]), {triangle[1], triangle[2]}, {triangle[0], triangle[2]}}) {
      const Vertex a = corners[static_cast<std::size_t>(i)], b = corners[static_cast<std::size_t>(j)];
      if (j == i + 1 || (i == 0 && j == k - 1)) continue;
      if (a == b || (keep == Keep::simplicial && mesh.find_halfedge(a, b).is_valid())) return false;
    }
  return true;
}

/// Returns the triangles that a polygon has become, by the numbers of its corners.
std::set<Triangle> triangles_of(const TestMesh& mesh, const std::vector<Vertex>& corners, Face face,
                                const TriangulateFaceEffect& effect) {
  std::set<Triangle> all;
  std::vector<Face> faces = effect.faces;
  faces.push_back(face);
  for (const Face f : faces) {
    const auto of_face = corners_of(mesh, f);
    REQUIRE(of_face.size() == 3);
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i)
      t[i] = static_cast<int>(std::find(corners.begin(), corners.end(), of_face[i]) - corners.begin());
    std::sort(t.begin(), t.end());
    all.insert(t);
  }
  return all;
}

/// Makes a torus of seven vertices, each joined to every other, in which a hexagon replaces the faces of one vertex.
Face hexagon_in_torus(TestMesh& mesh) {
  PolygonSoup torus;
  torus.points = 7;
  for (std::uint32_t i = 0; i < 7; ++i) {
    torus.add_face(std::array{i, (i + 1) % 7, (i + 3) % 7});
    torus.add_face(std::array{i, (i + 3) % 7, (i + 2) % 7});
  }
  build_mesh(mesh, torus);
  Halfedge hub = mesh.halfedge_handle(Vertex(0));
  while (mesh.valence(Vertex(0)) > 1) {
    remove_diagonal(mesh, hub);
    hub = mesh.halfedge_handle(Vertex(0));
  }
  // The last spoke has the face on both sides; the vertex is removed with it by hand.
  const Halfedge spoke = mesh.opposite_halfedge_handle(hub);
  const Face face = mesh.face_handle(spoke);
  mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(spoke), mesh.next_halfedge_handle(hub));
  mesh.set_halfedge_handle(face, mesh.next_halfedge_handle(hub));
  const Vertex end = mesh.to_vertex_handle(hub);
  mesh.set_halfedge_handle(end, mesh.next_halfedge_handle(hub));
  mesh.status(mesh.edge_handle(hub)).set_deleted(true);
  mesh.status(Vertex(0)).set_deleted(true);
  return face;
}

/// Makes a polygon of k sides whose other side is open, or a face that is cut by some diagonals; or a hexagon whose
/// corners are all joined, except by some removed edges.
Face polygon(TestMesh& mesh, int k, std::mt19937& random) {
  if (k == 6) {
    const Face face = hexagon_in_torus(mesh);
    for (auto tries = random() % 8; tries > 0; --tries) {
      const Halfedge h(static_cast<int>(random() % mesh.n_halfedges()));
      const Face sides[] = {mesh.face_handle(h), mesh.face_handle(mesh.opposite_halfedge_handle(h))};
      if (sides[0] != face && sides[1] != face && !remove_diagonal_blocker(mesh, h)) remove_diagonal(mesh, h);
    }
    return face;
  }
  std::vector<Vertex> corners;
  for (int i = 0; i < k; ++i) corners.push_back(mesh.new_vertex());
  const Face f = static_cast<Connectivity&>(mesh).add_face(corners);
  mesh.set_halfedge_handle(f, mesh.next_halfedge_handle(mesh.halfedge_handle(f)));
  if (random() % 3 == 0) return f;
  close_curve(mesh, mesh.opposite_halfedge_handle(mesh.halfedge_handle(f)));
  for (auto tries = random() % 12; tries > 0; --tries) {
    const Halfedge from(static_cast<int>(random() % mesh.n_halfedges()));
    Halfedge to = from;
    for (auto steps = 2 + random() % 5; steps > 0; --steps) to = mesh.next_halfedge_handle(to);
    if (mesh.face_handle(from) != f && !insert_diagonal_blocker(mesh, from, to)) insert_diagonal(mesh, from, to);
  }
  return f;
}

/// Weight that makes the worst triangle as good as possible.
struct Worst {
  int value;
  friend Worst operator+(Worst a, Worst b) { return {std::max(a.value, b.value)}; }
  friend bool operator<(Worst a, Worst b) { return a.value < b.value; }
};

}  // namespace

TEST_SUITE("triangulate_face") {
  TEST_CASE("the first of the triangulations of least weight is chosen, and forbidden diagonals are not drawn") {
    std::mt19937 random(1980);
    int done = 0, blocked = 0, forbidden = 0;
    for (int round = 0; round < rbpa_test::trials(4000); ++round) {
      const int k = 3 + round % 6;
      TestMesh mesh;
      const Face f = polygon(mesh, k, random);
      check_sound(mesh);
      const std::vector<Vertex> corners = corners_of(mesh, f);
      const Keep keep = random() % 2 ? Keep::simplicial : Keep::manifold;
      const int range = random() % 2 ? 3 : 1000;  // in a small range weights are often equal
      std::vector<int> weights(512);
      for (int& w : weights) w = static_cast<int>(random()) % range;
      const auto number = [&](Vertex v) {
        return static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
      };
      const auto weight = [&](Vertex a, Vertex b, Vertex c) {
        CHECK((number(a) < number(b) && number(b) < number(c)));
        return weights[static_cast<std::size_t>(64 * number(a) + 8 * number(b) + number(c))];
      };
      // The first triangulation of least weight.
      std::optional<int> least;
      std::set<Triangle> expected;
      for (const Triangulation& t : all_triangulations(0, k - 1)) {
        if (!is_allowed(mesh, corners, t, keep)) {
          ++forbidden;
          continue;
        }
        int sum = 0;
        for (const auto& [i, m, j] : t) sum += weights[static_cast<std::size_t>(64 * i + 8 * m + j)];
        if (least && sum >= *least) continue;
        least = sum;
        expected = {t.begin(), t.end()};
      }
      CAPTURE(k);
      CHECK(triangulate_face_blocker(mesh, f, keep).has_value() == !least.has_value());
      if (!least) {
        CHECK(refuses(mesh, triangulate_face_blocker(mesh, f, keep), [&] { triangulate_face(mesh, f, weight, keep); }));
        ++blocked;
        continue;
      }
      const auto before = live_snapshot(mesh);
      const Delta had = counts(mesh);
      const bool was_simplicial = is_simplicial(mesh);
      const TriangulateFaceEffect effect = triangulate_face(mesh, f, weight, keep);
      check_sound(mesh);
      CHECK(effect.diagonals.size() == static_cast<std::size_t>(k - 3));
      CHECK(counts(mesh) == had + effect.delta());
      if (was_simplicial && keep == Keep::simplicial) CHECK(is_simplicial(mesh));
      CHECK(triangles_of(mesh, corners, f, effect) == expected);
      for (std::size_t i = effect.diagonals.size(); i-- > 0;) {
        CHECK(mesh.face_handle(effect.diagonals[i]) == effect.faces[i]);
        remove_diagonal(mesh, effect.diagonals[i]);
      }
      CHECK(live_snapshot(mesh) == before);
      ++done;
    }
    CHECK(done > rbpa_test::trials(1000));
    CHECK(blocked > rbpa_test::trials(200));
    CHECK(forbidden > 1000);
  }

  TEST_CASE("with a maximum as sum the worst triangle is as good as possible") {
    std::mt19937 random(7);
    for (int round = 0; round < rbpa_test::trials(300); ++round) {
      const int k = 4 + static_cast<int>(random() % 5);
      TestMesh mesh;
      Connectivity& links = mesh;
      std::vector<Vertex> corners;
      for (int i = 0; i < k; ++i) corners.push_back(mesh.new_vertex());
      const Face f = links.add_face(corners);
      corners = corners_of(mesh, f);
      std::vector<int> weights(512);
      for (int& w : weights) w = static_cast<int>(random() % 100);
      const auto of = [&](int i, int m, int j) { return weights[static_cast<std::size_t>(64 * i + 8 * m + j)]; };
      int best = 1000;
      for (const Triangulation& t : all_triangulations(0, k - 1)) {
        int worst = 0;
        for (const auto& [i, m, j] : t) worst = std::max(worst, of(i, m, j));
        best = std::min(best, worst);
      }
      const auto number = [&](Vertex v) {
        return static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
      };
      const auto effect = triangulate_face(
          mesh, f, [&](Vertex a, Vertex b, Vertex c) { return Worst{of(number(a), number(b), number(c))}; });
      int worst = 0;
      for (const auto& [i, m, j] : triangles_of(mesh, corners, f, effect)) worst = std::max(worst, of(i, m, j));
      CHECK(worst == best);
    }
  }

  TEST_CASE("by area any polygon in the plane is filled without overlaps") {
    using Mesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
    std::mt19937 random(2);
    for (int round = 0; round < rbpa_test::trials(200); ++round) {
      // A star around the origin: simple, and seldom convex.
      const int k = 4 + static_cast<int>(random() % 20);
      Mesh mesh;
      std::vector<Vertex> corners;
      double area = 0;
      std::vector<std::array<double, 2>> at;
      for (int i = 0; i < k; ++i) {
        const double radius = 1 + static_cast<double>(random() % 1000) / 200, angle = 6.283185307179586 * i / k;
        at.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        corners.push_back(mesh.add_vertex({at.back()[0], at.back()[1], 3}));
      }
      for (std::size_t i = 0; i < at.size(); ++i) {
        const auto& p = at[i];
        const auto& q = at[(i + 1) % at.size()];
        area += (p[0] * q[1] - p[1] * q[0]) / 2;
      }
      const Face f = mesh.add_face(corners);
      triangulate_face(mesh, f);
      check_sound(mesh);
      const TriangleArea triangle_area(mesh);
      double sum = 0;
      for (const Face t : mesh.faces()) {
        std::vector<Vertex> v;
        for (const Vertex corner : mesh.fv_range(t)) v.push_back(corner);
        REQUIRE(v.size() == 3);
        sum += triangle_area(v[0], v[1], v[2]);
      }
      CHECK(sum == doctest::Approx(area));
    }
  }

  TEST_CASE("every hole of the corpus is closed with triangles, or is reported and stays") {
    int closed = 0;
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v)
        mesh.set_point(Vertex(v), {float(v % 7), float(v % 11), float(v % 5)});
      for (const BoundaryCurve& curve : boundary_curves(mesh)) {
        if (close_curve_blocker(mesh, curve.front()) || curve.length() > 60) continue;
        const Face f = close_curve(mesh, curve.front()).face;
        if (refuses(mesh, triangulate_face_blocker(mesh, f), [&] { triangulate_face(mesh, f); })) continue;
        triangulate_face(mesh, f);
        check_sound(mesh);
        CHECK(mesh.valence(f) == 3);
        ++closed;
      }
    });
    CHECK(closed > 30);
  }

  TEST_CASE("a triangle stays, a weight that throws changes nothing, and every reason is reported") {
    TestMesh mesh;
    Connectivity& links = mesh;
    std::vector<Vertex> corners;
    for (int i = 0; i < 5; ++i) corners.push_back(mesh.new_vertex());
    const Face f = links.add_face(corners);
    const auto before = snapshot(mesh);
    int calls = 0;
    const auto stop = [&](Vertex, Vertex, Vertex) -> int {
      if (++calls > 3) throw std::runtime_error("enough");
      return 1;
    };
    CHECK_THROWS_AS(triangulate_face(mesh, f, stop), std::runtime_error);
    CHECK(snapshot(mesh) == before);
    CHECK(triangulate_face_blocker(mesh, Face(9))->kind == BlockerKind::missing);
    const auto any = [](Vertex, Vertex, Vertex) { return 0; };
    check_refused(mesh, "triangulate_face: face -1 does not exist or is deleted",
                  [&] { triangulate_face(mesh, Face(-1), any); });
    CHECK(triangulate_face(mesh, f, any).faces.size() == 2);
    const auto then = snapshot(mesh);
    CHECK(triangulate_face(mesh, f, any).diagonals.empty());
    CHECK(snapshot(mesh) == then);

    TestMesh torus;
    const Face hexagon = hexagon_in_torus(torus);
    check_refused(torus, "has no triangulation: every one has an edge that is not allowed",
                  [&] { triangulate_face(torus, hexagon, any); });
    triangulate_face(torus, hexagon, any, Keep::manifold);
    check_sound(torus);
  }

  TEST_CASE("a face that passes a vertex twice requires Keep::manifold, and no triangle has a vertex twice") {
    std::mt19937 random(5);
    int drawn = 0;
    for (unsigned number = 0; number < 400; ++number) {
      TestMesh mesh;
      random_tiny_mesh(mesh, number);
      for (auto tries = mesh.n_edges(); tries > 0; --tries) {
        const Halfedge h(static_cast<int>(random() % mesh.n_halfedges()));
        if (!remove_diagonal_blocker(mesh, h)) remove_diagonal(mesh, h);
      }
      for_each_face(mesh, [&](Face f) {
        const std::vector<Vertex> corners = corners_of(mesh, f);
        if (std::set<Vertex>(corners.begin(), corners.end()).size() == corners.size() || corners.size() > 9) return;
        CHECK(triangulate_face_blocker(mesh, f)->kind == BlockerKind::corner_repeated);
        bool can = false;
        for (const Triangulation& t : all_triangulations(0, static_cast<int>(corners.size()) - 1))
          can = can || is_allowed(mesh, corners, t, Keep::manifold);
        CHECK(triangulate_face_blocker(mesh, f, Keep::manifold).has_value() == !can);
        if (!can) return;
        TestMesh copy = mesh;
        triangulate_face(
            copy, f,
            [](Vertex a, Vertex b, Vertex c) {
              CHECK((a != b && b != c && a != c));
              return 1;
            },
            Keep::manifold);
        check_sound(copy);
        ++drawn;
      });
    }
    CHECK(drawn > 50);
  }
}
