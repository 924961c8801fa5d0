#include "meshops/simplify/simplify.h"

#include <doctest/doctest.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/stellar/undo.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/report.h"
#include "stellar/laws.h"
#include "support/corpus.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using Label = std::uint32_t;

/// Policy without geometry: vertices have labels, and costs are drawn from the labels of the ends. Places are labels.
struct Labels {
  explicit Labels(std::vector<Label> all, Label range = 1000) : of(std::move(all)), costs_below(range) {}
  std::vector<Label> of;
  Label costs_below;

  Label at(Vertex v) const { return of[static_cast<std::size_t>(v.idx())]; }
  std::array<Label, 2> ends(const Connectivity& mesh, Edge e) const {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    const Label a = at(mesh.from_vertex_handle(h)), b = at(mesh.to_vertex_handle(h));
    return {std::min(a, b), std::max(a, b)};
  }
  double cost(const Connectivity& mesh, Edge e) const {
    const auto [a, b] = ends(mesh, e);
    return ((a + 1) * 2654435761U ^ (b + 7) * 40503U) % costs_below;
  }
  Label place(const Connectivity& mesh, Edge e) const { return ends(mesh, e)[1]; }
  bool allows(const Connectivity&, Edge, Label) const { return true; }
  Label key(const Connectivity&, Vertex v) const { return at(v); }
  void merge(Connectivity&, const WeldEffect& effect, Label place) {
    of[static_cast<std::size_t>(effect.survivor.idx())] = place;
  }
};

std::vector<Label> numbered(const Connectivity& mesh) {
  std::vector<Label> labels(mesh.n_vertices());
  std::iota(labels.begin(), labels.end(), 0U);
  return labels;
}

/// Topology of a mesh, which a simplification keeps.
struct Topology {
  explicit Topology(const Connectivity& mesh) {
    const TopologyReport all = report(mesh);
    components = all.components;
    curves = all.boundary_curves;
    genus = all.genus;
    betti = all.betti;
  }
  std::size_t components, curves;
  std::optional<long> genus;
  BettiNumbers betti;
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// Checks the topology at every tenth collapse.
struct Watch : SimplifyVisitor {
  explicit Watch(const Connectivity& mesh) : before(mesh) {}
  void collapsed(const Connectivity& mesh, const WeldEffect& effect, double) {
    effects.push_back(effect);
    if (effects.size() % 10 == 0) check(mesh);
  }
  void refused(const Connectivity& mesh, Edge e, const Blocker&) {
    ++refusals;
    CHECK(is_live(mesh, e));
  }
  void check(const Connectivity& mesh) const {
    check_sound(mesh);
    CHECK(Topology(mesh) == before);
  }
  Topology before;
  std::vector<WeldEffect> effects;
  std::size_t refusals = 0;
};

/// Returns the triangles of a mesh as labels of their corners, in a form that does not depend on numbers.
std::vector<std::array<Label, 3>> canonical(const Connectivity& mesh, const Labels& labels) {
  std::vector<std::array<Label, 3>> all;
  for (const Face f : live_faces(mesh)) {
    const Halfedge h = mesh.halfedge_handle(f);
    std::array<Label, 3> t = {labels.at(mesh.from_vertex_handle(h)), labels.at(mesh.to_vertex_handle(h)),
                              labels.at(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h)))};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Renumbers the vertices and faces of a mesh at random, and turns the corners of its faces; the labels follow.
void shuffle(const Connectivity& mesh, std::mt19937& random, TestMesh& shuffled, Labels& labels) {
  PolygonSoup soup = soup_of(mesh);
  std::vector<std::uint32_t> number(mesh.n_vertices());
  std::iota(number.begin(), number.end(), 0U);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<std::array<std::uint32_t, 3>> faces(soup.corners.size() / 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) faces[f][k] = number[soup.corners[3 * f + k]];
    std::rotate(faces[f].begin(), faces[f].begin() + random() % 3, faces[f].end());
  }
  std::shuffle(faces.begin(), faces.end(), random);
  for (std::size_t f = 0; f < faces.size(); ++f)
    std::copy(faces[f].begin(), faces[f].end(), soup.corners.begin() + static_cast<std::ptrdiff_t>(3 * f));
  const std::vector<Label> old = labels.of;
  const auto point_of = build_mesh(shuffled, soup);
  labels.of.resize(shuffled.n_vertices());
  std::vector<std::uint32_t> was(number.size());
  for (std::uint32_t v = 0; v < number.size(); ++v) was[number[v]] = v;
  for (std::size_t v = 0; v < labels.of.size(); ++v) labels.of[v] = old[was[point_of[v]]];
}

struct Stop : std::runtime_error {
  Stop() : std::runtime_error("stop") {}
};

/// Behaves as Labels until the call number `turn` of the function `in`, and wrong in that.
struct Careless : Labels {
  enum In {
    cost_nan,
    cost_infinite,
    place_infinite,
    survivor_elsewhere,
    survivor_invalid,
    throws_at_cost,
    throws_at_place,
    throws_at_allows,
    throws_at_key,
    throws_at_merge,
    throws_at_stops,
    adds_vertex,
    count
  };
  Careless(std::vector<Label> all, In what, TestMesh& changed, int call)
      : Labels(std::move(all)), in(what), mesh_to_change(changed), turn(call) {}
  In in;
  TestMesh& mesh_to_change;
  mutable int turn;
  bool now(In what) const { return what == in && --turn < 0; }
  void throw_in(In what) const {
    if (now(what)) throw Stop();
  }

  std::optional<double> cost(const Connectivity& mesh, Edge e) const {
    throw_in(throws_at_cost);
    if (now(cost_nan)) return std::numeric_limits<double>::quiet_NaN();
    if (now(cost_infinite)) return -std::numeric_limits<double>::infinity();
    return Labels::cost(mesh, e);
  }
  std::array<float, 2> place(const Connectivity& mesh, Edge e) const {
    throw_in(throws_at_place);
    if (now(adds_vertex)) mesh_to_change.new_vertex();
    return {1,
            now(place_infinite) ? std::numeric_limits<float>::infinity() : static_cast<float>(Labels::place(mesh, e))};
  }
  bool allows(const Connectivity&, Edge, const std::array<float, 2>&) const {
    throw_in(throws_at_allows);
    return true;
  }
  Vertex survivor(const Connectivity& mesh, Edge e, const std::array<float, 2>&) const {
    if (now(survivor_invalid)) return Vertex(1 << 30);
    const Vertex end = mesh.to_vertex_handle(mesh.halfedge_handle(e, 1));
    return now(survivor_elsewhere) ? Vertex(end.idx() == 0 ? 2 : 0) : end;
  }
  Label key(const Connectivity&, Vertex v) const {
    throw_in(throws_at_key);
    return at(v);
  }
  bool stops(const Connectivity&, Edge, double) const {
    throw_in(throws_at_stops);
    return false;
  }
  void merge(TestMesh&, const WeldEffect&, const std::array<float, 2>&) const { throw_in(throws_at_merge); }
};

}  // namespace

TEST_SUITE("simplify") {
  TEST_CASE("the topology stays at every tenth collapse, every edge left is refused, and undo() leads back") {
    std::size_t collapses = 0, refusals = 0;
    on_every_mesh([&](TestMesh& mesh, Keep keep) {
      if (simplify_blocker(mesh)) return;
      const auto records = snapshot(mesh);
      Labels labels(numbered(mesh), collapses % 3 == 0 ? 1 : 1000);  // sometimes all costs are equal
      Watch watch(mesh);
      const SimplifyResult result = simplify(mesh, labels, {.keep = keep}, watch);
      watch.check(mesh);
      CHECK(result.end == (result.faces == 0 ? SimplifyEnd::faces : SimplifyEnd::exhausted));
      CHECK(result.collapses == watch.effects.size());
      CHECK(result.faces == report(mesh).faces);
      for_each_edge(mesh, [&](Edge e) {
        const Halfedge h = mesh.halfedge_handle(e, 0);
        CHECK((collapse_blocker(mesh, h, keep) || collapse_blocker(mesh, mesh.opposite_halfedge_handle(h), keep)));
      });
      collapses += result.collapses;
      refusals += watch.refusals;
      for (auto effect = watch.effects.rbegin(); effect != watch.effects.rend(); ++effect) undo(mesh, *effect);
      CHECK(snapshot(mesh) == records);
    });
    CHECK(collapses > 2500);
    CHECK(refusals > 5000);
  }

  TEST_CASE("a closed surface ends as a tetrahedron, a disc as a triangle, a torus with seven vertices or a few more") {
    const auto faces_left = [](std::size_t specimen) {
      TestMesh mesh = built(corpus()[specimen]);
      return simplify(mesh, Labels(numbered(mesh))).faces;
    };
    CHECK(faces_left(6) == 4);   // octahedron
    CHECK(faces_left(3) == 1);   // disc
    CHECK(faces_left(7) >= 14);  // torus: Möbius's has 7 vertices and 14 faces
    CHECK(faces_left(7) <= 18);
  }

  TEST_CASE("the result does not depend on the numbers of vertices and faces") {
    std::mt19937 random(60);
    std::size_t collapses = 0;
    for (const Specimen& specimen : corpus()) {
      if (!specimen.simplicial) continue;  // a soup has one edge between two points
      CAPTURE(specimen.name);
      TestMesh mesh;
      specimen.build(mesh);
      for (const Label costs_below : {1U, 5U, 100000U}) {
        const std::size_t limit = costs_below == 5 ? mesh.n_faces() / 3 : 0;
        TestMesh one, other;
        Labels of_one(numbered(mesh), costs_below), of_other = of_one;
        shuffle(mesh, random, one, of_one);
        shuffle(mesh, random, other, of_other);
        REQUIRE(canonical(one, of_one) == canonical(other, of_other));
        collapses += simplify(one, of_one, {.faces = limit}).collapses;
        simplify(other, of_other, {.faces = limit});
        CHECK(canonical(one, of_one) == canonical(other, of_other));
      }
    }
    CHECK(collapses > 2500);
  }

  TEST_CASE("the run ends at the number of faces, at the cost, when the policy stops it, or when nothing is left") {
    TestMesh mesh = built(corpus()[12]);
    const std::size_t all = mesh.n_faces();
    Labels labels(numbered(mesh));
    const SimplifyResult none = simplify(mesh, labels, {.faces = all});
    CHECK((none.end == SimplifyEnd::faces && none.collapses == 0 && !none.cost && none.faces == all));
    const SimplifyResult cheap = simplify(mesh, labels, {.cost = 10.0});
    CHECK(cheap.end == SimplifyEnd::cost);
    CHECK(cheap.collapses > 0);
    CHECK(*cheap.cost <= 10);
    for (const std::size_t faces : {600U, 599U, 301U}) {
      const SimplifyResult result = simplify(mesh, labels, {.faces = faces});
      CHECK(result.end == SimplifyEnd::faces);
      CHECK((result.faces == faces || result.faces + 1 == faces));
    }
    struct UntilEnough : Labels {
      using Labels::Labels;
      int left = 5;
      bool stops(const Connectivity&, Edge, double) { return left-- == 0; }
    } enough(labels.of);
    CHECK(simplify(mesh, enough).end == SimplifyEnd::policy);
    CHECK(enough.left == -1);
    const auto records = snapshot(mesh);
    CHECK_THROWS_AS(simplify(mesh, labels, {.cost = std::numeric_limits<double>::quiet_NaN()}), ContractViolation);
    CHECK(snapshot(mesh) == records);
    CHECK(simplify(mesh, labels).end == SimplifyEnd::exhausted);
    check_sound(mesh);
  }

  TEST_CASE("progress is called, and false ends the run with a sound mesh") {
    TestMesh mesh = built(corpus()[11]);
    int calls = 0;
    const auto go_on = [&] { return ++calls < 2; };
    CHECK_THROWS_AS(simplify(mesh, Labels(numbered(mesh)), {.go_on = go_on}), Cancelled);
    CHECK(calls == 2);
    check_sound(mesh);
    CHECK(report(mesh).boundary_curves == 31);
  }

  TEST_CASE("the events name for every vertex the one that it went into, and the vertices left are those of no event") {
    TestMesh mesh = built(corpus()[12]);
    Watch watch(mesh);
    Labels labels(numbered(mesh));
    simplify(mesh, labels, {.faces = 100}, watch);
    std::vector<int> into(mesh.n_vertices(), -1);
    for (const WeldEffect& effect : watch.effects) {
      CHECK(into[static_cast<std::size_t>(effect.removed.vertex.idx())] == -1);
      CHECK(into[static_cast<std::size_t>(effect.survivor.idx())] == -1);
      into[static_cast<std::size_t>(effect.removed.vertex.idx())] = effect.survivor.idx();
    }
    for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v)
      CHECK((into[static_cast<std::size_t>(v)] == -1) == is_live(mesh, Vertex(v)));
  }

  TEST_CASE("with costs that grow, computing them late leaves the same mesh") {
    // The weight of a vertex is the sum of what went into it; the powers of two make all sums and costs different.
    struct Weights : Labels {
      Weights(std::vector<Label> all, bool late) : Labels(std::move(all)), costs_grow(late) {
        for (const Label label : of) weight.push_back(1 + label * 0.001 + 1e-7 * (label * 7919 % 1009));
      }
      std::vector<double> weight;
      bool costs_grow;
      mutable int costs = 0;
      double cost(const Connectivity& mesh, Edge e) const {
        ++costs;
        const Halfedge h = mesh.halfedge_handle(e, 0);
        const auto at = [&](Vertex v) { return weight[static_cast<std::size_t>(v.idx())]; };
        const double a = at(mesh.from_vertex_handle(h)), b = at(mesh.to_vertex_handle(h));
        return (a + b) * (a + b) + a * b;
      }
      void merge(Connectivity& mesh, const WeldEffect& effect, Label place) {
        Labels::merge(mesh, effect, place);
        weight[static_cast<std::size_t>(effect.survivor.idx())] +=
            weight[static_cast<std::size_t>(effect.removed.vertex.idx())];
      }
    };
    for (const std::size_t specimen : {7U, 8U, 11U, 12U}) {
      TestMesh late, early;
      corpus()[specimen].build(late);
      corpus()[specimen].build(early);
      Weights lazily(numbered(late), true), eagerly(numbered(early), false);
      simplify(late, lazily, {.faces = late.n_faces() / 4});
      simplify(early, eagerly, {.faces = early.n_faces() / 4});
      CHECK(canonical(late, lazily) == canonical(early, eagerly));
      CHECK(lazily.costs < eagerly.costs);
    }
  }

  TEST_CASE("an edge that is not allowed is tried again when a vertex near it was merged") {
    // Allowed is only an edge of which an end has four edges or fewer; at first there are few.
    struct FewEdges : Labels {
      using Labels::Labels;
      bool allows(const Connectivity& mesh, Edge e, Label) const {
        const Halfedge h = mesh.halfedge_handle(e, 0);
        return std::min(mesh.valence(mesh.from_vertex_handle(h)), mesh.valence(mesh.to_vertex_handle(h))) <= 4;
      }
    };
    TestMesh mesh = built(corpus()[3]);
    FewEdges policy(numbered(mesh));
    const SimplifyResult result = simplify(mesh, policy);
    CHECK(result.end == SimplifyEnd::exhausted);
    for_each_edge(mesh, [&](Edge e) {
      CHECK((collapse_blocker(mesh, mesh.halfedge_handle(e, 0)) || !policy.allows(mesh, e, 0)));
    });
    CHECK(result.faces < 10);
  }

  TEST_CASE("a point is the place by default, also of float meshes, and points that overflow are refused") {
    struct Middle {
      float times = 1;
      double cost(const TestMesh& mesh, Edge e) const { return mesh.calc_edge_length(e); }
      TestMesh::Point place(const TestMesh& mesh, Edge e) const { return mesh.calc_edge_midpoint(e) * times; }
      bool allows(const TestMesh&, Edge, const TestMesh::Point&) const { return true; }
      std::array<float, 3> key(const TestMesh& mesh, Vertex v) const {
        return {mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]};
      }
    };
    TestMesh mesh = built(corpus()[7]);
    for_each_vertex(mesh, [&](Vertex v) { mesh.set_point(v, {1.0F + float(v.idx()), float(v.idx() % 4), 1}); });
    const auto records = snapshot(mesh);
    Middle policy{std::numeric_limits<float>::infinity()};
    CHECK_THROWS_AS(simplify(mesh, policy), ContractViolation);
    CHECK(snapshot(mesh) == records);
    policy.times = 1;
    Watch watch(mesh);
    simplify(mesh, policy, {}, watch);
    REQUIRE(watch.effects.size() > 3);
    CHECK(mesh.point(watch.effects.back().survivor)[2] == 1);
  }

  TEST_CASE("careless policies are refused or thrown through, with the mesh as after the last whole collapse") {
    int thrown = 0, violated = 0;
    for (const std::size_t specimen : {6U, 7U, 8U, 11U})
      for (int in = 0; in < Careless::count; ++in)
        for (const int turn : {0, 1, 17, 60}) {
          CAPTURE(in);
          CAPTURE(turn);
          TestMesh mesh = built(corpus()[specimen]);
          const auto records = snapshot(mesh);
          const std::size_t vertices = mesh.n_vertices();
          Careless policy(numbered(mesh), static_cast<Careless::In>(in), mesh, turn);
          Watch watch(mesh);
          bool wrong = true;
          try {
            simplify(mesh, policy, {}, watch);
            wrong = false;
          } catch (const Stop&) {
            ++thrown;
          } catch (const ContractViolation& violation) {
            ++violated;
            CHECK(std::string(violation.what()).starts_with("simplify: the policy"));
          }
          if (turn == 0) CHECK(wrong);
          mesh.resize(vertices, mesh.n_edges(), mesh.n_faces());  // without the vertex that the policy added
          watch.check(mesh);
          for (auto effect = watch.effects.rbegin(); effect != watch.effects.rend(); ++effect) undo(mesh, *effect);
          CHECK(snapshot(mesh) == records);
          if (turn == 0) CHECK(watch.effects.empty());
        }
    CHECK(thrown > 50);
    CHECK(violated > 50);
  }

  TEST_CASE("a visitor that throws ends the run, with the mesh as after the last collapse") {
    struct Impatient : Watch {
      using Watch::Watch;
      void collapsed(const Connectivity& mesh, const WeldEffect& effect, double cost) {
        Watch::collapsed(mesh, effect, cost);
        if (effects.size() == 3) throw Stop();
      }
    };
    TestMesh mesh = built(corpus()[12]);
    Impatient visitor(mesh);
    CHECK_THROWS_AS(simplify(mesh, Labels(numbered(mesh)), {}, visitor), Stop);
    CHECK(visitor.effects.size() == 3);
    visitor.check(mesh);
  }

  TEST_CASE("meshes with polygons or without status are refused with the reason, and not touched") {
    TestMesh polygons;
    corpus()[3].build(polygons);
    std::vector<Vertex> corners;
    for (int i = 0; i < 4; ++i) corners.push_back(polygons.new_vertex());
    const Face square = polygons.add_face(corners);
    const auto records = snapshot(polygons);
    CHECK(simplify_blocker(polygons) == Blocker(BlockerKind::not_triangle, square));
    CHECK_THROWS_WITH_AS(simplify(polygons, Labels(numbered(polygons))), "simplify: face 40 is not a triangle",
                         ContractViolation);
    CHECK(snapshot(polygons) == records);
    OpenMesh::TriMesh_ArrayKernelT<> without;
    separate_triangles(without, 2);
    CHECK(simplify_blocker(without) == Blocker(BlockerKind::no_status));
    TestMesh empty;
    CHECK(simplify(empty, Labels({})).end == SimplifyEnd::faces);
  }
}
