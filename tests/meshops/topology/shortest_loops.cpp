#include "meshops/topology/shortest_loops.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <set>

#include "graph/support.h"
#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "support/arguments.h"
#include "support/corpus.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

using EdgeSet = std::vector<bool>;  // over Z/2

/// Elimination over Z/2, column by column.
class EdgeSpan {
 public:
  bool add(EdgeSet row) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (!row[column]) continue;
      const auto known = rows_.find(column);
      if (known == rows_.end()) {
        rows_.emplace(column, std::move(row));
        return true;
      }
      for (std::size_t i = column; i < row.size(); ++i) row[i] = row[i] != known->second[i];
    }
    return false;
  }

 private:
  std::map<std::size_t, EdgeSet> rows_;
};

std::size_t place(Edge e) { return static_cast<std::size_t>(e.idx()); }
std::size_t place(Vertex v) { return static_cast<std::size_t>(v.idx()); }

EdgeSet edges_of_walk(const Connectivity& mesh, const Loop& loop) {
  EdgeSet edges(mesh.n_edges(), false);
  for (const Halfedge h : loop) edges[place(mesh.edge_handle(h))] = !edges[place(mesh.edge_handle(h))];
  return edges;
}

EdgeSpan boundaries_of_faces(const Connectivity& mesh) {
  EdgeSpan boundaries;
  for_each_face(mesh, [&](Face f) {
    Loop around;
    for (const Halfedge h : mesh.fh_range(f)) around.push_back(h);
    boundaries.add(edges_of_walk(mesh, around));
  });
  return boundaries;
}

double length_of(const Connectivity& mesh, const Loop& loop, const std::vector<double>& lengths) {
  double sum = 0;
  for (const Halfedge h : loop) sum += lengths[place(mesh.edge_handle(h))];
  return sum;
}

/// Returns the cohomology by elimination alone: sets of edges with an even number at each face, modulo those that meet
/// a set of vertices in one end. The class of a walk is the parities with which it meets these sets.
std::vector<EdgeSet> cocycles_by_elimination(const Connectivity& mesh) {
  // The null space of faces × edges: rows in reduced form, and a solution for every free edge.
  std::vector<EdgeSet> rows;
  std::vector<std::size_t> leads;
  for_each_face(mesh, [&](Face f) {
    EdgeSet row(mesh.n_edges(), false);
    for (const Halfedge h : mesh.fh_range(f)) row[place(mesh.edge_handle(h))] = !row[place(mesh.edge_handle(h))];
    const auto subtract = [](EdgeSet& from, const EdgeSet& other) {
      for (std::size_t i = 0; i < from.size(); ++i) from[i] = from[i] != other[i];
    };
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (row[leads[i]]) subtract(row, rows[i]);
    const auto lead = std::find(row.begin(), row.end(), true);
    if (lead == row.end()) return;
    const auto at = static_cast<std::size_t>(lead - row.begin());
    for (EdgeSet& known : rows)
      if (known[at]) subtract(known, row);
    rows.push_back(row);
    leads.push_back(at);
  });
  EdgeSpan span;
  for_each_vertex(mesh, [&](Vertex v) {
    EdgeSet star(mesh.n_edges(), false);
    for (const Halfedge h : mesh.voh_range(v)) star[place(mesh.edge_handle(h))] = !star[place(mesh.edge_handle(h))];
    span.add(star);
  });
  std::vector<EdgeSet> found;
  for_each_edge(mesh, [&](Edge e) {
    if (std::find(leads.begin(), leads.end(), place(e)) != leads.end()) return;
    EdgeSet solution(mesh.n_edges(), false);
    solution[place(e)] = true;
    for (std::size_t i = 0; i < rows.size(); ++i) solution[leads[i]] = rows[i][place(e)];
    if (span.add(solution)) found.push_back(solution);
  });
  return found;
}

/// Returns the lengths of a shortest basis: the shortest closed walk of each class, by Dijkstra over vertices and
/// classes from every vertex, and then the greedy choice of classes.
std::vector<double> shortest_by_exhaustion(const Connectivity& mesh, const std::vector<double>& lengths) {
  const std::vector<EdgeSet> cocycles = cocycles_by_elimination(mesh);
  const std::size_t classes = std::size_t{1} << cocycles.size();
  std::vector<std::size_t> crossing(mesh.n_edges(), 0);
  for (std::size_t i = 0; i < cocycles.size(); ++i)
    for (std::size_t e = 0; e < crossing.size(); ++e)
      if (cocycles[i][e]) crossing[e] |= std::size_t{1} << i;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> shortest(classes, infinity);
  for_each_vertex(mesh, [&](Vertex root) {
    std::vector<double> distance(mesh.n_vertices() * classes, infinity);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto offer = [&](std::size_t state, double length) {
      if (length >= distance[state]) return;
      distance[state] = length;
      queue.emplace(length, state);
    };
    offer(place(root) * classes, 0);
    while (!queue.empty()) {
      const Entry top = queue.top();
      queue.pop();
      if (top.first > distance[top.second]) continue;
      for (const Halfedge h : mesh.voh_range(Vertex(static_cast<int>(top.second / classes)))) {
        const std::size_t e = place(mesh.edge_handle(h));
        offer(place(mesh.to_vertex_handle(h)) * classes + (top.second % classes ^ crossing[e]), top.first + lengths[e]);
      }
    }
    for (std::size_t c = 1; c < classes; ++c) shortest[c] = std::min(shortest[c], distance[place(root) * classes + c]);
  });
  std::vector<std::size_t> order;
  for (std::size_t c = 1; c < classes; ++c) order.push_back(c);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return shortest[a] < shortest[b]; });
  EdgeSpan span;
  std::vector<double> chosen;
  for (const std::size_t c : order) {
    EdgeSet bits(cocycles.size(), false);
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = (c >> i & 1) != 0;
    if (shortest[c] < infinity && span.add(bits)) chosen.push_back(shortest[c]);
  }
  return chosen;
}

/// Checks that the loops are closed, simple, independent modulo faces, and ascending. Returns: their lengths.
std::vector<double> check_loops(const Connectivity& mesh, const std::vector<Loop>& loops,
                                const std::vector<double>& lengths) {
  EdgeSpan span = boundaries_of_faces(mesh);
  std::vector<double> found;
  for (const Loop& loop : loops) {
    REQUIRE(!loop.empty());
    std::set<Vertex> met;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      CHECK(is_live(mesh, loop[i]));
      CHECK(mesh.to_vertex_handle(loop[i]) == mesh.from_vertex_handle(loop[(i + 1) % loop.size()]));
      CHECK(met.insert(mesh.to_vertex_handle(loop[i])).second);
    }
    CHECK(loop.front().idx() % 2 == 0);
    CHECK(span.add(edges_of_walk(mesh, loop)));
    found.push_back(length_of(mesh, loop, lengths));
  }
  CHECK(std::is_sorted(found.begin(), found.end()));
  return found;
}

std::vector<double> whole_lengths(const Connectivity& mesh, unsigned seed, unsigned most) {
  std::mt19937 random(seed);
  std::vector<double> lengths(mesh.n_edges());
  for (double& length : lengths) length = static_cast<double>(random() % most);
  return lengths;
}

}  // namespace

TEST_SUITE("shortest loops") {
  TEST_CASE("the basis is as short, loop by loop, as an exhaustive search finds, with ties and edges of length 0") {
    std::size_t compared = 0;
    for_each_specimen([&](const Specimen& specimen, const TestMesh& mesh, bool with_gaps) {
      if (mesh.n_faces() > 150) return;
      CAPTURE(specimen.name);
      CAPTURE(with_gaps);
      const auto before = snapshot(mesh);
      for (const unsigned most : {1U, 2U, 3U, 5U, 1000U, 100000000U}) {
        if (!rbpa_test::all_trials() && most != 1 && most != 3 && most != 1000) continue;
        for (unsigned seed = 0; seed < (rbpa_test::all_trials() ? 3 : 1); ++seed) {
          std::vector<double> lengths = whole_lengths(mesh, seed, most);
          if (most == 1) std::fill(lengths.begin(), lengths.end(), 1);
          const std::vector<Loop> loops = shortest_homology_basis(mesh, lengths);
          CHECK(check_loops(mesh, loops, lengths) == shortest_by_exhaustion(mesh, lengths));
          CHECK(loops == shortest_homology_basis(mesh, lengths));
          compared += loops.size();
          // With a limit, exactly the shorter loops are found.
          std::vector<double> known = check_loops(mesh, loops, lengths);
          for (const double below : {0.0, known.empty() ? 1 : known[known.size() / 2], 1e300}) {
            const std::size_t count =
                static_cast<std::size_t>(std::lower_bound(known.begin(), known.end(), below) - known.begin());
            const std::vector<Loop> shorter = shortest_homology_loops(mesh, lengths, below);
            CHECK(check_loops(mesh, shorter, lengths) ==
                  std::vector<double>(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(count)));
          }
        }
      }
      CHECK(snapshot(mesh) == before);
    });
    CHECK(compared > (rbpa_test::all_trials() ? 400U : 50U));
  }

  TEST_CASE("loops of large meshes are a basis, and none is longer than its peer in homology_generators()") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool with_gaps) {
      if (mesh.n_faces() <= 150 || with_gaps) return;
      CAPTURE(specimen.name);
      const std::vector<double> lengths = whole_lengths(mesh, 5, 1000);
      const std::vector<Loop> generators = homology_generators(mesh, lengths);
      std::vector<double> longer;
      for (const Loop& loop : generators) longer.push_back(length_of(mesh, loop, lengths));
      std::sort(longer.begin(), longer.end());
      const std::vector<double> found = check_loops(mesh, shortest_homology_basis(mesh, lengths), lengths);
      REQUIRE(found.size() == longer.size());
      for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] <= longer[i]);
    });
  }

  TEST_CASE("two loops have the same signature exactly if they are homologous") {
    for_each_specimen([](const Specimen& specimen, const TestMesh& mesh, bool) {
      if (mesh.n_faces() > 150) return;
      CAPTURE(specimen.name);
      const HomologySignature signature = homology_signature(mesh);
      CHECK(signature.loops == homology(mesh).generators.size());
      const auto sum = [&](const Loop& loop) {
        std::vector<std::uint64_t> bits(signature.words, 0);
        for (const Halfedge h : loop)
          for (std::size_t w = 0; w < bits.size(); ++w) bits[w] ^= signature.of(mesh.edge_handle(h))[w];
        return bits;
      };
      for_each_face(mesh, [&](Face f) {
        Loop around;
        for (const Halfedge h : mesh.fh_range(f)) around.push_back(h);
        CHECK(sum(around) == std::vector<std::uint64_t>(signature.words, 0));
      });
      EdgeSpan span;
      for (const Loop& loop : homology(mesh).generators) {
        EdgeSet bits;
        const auto found = sum(loop);
        for (std::size_t i = 0; i < signature.loops; ++i) bits.push_back((found[i / 64] >> i % 64 & 1) != 0);
        CHECK(span.add(bits));
      }
    });
  }

  TEST_CASE("a mesh can have more than 64 loops") {
    // A sheet of 19 by 19 squares with 9 by 9 holes, each a square.
    TestMesh mesh;
    std::vector<Corners> triangles;
    const auto at = [](int x, int y) { return 20 * y + x; };
    for (int y = 0; y < 19; ++y)
      for (int x = 0; x < 19; ++x) {
        if (x % 2 == 1 && y % 2 == 1) continue;
        triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
        triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      }
    add_triangles(mesh, 400, triangles);
    const std::vector<double> ones(mesh.n_edges(), 1);
    const std::vector<Loop> loops = shortest_homology_basis(mesh, ones);
    const std::vector<double> found = check_loops(mesh, loops, ones);
    CHECK(found == std::vector<double>(81, 4));
  }

  TEST_CASE("invalid lengths are refused, and the search can be cancelled") {
    TestMesh mesh = built(corpus()[8]);
    std::vector<double> lengths(mesh.n_edges(), 1);
    CHECK_THROWS_AS(shortest_homology_basis(mesh, std::vector<double>(lengths.size() - 1, 1)), ContractViolation);
    lengths[2] = -1;
    CHECK_THROWS_AS(shortest_homology_basis(mesh, lengths), ContractViolation);
    lengths[2] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(shortest_homology_basis(mesh, lengths), ContractViolation);
    CHECK(shortest_homology_basis(TestMesh(), {}).empty());
    std::vector<Corners> triangles;
    const auto torus_at = [](int x, int y) { return 40 * (y % 40) + x % 40; };
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        triangles.push_back({torus_at(x, y), torus_at(x + 1, y), torus_at(x + 1, y + 1)});
        triangles.push_back({torus_at(x, y), torus_at(x + 1, y + 1), torus_at(x, y + 1)});
      }
    TestMesh torus;
    add_triangles(torus, 1600, triangles);
    CHECK(shortest_homology_loops(torus, std::vector<double>(torus.n_edges(), 1), std::nan("")).empty());
    CHECK_THROWS_AS(shortest_homology_basis(torus, std::vector<double>(torus.n_edges(), 1), [] { return false; }),
                    Cancelled);
  }
}
