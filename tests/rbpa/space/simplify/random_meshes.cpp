// Decimation of many random surfaces, down to the least number of triangles, and remeshing: topology, order, crossings.
#include "space/simplify/random_meshes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/validate.h"
#include "meshops/simplify/simplify.h"
#include "meshops/stellar/collapse.h"
#include "meshops/topology/report.h"
#include "meshops/topology/soup_defects.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/simplify/moving/vertex_ranks.h"
#include "rbpa/space/simplify/quadric_policy.h"
#include "rbpa/space/simplify/remesh.h"
#include "space/simplify/placed.h"
#include "support/arguments.h"

using namespace rbpa_test;
using meshops::Connectivity;
using rbpa::QuadricPolicy;

TEST_SUITE_BEGIN("space");

namespace {

/// Topology of a mesh: the totals, and Euler characteristic and number of boundary curves of each piece, sorted.
struct TopologyOfPieces {
  explicit TopologyOfPieces(const Connectivity& mesh) {
    const meshops::TopologyReport all = meshops::report(mesh);
    totals = {all.components, all.solid_components, all.boundary_curves, all.pinches, all.isolated};
    betti = all.betti;
    for (const auto& piece : all.per_component) pieces.emplace_back(piece.euler(), piece.boundary_curves);
    std::sort(pieces.begin(), pieces.end());
  }
  std::array<std::size_t, 5> totals;
  meshops::BettiNumbers betti;
  std::vector<std::pair<long, std::size_t>> pieces;
  friend bool operator==(const TopologyOfPieces&, const TopologyOfPieces&) = default;
};

bool has_crossing(const Connectivity& mesh, const std::vector<Point3>& places) {
  return !rbpa::crossing_triangles(places, rbpa::space::corners_of(mesh), 1).empty();
}

/// Checks at every tenth collapse that the mesh is a manifold of the same topology, and that triangles do not cross if
/// they must not.
struct WatchPieces : meshops::SimplifyVisitor {
  WatchPieces(const Connectivity& mesh, const QuadricPolicy& decides, bool is_free)
      : before(mesh), policy(decides), is_free_of_crossings(is_free) {}
  void collapsed(const Connectivity& mesh, const meshops::WeldEffect&, double) {
    if (++collapses % 10 == 0) check(mesh);
  }
  void check(const Connectivity& mesh) const {
    CHECK(meshops::validate(mesh).empty());
    CHECK(meshops::find_defects(meshops::soup_of(mesh)).empty());  // oriented, and a manifold, as triples of corners
    CHECK(TopologyOfPieces(mesh) == before);
    if (is_free_of_crossings) CHECK_FALSE(has_crossing(mesh, policy.places()));
  }
  const TopologyOfPieces before;
  const QuadricPolicy& policy;
  const bool is_free_of_crossings;
  std::size_t collapses = 0;
};

/// Returns whether places tell all vertices with triangles apart, their own or those of their neighbors.
bool has_order(const Placed& with) {
  const std::vector<std::uint32_t> rank = rbpa::space::vertex_ranks(with.mesh, with.places);
  std::set<std::uint32_t> different;
  for (const meshops::Vertex v : with.mesh.vertices())
    if (!with.mesh.is_isolated(v) && !different.insert(rank[static_cast<std::size_t>(v.idx())]).second) return false;
  return true;
}

/// Returns the triangles that are left of a surface with at most that many.
std::vector<std::array<Point3, 3>> left_of(const Triangles& t, std::size_t faces, const rbpa::QuadricOptions& options) {
  Placed with(t);
  QuadricPolicy policy(with.mesh, with.places, options);
  meshops::simplify(with.mesh, policy, {.faces = faces});
  return sorted_triangles(policy.places(), rbpa::space::corners_of(with.mesh));
}

}  // namespace

TEST_CASE("random surfaces keep their topology to the least number of triangles, in any order, without new crossings") {
  const auto count = static_cast<unsigned>(argument("surfaces", 300));
  std::size_t with_boundary = 0, with_handles = 0, of_several = 0, touching = 0, free = 0, ordered = 0, collapses = 0;
  for (unsigned seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    const Triangles t = random_surface(seed);
    Placed with(t);
    const rbpa::QuadricOptions options{
        .at_ends = seed % 3 == 0, .single_precision = seed % 4 == 0, .no_crossings = seed % 2 == 0};
    const bool is_free = options.no_crossings && !has_crossing(with.mesh, with.places);
    const bool is_ordered = has_order(with);
    QuadricPolicy policy(with.mesh, with.places, options);
    WatchPieces watch(with.mesh, policy, is_free);
    const auto made = meshops::simplify(with.mesh, policy, {}, watch);
    watch.check(with.mesh);
    if (!options.no_crossings)  // else a triangle far along the surface may have moved away from an edge
      for (const meshops::Edge e : meshops::live_edges(with.mesh)) {
        const Point3 place = policy.place(with.mesh, e);
        const auto h = with.mesh.halfedge_handle(e, 0);
        const bool is_forward = with.mesh.to_vertex_handle(h) == policy.survivor(with.mesh, e, place);
        CHECK((!policy.allows(with.mesh, e, place) ||
               meshops::collapse_blocker(with.mesh, is_forward ? h : with.mesh.opposite_halfedge_handle(h))));
      }
    std::mt19937 random(seed);
    const std::size_t faces = made.faces + random() % (t.corners.size() - made.faces + 1);
    if (is_ordered) CHECK(left_of(t, faces, options) == left_of(shuffled(t, random), faces, options));
    const auto& pieces = watch.before.pieces;
    collapses += made.collapses;
    with_boundary += watch.before.totals[2] > 0;
    with_handles += std::any_of(pieces.begin(), pieces.end(),
                                [](const auto& p) { return p.first + static_cast<long>(p.second) <= 0; });
    of_several += pieces.size() > 1;
    touching += is_ordered && std::set(with.places.begin(), with.places.end()).size() < with.places.size();
    free += is_free;
    ordered += is_ordered;
  }
  CHECK(collapses > 30 * count);
  for (const std::size_t some : {with_boundary, with_handles, of_several, touching, free}) CHECK(some > count / 4);
  CHECK(ordered > count * 9 / 10);
}

TEST_CASE("random surfaces are remeshed with their topology, to the same numbers in any order") {
  const auto count = static_cast<unsigned>(argument("surfaces", 300)) / 10;
  std::size_t ordered = 0;
  for (unsigned seed = 0; seed < count; ++seed) {
    CAPTURE(seed);
    const Triangles t = random_surface(seed);
    std::mt19937 random(seed);
    Placed one(t), other(shuffled(t, random));
    const bool is_ordered = has_order(one);
    const TopologyOfPieces before(one.mesh);
    const rbpa::RemeshOptions options{.length = std::array{0.4, 0.8, 1.5}[seed % 3], .rounds = 3};
    rbpa::remesh(one.mesh, one.places, options);
    rbpa::remesh(other.mesh, other.places, options);
    CHECK(meshops::validate(one.mesh).empty());
    CHECK(TopologyOfPieces(one.mesh) == before);
    ordered += is_ordered;
    if (!is_ordered) continue;
    CHECK(one.places == other.places);
    CHECK(meshops::soup_of(one.mesh).corners == meshops::soup_of(other.mesh).corners);
  }
  CHECK(ordered > count * 9 / 10);
}

TEST_SUITE_END();
