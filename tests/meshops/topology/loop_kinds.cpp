#include "meshops/topology/loop_kinds.h"

#include <doctest/doctest.h>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/polygon_soup.h"
#include "meshops/topology/shortest_loops.h"

using namespace meshops;

namespace {

using Place = std::array<double, 3>;

struct Shape {
  PolygonSoup soup;
  std::vector<Place> places;
};

Place sum(const Place& a, double s, const Place& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
Place product(const Place& u, const Place& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Place unit(const Place& v) {
  const double size = std::hypot(v[0], v[1], v[2]);
  return {v[0] / size, v[1] / size, v[2] / size};
}

/// Returns a tube of squares around a closed curve.
template <typename Curve>
Shape tube(std::uint32_t along, std::uint32_t around, double radius, const Curve& curve) {
  Shape shape;
  for (std::uint32_t i = 0; i < along; ++i) {
    const double t = 2 * std::numbers::pi * i / along;
    const Place direction = unit(sum(curve(t + 1e-5), -1, curve(t - 1e-5)));
    const Place side = unit(product(direction, {0.1, 0.2, 1})), up = product(side, direction);
    for (std::uint32_t j = 0; j < around; ++j) {
      const double a = 2 * std::numbers::pi * j / around;
      shape.places.push_back(sum(sum(curve(t), radius * std::cos(a), side), radius * std::sin(a), up));
    }
  }
  shape.soup.points = along * around;
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t j = 0; j < around; ++j) {
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % along * around + l % around; };
      shape.soup.add_face(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return shape;
}

Shape torus(std::uint32_t along, std::uint32_t around) {
  return tube(along, around, 0.4, [](double t) { return Place{std::cos(t), std::sin(t), 0}; });
}

Shape reversed(const Shape& shape) {
  Shape other{{}, shape.places};
  other.soup.points = shape.soup.points;
  for (std::size_t f = 0; f < shape.soup.faces(); ++f) {
    std::vector<std::uint32_t> face(shape.soup.face(f).rbegin(), shape.soup.face(f).rend());
    other.soup.add_face(face);
  }
  return other;
}

Shape together(const Shape& a, const Shape& b) {
  Shape both = a;
  both.places.insert(both.places.end(), b.places.begin(), b.places.end());
  both.soup.points = both.places.size();
  for (std::size_t f = 0; f < b.soup.faces(); ++f) {
    std::vector<std::uint32_t> face(b.soup.face(f).begin(), b.soup.face(f).end());
    for (std::uint32_t& v : face) v += static_cast<std::uint32_t>(a.places.size());
    both.soup.add_face(face);
  }
  return both;
}

/// Returns the kinds of the loops of the shortest basis, from the shortest on.
std::vector<LoopKind> kinds_of(const Shape& shape, std::vector<std::size_t>* edges = nullptr) {
  OpenMesh::PolyConnectivity mesh;
  const std::vector<std::uint32_t> point_of = build_mesh(mesh, shape.soup);
  std::vector<Place> places;
  for (const std::uint32_t point : point_of) places.push_back(shape.places[point]);
  std::vector<double> lengths(mesh.n_edges());
  for_each_edge(mesh, [&](Edge e) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    const Place d = sum(places[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())], -1,
                        places[static_cast<std::size_t>(mesh.from_vertex_handle(h).idx())]);
    lengths[static_cast<std::size_t>(e.idx())] = std::hypot(d[0], d[1], d[2]);
  });
  const std::vector<Loop> loops = shortest_homology_basis(mesh, lengths);
  if (edges != nullptr)
    for (const Loop& loop : loops) edges->push_back(loop.size());
  return loop_kinds(mesh, places, loops);
}

std::size_t count(const std::vector<LoopKind>& kinds, LoopKind kind) {
  return static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), kind));
}

using Kinds = std::vector<LoopKind>;

}  // namespace

TEST_SUITE("homology") {
  TEST_CASE(
      "a loop around a tube is a handle loop, and one around the hole a tunnel loop, whichever way the torus faces") {
    std::vector<std::size_t> edges;
    CHECK(kinds_of(torus(30, 9), &edges) == Kinds{LoopKind::handle, LoopKind::tunnel});
    CHECK(edges == std::vector<std::size_t>{9, 30});
    CHECK(kinds_of(reversed(torus(30, 9))) == Kinds{LoopKind::handle, LoopKind::tunnel});
    // A short and wide torus, in which the loop around the hole is shorter than the one around the tube.
    const Shape wide = tube(6, 40, 0.85, [](double t) { return Place{std::cos(t), std::sin(t), 0}; });
    CHECK(kinds_of(wide) == Kinds{LoopKind::tunnel, LoopKind::handle});
  }

  TEST_CASE(
      "a loop around the hole of a ring in a chain bounds on neither side, because the next ring is in the hole") {
    const Shape first = tube(30, 9, 0.1, [](double t) { return Place{std::cos(t), std::sin(t), 0}; });
    const Shape second = tube(30, 9, 0.1, [](double t) { return Place{1 + std::cos(t), 0, std::sin(t)}; });
    const Shape apart = tube(30, 9, 0.1, [](double t) { return Place{std::cos(t), std::sin(t), 0.5}; });
    for (const Shape& other : {second, reversed(second)}) {
      const Kinds kinds = kinds_of(together(first, other));  // the meridians are shorter
      CHECK(kinds == Kinds{LoopKind::handle, LoopKind::handle, LoopKind::neither, LoopKind::neither});
    }
    const Kinds beside = kinds_of(together(first, apart));
    CHECK(beside == Kinds{LoopKind::handle, LoopKind::handle, LoopKind::tunnel, LoopKind::tunnel});
  }

  TEST_CASE("a component with a boundary obstructs like a closed one, and its own loops are unknown") {
    const Shape first = tube(30, 9, 0.1, [](double t) { return Place{std::cos(t), std::sin(t), 0}; });
    Shape second = tube(30, 9, 0.1, [](double t) { return Place{1 + std::cos(t), 0, std::sin(t)}; });
    PolygonSoup some;
    some.points = second.soup.points;
    for (std::size_t f = 1; f < second.soup.faces(); ++f) some.add_face(second.soup.face(f));
    second.soup = some;
    const Kinds kinds = kinds_of(together(first, second));
    CHECK(count(kinds, LoopKind::unknown) == 2);
    CHECK(count(kinds, LoopKind::handle) == 1);
    CHECK(count(kinds, LoopKind::neither) == 1);
  }

  TEST_CASE("in a hollow ring each wall obstructs loops of the other, around the tube and along the cavity") {
    const Shape outer = torus(30, 12);
    const Shape inner = reversed(tube(30, 12, 0.2, [](double t) { return Place{std::cos(t), std::sin(t), 0}; }));
    // For the inner wall alone, the inside is the cavity.
    const Kinds kinds = kinds_of(together(outer, inner));
    CHECK(count(kinds, LoopKind::handle) == 1);
    CHECK(count(kinds, LoopKind::tunnel) == 1);
    CHECK(count(kinds, LoopKind::neither) == 2);
  }

  TEST_CASE("the loops of one component have the kinds that it has alone") {
    const Shape first = tube(30, 9, 0.1, [](double t) { return Place{std::cos(t), std::sin(t), 0}; });
    const Shape second = tube(30, 9, 0.1, [](double t) { return Place{1 + std::cos(t), 0, std::sin(t)}; });
    const Shape both = together(first, second);
    OpenMesh::PolyConnectivity mesh;
    build_mesh(mesh, both.soup);
    std::vector<Loop> loops = homology(mesh).generators;
    REQUIRE(loops.size() == 4);
    std::erase_if(loops, [&](const Loop& loop) { return mesh.from_vertex_handle(loop[0]).idx() >= 30 * 9; });
    OpenMesh::PolyConnectivity alone;
    build_mesh(alone, first.soup);
    const Kinds expected = loop_kinds(alone, first.places, homology(alone).generators);
    CHECK(count(expected, LoopKind::unknown) == 0);
    CHECK(loop_kinds(mesh, both.places, loops) == expected);
  }

  TEST_CASE(
      "a loop along a knotted tube bounds outside if it does not wind around the knot, and otherwise on neither side") {
    const auto trefoil = [](double t) {
      return Place{std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
    };
    const Kinds kinds = kinds_of(tube(120, 8, 0.3, trefoil));
    REQUIRE(kinds.size() == 2);
    CHECK(kinds[0] == LoopKind::handle);
    // The shortest loop along the tube follows the knot, whose writhe is 3.
    CHECK(kinds[1] == LoopKind::neither);
  }

  TEST_CASE("loops of open surfaces are unknown, wrong calls are refused, and a long run can be cancelled") {
    Shape open = torus(12, 6);
    PolygonSoup some;
    some.points = open.soup.points;
    for (std::size_t f = 1; f < open.soup.faces(); ++f) some.add_face(open.soup.face(f));
    open.soup = some;
    CHECK(kinds_of(open) == Kinds{LoopKind::unknown, LoopKind::unknown});
    Shape flat = torus(12, 6);
    for (Place& p : flat.places) p[2] = 0;
    CHECK(count(kinds_of(flat), LoopKind::unknown) == 2);

    OpenMesh::PolyConnectivity mesh;
    const Shape shape = torus(200, 60);
    build_mesh(mesh, shape.soup);
    CHECK_THROWS_AS(loop_kinds(mesh, {}, {}), ContractViolation);
    const std::vector<Loop> loops = homology(mesh).generators;
    const Halfedge h = loops[0][0];
    const Loop wrong[] = {{}, {h}, {h, h}, {Halfedge()}, {Halfedge(-7)}, {Halfedge(1 << 28)}, {h, Halfedge(1 << 28)}};
    for (const Loop& loop : wrong) {
      std::vector<Loop> given = loops;
      given.push_back(loop);
      CHECK_THROWS_AS(loop_kinds(mesh, shape.places, given), ContractViolation);
    }
    // A loop of one edge, there and back, is a loop.
    CHECK(loop_kinds(mesh, shape.places, std::vector<Loop>{{h, mesh.opposite_halfedge_handle(h)}}) ==
          Kinds{LoopKind::both});
    CHECK_THROWS_AS(loop_kinds(mesh, shape.places, loops, [] { return false; }), Cancelled);
  }
}
