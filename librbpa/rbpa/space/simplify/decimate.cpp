#include "rbpa/space/simplify/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/core/progress.h"
#include "meshops/simplify/simplify.h"
#include "meshops/stellar/undo.h"
#include "rbpa/base/error.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/simplify/moving/moved_triangles.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using space::index_of;

/// Policy that allows only collapses after which, in addition, all triangles are certified to be near the given ones.
struct CertifiedPolicy : QuadricPolicy {
  using QuadricPolicy::QuadricPolicy;
  const space::SurfaceDistance* given = nullptr;  // null if there is no limit
  double error = 0;
  std::vector<RecordedCollapse>* record = nullptr;
  const char* why = nullptr;  // key in Decimation::refused of the last forbidden collapse

  bool allows(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) {
    why = turns(mesh, e, place)     ? Decimation::turned
          : crosses(mesh, e, place) ? Decimation::crossing
          : is_far(mesh, e, place)  ? Decimation::too_far
                                    : nullptr;
    return why == nullptr;
  }
  void merge(const meshops::Connectivity& mesh, const meshops::WeldEffect& effect, const Point3& place) {
    if (record != nullptr) record->push_back({effect, places()[index_of(effect.survivor)], place});
    QuadricPolicy::merge(mesh, effect, place);
  }

 private:
  bool is_far(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) const {
    return given != nullptr &&
           !space::for_each_moved_triangle(mesh, e, places(), place,
                                           [&](const Point3&, const Point3& second, const Point3& third) {
                                             return given->is_within({place, second, third}, error);
                                           });
  }
};

/// Counts the refused collapses by reason.
struct Refusals : meshops::SimplifyVisitor {
  Refusals(Decimation& all, const CertifiedPolicy& of) : counts(all), policy(of) {}
  void refused(const meshops::Connectivity&, meshops::Edge, const meshops::Blocker& why) {
    ++counts.refused[std::string(meshops::name(why.kind))];
  }
  void disallowed(const meshops::Connectivity&, meshops::Edge) { ++counts.refused[policy.why]; }

  Decimation& counts;
  const CertifiedPolicy& policy;
};

/// The triangles of a mesh at some time, and the distance from them.
struct Snapshot {
  std::vector<Point3> places;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  space::SurfaceDistance distance;

  Snapshot(const meshops::Connectivity& mesh, std::vector<Point3> at, const meshops::GoOn& go_on)
      : places(std::move(at)), triangles(space::corners_of(mesh)), distance(places, triangles, go_on) {}

  /// Raises the distance of each vertex to the greatest one from the other triangles that is found at the vertex, in
  /// the middles of its triangles and, on request, of its edges.
  void raise(std::vector<double>& distances, const Snapshot& from, bool at_edges, meshops::Steps& step) const {
    const auto ask = [&](const Point3& p, std::initializer_list<std::uint32_t> vertices) {
      const double found = space::distance(p, from.distance.nearest_point(p, infinity)->place);
      for (const std::uint32_t v : vertices) distances[v] = std::max(distances[v], found);
      step(64);
    };
    std::vector<bool> is_done(places.size());
    for (auto corners : triangles) {
      // In an order that does not depend on numbers, so that sums are rounded alike.
      std::sort(corners.begin(), corners.end(), [&](auto a, auto b) { return places[a] < places[b]; });
      const auto [a, b, c] = corners;
      const Point3 &p = places[a], &q = places[b], &r = places[c];
      ask({(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3}, {a, b, c});
      for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const Point3 &s = places[v], &e = places[w];
        if (at_edges) ask({(s.x + e.x) / 2, (s.y + e.y) / 2, (s.z + e.z) / 2}, {v, w});
        if (is_done[v]) continue;
        is_done[v] = true;
        ask(s, {v});
      }
    }
  }
};

/// Calls run(), and then calls it again up to `rounds` times for the mesh as it is now, each time with greater weights
/// of the quadrics where the result was far from that mesh. Leaves mesh and policy as after the run whose result is
/// nearest. run() collapses edges by the policy, and returns whether it came to its end; if the first does not, it is
/// the only one. Throws what run() throws, and Cancelled; the mesh is then as after some collapse.
/// Source: Lawson, Contributions to the theory of linear least maximum approximation (1961): weights of squares that
/// grow with the errors lead toward the least greatest error.
template <typename Run>
void repeat_weighted(meshops::Connectivity& mesh, CertifiedPolicy& policy, std::size_t rounds,
                     const meshops::GoOn& go_on, const Run& run) {
  meshops::Steps step(go_on);
  std::vector<RecordedCollapse> collapses;
  policy.record = &collapses;
  const std::vector<QuadricPolicy::State> states = policy.states(mesh);
  const Snapshot before(mesh, policy.places(), go_on);
  std::vector<double> weights(mesh.n_vertices(), 1.0), best = weights;
  double least = infinity;
  const auto begin_again = [&](const std::vector<double>& with) {
    for (; !collapses.empty(); collapses.pop_back()) meshops::undo(mesh, collapses.back().effect);
    policy.restore(mesh, states, with);
  };
  bool is_best = true;
  for (std::size_t round = 0; run(); ++round) {
    const Snapshot after(mesh, policy.places(), go_on);
    std::vector<double> distances(mesh.n_vertices(), 0.0);
    after.raise(distances, before, true, step);
    // A merged vertex has the distance of the vertex that is left of it.
    for (auto c = collapses.rbegin(); c != collapses.rend(); ++c)
      distances[index_of(c->effect.removed.vertex)] = distances[index_of(c->effect.survivor)];
    before.raise(distances, after, false, step);
    const double greatest = *std::max_element(distances.begin(), distances.end());
    is_best = greatest < least;
    if (is_best) {
      least = greatest;
      best = weights;
    }
    if (round == rounds || greatest == 0) break;
    for (std::size_t v = 0; v < weights.size(); ++v) weights[v] *= std::max(1.0, 2 * distances[v] / greatest);
    begin_again(weights);
    is_best = false;
  }
  if (is_best) return;
  begin_again(best);
  run();
}

/// Returns how often the last collapses of a decimation are repeated: as often as takes little of its time.
std::size_t rounds_for(std::size_t given, std::size_t left) {
  return left == 0 ? 0 : std::min<std::size_t>(given / left / 32, 4);
}

}  // namespace

Decimation decimate(meshops::Connectivity& mesh, std::vector<Point3>& places, const DecimationOptions& options,
                    QuadricOptions quadrics, std::vector<RecordedCollapse>* record) {
  meshops::detail::enforce("decimate", meshops::simplify_blocker(mesh));
  space::require_places("decimate", mesh, places);
  Decimation counts;
  for ([[maybe_unused]] const meshops::Face f : meshops::live_faces(mesh)) ++counts.given;
  counts.left = counts.given;
  meshops::require(!options.error || !std::isnan(*options.error),
                   "decimate: options.error is NaN, expected a distance");
  meshops::require(!options.share || (*options.share >= 0 && *options.share <= 1),
                   "decimate: options.share is outside of the range from 0 to 1, or NaN");
  const auto of_share = static_cast<std::size_t>(static_cast<double>(counts.given) * options.share.value_or(0));
  const std::size_t limit = std::max(options.faces, of_share);
  const bool is_measured = options.error || options.measured;
  if (counts.given <= limit) {
    if (is_measured) counts.distance = 0;
    return counts;
  }
  std::optional<space::SurfaceDistance> beginning;
  if (is_measured) beginning.emplace(places, space::corners_of(mesh), options.go_on);
  quadrics.no_crossings = quadrics.no_crossings || options.no_crossings;
  CertifiedPolicy policy(mesh, places, quadrics);
  if (options.error) policy.given = &*beginning;
  policy.error = options.error.value_or(0);
  policy.record = record;
  const auto collapse_to = [&](std::size_t faces) {
    const meshops::SimplifyResult made =
        meshops::simplify(mesh, policy, {.faces = faces, .go_on = options.go_on}, Refusals(counts, policy));
    counts.left = made.faces;
    counts.collapses += made.collapses;
    counts.is_exhausted = made.end == meshops::SimplifyEnd::exhausted;
    return !counts.is_exhausted;
  };
  const std::size_t rounds = record == nullptr ? rounds_for(counts.given, limit) : 0;
  if (rounds == 0) {
    collapse_to(limit);
  } else if (collapse_to(3 * limit)) {
    const Decimation first = counts;
    repeat_weighted(mesh, policy, rounds, options.go_on, [&] {
      counts = first;
      return collapse_to(limit);
    });
  }
  if (beginning)
    counts.distance = std::min(space::distance_of(mesh, policy.places(), *beginning, options.go_on),
                               options.error.value_or(infinity));
  places = std::move(policy).places();
  return counts;
}

DecimatedSurface decimate(std::span<const Point3> points, const Surface& surface, const DecimationOptions& options) {
  SurfaceMesh made = surface_mesh(points, surface);
  meshops::request_status(made.mesh);
  std::vector<Point3> places = places_of(made.mesh);
  DecimatedSurface result;
  result.counts = decimate(made.mesh, places, options, {.at_ends = true});
  SurfaceOfTriangles left = surface_of(made.mesh, places);
  // Vertices ascend by input index, so the order of the triangles stays canonical.
  for (auto& triangle : left.triangles)
    for (std::uint32_t& corner : triangle) corner = made.input_index[corner];
  result.triangles = std::move(left.triangles);
  result.neighbors = std::move(left.neighbors);
  result.given = std::move(left.given);
  if (!surface.levels.empty())
    for (const std::uint32_t t : result.given) result.levels.push_back(surface.levels[t]);
  result.duplicates = surface.duplicates;
  result.distinct = surface.distinct;
  return result;
}

}  // namespace rbpa
