#include "meshops/topology/homology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "graph/support.h"
#include "meshops/core/contract.h"
#include "meshops/front/boundary_curve.h"
#include "support/arguments.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Merges classes of numbers.
struct Classes {
  explicit Classes(std::size_t size) : parent(size) { std::iota(parent.begin(), parent.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void merge(std::size_t a, std::size_t b) { parent[find(a)] = find(b); }
  std::vector<std::size_t> parent;
};

/// Vectors over the integers modulo a prime. add() returns whether the vector is independent of those before.
class Independence {
 public:
  explicit Independence(long prime) : prime_(prime) {}

  bool add(std::vector<long> row) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (row[column] == 0) continue;
      row[column] = ((row[column] % prime_) + prime_) % prime_;
      if (row[column] == 0) continue;
      const auto known = rows_.find(column);
      if (known == rows_.end()) {
        const long factor = inverse(row[column]);
        for (std::size_t i = column; i < row.size(); ++i) row[i] = row[i] % prime_ * factor % prime_;
        rows_.emplace(column, std::move(row));
        return true;
      }
      const long factor = row[column];
      for (std::size_t i = column; i < row.size(); ++i)
        if (known->second[i] != 0) row[i] = (row[i] - factor * known->second[i]) % prime_;
    }
    return false;
  }
  std::size_t rank() const { return rows_.size(); }

 private:
  long inverse(long value) const {
    long result = 1;
    for (long power = prime_ - 2; power > 0; power /= 2, value = value * value % prime_)
      if (power % 2) result = result * value % prime_;
    return result;
  }

  long prime_;
  std::map<std::size_t, std::vector<long>> rows_;  // by the first column that is not 0, whose entry is 1
};

/// Returns the chain of a walk: how often it runs along each edge in the direction of the first halfedge.
std::vector<long> chain(const Connectivity& mesh, const std::vector<Halfedge>& walk) {
  std::vector<long> row(mesh.n_edges(), 0);
  for (const Halfedge h : walk) row[index(mesh.edge_handle(h))] += h.idx() % 2 ? -1 : 1;
  return row;
}

std::vector<Halfedge> sides(const Connectivity& mesh, Face f) {
  std::vector<Halfedge> around;
  for (const Halfedge h : mesh.fh_range(f)) around.push_back(h);
  return around;
}

bool is_closed(const Connectivity& mesh, const Loop& loop) {
  if (loop.empty()) return false;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!is_live(mesh, loop[i]) ||
        mesh.to_vertex_handle(loop[i]) != mesh.from_vertex_handle(loop[(i + 1) % loop.size()]))
      return false;
  return true;
}

/// Returns whether closed walks are a basis of the cycles modulo the boundaries of faces, over Z/p for each of the
/// primes. The dimension of that space is found by ranks alone.
bool is_basis(const Connectivity& mesh, const std::vector<Loop>& loops, std::initializer_list<long> primes) {
  for (const Loop& loop : loops)
    if (!is_closed(mesh, loop)) return false;
  for (const long prime : primes) {
    Independence ends(prime), boundaries(prime);
    std::size_t edges = 0;
    for_each_edge(mesh, [&](Edge e) {
      ++edges;
      std::vector<long> row(mesh.n_vertices(), 0);
      ++row[index(mesh.to_vertex_handle(mesh.halfedge_handle(e, 0)))];
      --row[index(mesh.to_vertex_handle(mesh.halfedge_handle(e, 1)))];
      ends.add(std::move(row));
    });
    for_each_face(mesh, [&](Face f) { boundaries.add(chain(mesh, sides(mesh, f))); });
    if (loops.size() != edges - ends.rank() - boundaries.rank()) return false;
    for (const Loop& loop : loops)
      if (!boundaries.add(chain(mesh, loop))) return false;
  }
  return true;
}

/// Returns the component of each vertex, computed independently of the library.
Classes components(const Connectivity& mesh) {
  Classes component(mesh.n_vertices());
  for_each_halfedge(
      mesh, [&](Halfedge h) { component.merge(index(mesh.from_vertex_handle(h)), index(mesh.to_vertex_handle(h))); });
  return component;
}

struct Counts {
  long vertices = 0, edges = 0, faces = 0, curves = 0, loops = 0;
  long euler() const { return vertices - edges + faces; }
  /// Returns 2g + max(k − 1, 0), where χ = 2 − 2g − k.
  long first_betti() const { return 2 - euler() - curves + std::max(curves - 1, 0L); }
};

std::map<std::size_t, Counts> counts_by_component(const Connectivity& mesh, const Homology& found) {
  Classes component = components(mesh);
  std::map<std::size_t, Counts> counts;
  const auto of = [&](Halfedge h) -> Counts& { return counts[component.find(index(mesh.to_vertex_handle(h)))]; };
  for_each_vertex(mesh, [&](Vertex v) { ++counts[component.find(index(v))].vertices; });
  for_each_edge(mesh, [&](Edge e) { ++of(mesh.halfedge_handle(e, 0)).edges; });
  for_each_face(mesh, [&](Face f) { ++of(mesh.halfedge_handle(f)).faces; });
  for (const BoundaryCurve& curve : boundary_curves(mesh)) ++of(curve.front()).curves;
  for (const Loop& loop : found.generators) ++of(loop.front()).loops;
  return counts;
}

/// Returns whether, cut along these edges, every component is one piece with V − E + F = 1, or was a sphere and is not
/// cut. The pieces are counted directly: corners of faces are one vertex if they are joined across an edge that is not
/// cut.
bool cuts_into_discs(const Connectivity& mesh, const std::vector<Edge>& cut) {
  std::set<Edge> is_cut(cut.begin(), cut.end());
  if (is_cut.size() != cut.size()) return false;
  for (const Edge e : cut)
    if (!is_live(mesh, e) || mesh.is_boundary(e)) return false;
  // The corner of a halfedge that has a face is at its end.
  Classes corner(mesh.n_halfedges()), piece(mesh.n_faces());
  for_each_edge(mesh, [&](Edge e) {
    if (mesh.is_boundary(e) || is_cut.contains(e)) return;
    const Halfedge a = mesh.halfedge_handle(e, 0), b = mesh.halfedge_handle(e, 1);
    corner.merge(index(a), index(mesh.prev_halfedge_handle(b)));
    corner.merge(index(b), index(mesh.prev_halfedge_handle(a)));
    piece.merge(index(mesh.face_handle(a)), index(mesh.face_handle(b)));
  });
  Classes component = components(mesh);
  std::map<std::size_t, Counts> pieces;
  std::map<std::size_t, std::set<std::size_t>> pieces_of_component;
  for_each_halfedge(mesh, [&](Halfedge h) {
    if (mesh.is_boundary(h)) return;
    const std::size_t p = piece.find(index(mesh.face_handle(h)));
    pieces_of_component[component.find(index(mesh.to_vertex_handle(h)))].insert(p);
    Counts& count = pieces[p];
    if (corner.find(index(h)) == index(h)) ++count.vertices;
    const Edge e = mesh.edge_handle(h);
    if (h.idx() % 2 == 0 || mesh.is_boundary(e) || is_cut.contains(e)) ++count.edges;
  });
  for_each_face(mesh, [&](Face f) { ++pieces[piece.find(index(f))].faces; });
  const auto counts = counts_by_component(mesh, {});
  for (const auto& [c, own_pieces] : pieces_of_component) {
    const bool is_sphere = counts.at(c).euler() == 2;
    if (own_pieces.size() != 1 || pieces[*own_pieces.begin()].euler() != (is_sphere ? 2 : 1)) return false;
  }
  return true;
}

bool has_loose_end(const Connectivity& mesh, const std::vector<Edge>& cut) {
  std::map<Vertex, int> degree;
  for (const Edge e : cut) {
    ++degree[mesh.to_vertex_handle(mesh.halfedge_handle(e, 0))];
    ++degree[mesh.to_vertex_handle(mesh.halfedge_handle(e, 1))];
  }
  return std::any_of(degree.begin(), degree.end(),
                     [&](const auto& end) { return end.second == 1 && !mesh.is_boundary(end.first); });
}

std::vector<double> random_lengths(const Connectivity& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> lengths(mesh.n_edges());
  // Sums of integers are exact, and sums this large seldom tie.
  for (double& length : lengths) length = static_cast<double>(random() % 100000000 + 1);
  return lengths;
}

void check_homology(const Connectivity& mesh, const Homology& found, std::initializer_list<long> primes) {
  for (const auto& [component, count] : counts_by_component(mesh, found)) CHECK(count.loops == count.first_betti());
  std::set<Edge> closing;
  for (const Loop& loop : found.generators) {
    CHECK(is_closed(mesh, loop));
    std::set<Vertex> met;
    for (const Halfedge h : loop) CHECK(met.insert(mesh.to_vertex_handle(h)).second);
    CHECK(loop.front().idx() % 2 == 0);
    closing.insert(mesh.edge_handle(loop.front()));
  }
  CHECK(closing.size() == found.generators.size());
  for (const Loop& loop : found.generators)
    CHECK(std::count_if(loop.begin(), loop.end(), [&](Halfedge h) { return closing.contains(mesh.edge_handle(h)); }) ==
          1);
  CHECK(is_basis(mesh, found.generators, primes));
  CHECK(std::is_sorted(found.cut_graph.begin(), found.cut_graph.end()));
  CHECK(cuts_into_discs(mesh, found.cut_graph));
  CHECK_FALSE(has_loose_end(mesh, found.cut_graph));
}

}  // namespace

TEST_SUITE("homology") {
  TEST_CASE("the generators are a basis modulo 2 and modulo a large prime, and the cut leaves discs") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool with_gaps) {
      CAPTURE(specimen.name);
      CAPTURE(with_gaps);
      const auto before = snapshot(mesh);
      check_homology(mesh, homology(mesh), {2, 1000003});
      CHECK(snapshot(mesh) == before);
      for (unsigned seed = 0; seed < (rbpa_test::all_trials() && mesh.n_faces() < 200 ? 3 : 1); ++seed) {
        const std::vector<double> lengths = random_lengths(mesh, seed);
        const Homology found = homology(mesh, lengths);
        check_homology(mesh, found, {2});
        CHECK(homology_generators(mesh, lengths) == found.generators);
      }
    });
  }

  TEST_CASE("the checks detect a set of loops that is not a basis") {
    TestMesh mesh = built(corpus()[8]);
    REQUIRE(corpus()[8].name == "double torus");
    const std::vector<Loop> basis = homology(mesh).generators;
    REQUIRE(basis.size() == 4);
    CHECK(is_basis(mesh, basis, {2, 3}));
    auto broken = basis;
    broken.pop_back();
    CHECK_FALSE(is_basis(mesh, broken, {2}));
    broken = basis;
    broken[3] = broken[0];
    CHECK_FALSE(is_basis(mesh, broken, {2}));
    broken[3] = sides(mesh, Face(0));
    CHECK_FALSE(is_basis(mesh, broken, {2}));
    broken = basis;
    broken[1].insert(broken[1].end(), basis[1].begin(), basis[1].end());  // twice around: a basis over Q, not over Z
    CHECK(is_basis(mesh, broken, {3}));
    CHECK_FALSE(is_basis(mesh, broken, {2}));
    broken = basis;
    broken[2].pop_back();
    CHECK_FALSE(is_basis(mesh, broken, {3}));
    broken = basis;
    std::reverse(broken[2].begin(), broken[2].end());
    for (Halfedge& h : broken[2]) h = mesh.opposite_halfedge_handle(h);
    CHECK(is_basis(mesh, broken, {2, 3}));
  }

  TEST_CASE("the checks detect a cut that leaves no disc") {
    for (const std::size_t which : {4u, 7u, 8u, 11u}) {
      TestMesh mesh = built(corpus()[which]);
      const std::vector<Edge> cut = homology(mesh).cut_graph;
      REQUIRE(cuts_into_discs(mesh, cut));
      for (std::size_t i = 0; i < cut.size(); ++i) {
        auto less = cut;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK_FALSE(cuts_into_discs(mesh, less));
      }
      std::set<Edge> more(cut.begin(), cut.end());
      for (const Edge e : mesh.fe_range(Face(0)))
        if (!mesh.is_boundary(e)) more.insert(e);
      CHECK_FALSE(cuts_into_discs(mesh, {more.begin(), more.end()}));
    }
  }

  TEST_CASE("discs and spheres have no cut and no loop") {
    for (const Specimen& specimen : corpus()) {
      if (specimen.genus != 0 || specimen.boundary_curves > specimen.components) continue;
      CAPTURE(specimen.name);
      TestMesh mesh;
      specimen.build(mesh);
      CHECK(homology(mesh).generators.empty());
      CHECK(homology(mesh).cut_graph.empty());
    }
    TestMesh nothing;
    CHECK(homology(nothing).generators.empty());
    CHECK(homology(nothing, std::vector<double>()).cut_graph.empty());
    nothing.new_vertex();
    CHECK(homology(nothing).generators.empty());
  }

  TEST_CASE(
      "the shortest loops of a torus of 5 by 4 squares have 4 and 5 edges, and those of an annulus of 5 squares 5") {
    const auto loop_lengths = [](std::size_t which) {
      TestMesh mesh = built(corpus()[which]);
      std::multiset<std::size_t> lengths;
      for (const Loop& loop : homology(mesh).generators) lengths.insert(loop.size());
      return lengths;
    };
    CHECK(loop_lengths(7) == std::multiset<std::size_t>{4, 5});
    CHECK(loop_lengths(4) == std::multiset<std::size_t>{5});
  }

  TEST_CASE("the cut of an annulus is a shortest path across") {
    TestMesh mesh = built(corpus()[4]);
    CHECK(homology(mesh).cut_graph.size() == 2);
    std::vector<double> lengths(mesh.n_edges(), 10);
    // A path of three short edges, from one curve to the other.
    const std::vector<Vertex> way = {Vertex(0), Vertex(5), Vertex(6), Vertex(11)};
    std::vector<Edge> expected;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const Halfedge h = mesh.find_halfedge(way[i], way[i + 1]);
      REQUIRE(h.is_valid());
      expected.push_back(mesh.edge_handle(h));
      lengths[index(expected.back())] = 1;
    }
    std::sort(expected.begin(), expected.end());
    CHECK(homology(mesh, lengths).cut_graph == expected);
  }

  TEST_CASE("with lengths the closing edges are those of the greedy choice by rank") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      if (mesh.n_faces() > 200) return;
      CAPTURE(specimen.name);
      const std::vector<double> lengths = random_lengths(mesh, 17);
      // Distances from the vertex of lowest index of each component by relaxing all edges, and the edges on shortest
      // paths.
      Classes component = components(mesh);
      std::map<std::size_t, Vertex> root;
      for_each_vertex(mesh, [&](Vertex v) { root.try_emplace(component.find(index(v)), v); });
      std::vector<double> distance(mesh.n_vertices(), std::numeric_limits<double>::infinity());
      for (const auto& [c, v] : root) distance[index(v)] = 0;
      const auto relax = [&](Halfedge h) {
        double& to = distance[index(mesh.to_vertex_handle(h))];
        const double way = distance[index(mesh.from_vertex_handle(h))] + lengths[index(mesh.edge_handle(h))];
        return way < to ? (to = way, true) : false;
      };
      for (bool changed = true; changed;) {
        changed = false;
        for_each_halfedge(mesh, [&](Halfedge h) { changed |= relax(h); });
      }
      std::map<Vertex, Halfedge> reached_by;
      std::vector<std::pair<double, Edge>> other;
      for_each_edge(mesh, [&](Edge e) {
        bool in_tree = false;
        for (const Halfedge h : {mesh.halfedge_handle(e, 0), mesh.halfedge_handle(e, 1)}) {
          const Vertex to = mesh.to_vertex_handle(h);
          if (distance[index(mesh.from_vertex_handle(h))] + lengths[index(e)] != distance[index(to)]) continue;
          in_tree = true;
          REQUIRE(reached_by.try_emplace(to, h).second);  // the tree is unique
        }
        const Halfedge h = mesh.halfedge_handle(e, 0);
        if (!in_tree)
          other.emplace_back(lengths[index(e)] + distance[index(mesh.from_vertex_handle(h))] +
                                 distance[index(mesh.to_vertex_handle(h))],
                             e);
      });
      std::sort(other.begin(), other.end());
      Independence independence(1000003);
      for_each_face(mesh, [&](Face f) { independence.add(chain(mesh, sides(mesh, f))); });
      std::vector<Edge> greedy;
      for (const auto& [length, e] : other) {
        std::vector<Halfedge> walk = {mesh.halfedge_handle(e, 0)};
        for (Vertex v = mesh.to_vertex_handle(walk[0]); reached_by.contains(v);
             v = mesh.from_vertex_handle(reached_by[v]))
          walk.push_back(mesh.opposite_halfedge_handle(reached_by[v]));
        for (Vertex v = mesh.from_vertex_handle(walk[0]); reached_by.contains(v);
             v = mesh.from_vertex_handle(reached_by[v]))
          walk.push_back(reached_by[v]);
        if (independence.add(chain(mesh, walk))) greedy.push_back(e);
      }
      std::sort(greedy.begin(), greedy.end());
      std::vector<Edge> closing;
      for (const Loop& loop : homology(mesh, lengths).generators) closing.push_back(mesh.edge_handle(loop.front()));
      CHECK(closing == greedy);
    });
  }

  TEST_CASE("invalid lengths are refused") {
    TestMesh mesh = built(corpus()[7]);
    std::vector<double> lengths(mesh.n_edges(), 1);
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      lengths[3] = bad;
      CHECK_THROWS_AS(homology(mesh, lengths), ContractViolation);
    }
    lengths.pop_back();
    lengths[3] = 0;
    CHECK_THROWS_AS(homology(mesh, lengths), ContractViolation);
    lengths.push_back(0);
    check_homology(mesh, homology(mesh, lengths), {2});
    check_homology(mesh, homology(mesh, std::vector<double>(mesh.n_edges(), 0)), {2});
  }
}
