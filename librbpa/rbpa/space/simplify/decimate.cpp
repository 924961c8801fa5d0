#include "rbpa/space/simplify/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/simplify/simplify.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/simplify/distance/surface_distance.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Policy that also allows only collapses after which every triangle is certified to be near the given ones.
struct CertifiedPolicy : QuadricPolicy {
  using QuadricPolicy::QuadricPolicy;
  const space::SurfaceDistance* given = nullptr;
  double error = 0;
  std::size_t too_far = 0;

  bool allows(const meshops::Connectivity& mesh, meshops::Edge e, const Point3& place) {
    if (!QuadricPolicy::allows(mesh, e, place)) return false;
    const meshops::Halfedge h = mesh.halfedge_handle(e, 0);
    const meshops::Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
    if (is_near(mesh, a, b, place) && is_near(mesh, b, a, place)) return true;
    ++too_far;
    return false;
  }

 private:
  bool is_near(const meshops::Connectivity& mesh, meshops::Vertex moved, meshops::Vertex other,
               const Point3& place) const {
    const auto at = [&](meshops::Vertex v) { return places()[static_cast<std::size_t>(v.idx())]; };
    if (at(moved) == place) return true;  // its other triangles stay, and are certified
    for (const meshops::Halfedge out : mesh.voh_range(moved)) {
      const meshops::Vertex second = mesh.to_vertex_handle(out),
                            third = mesh.to_vertex_handle(mesh.next_halfedge_handle(out));
      if (mesh.is_boundary(out) || second == other || third == other) continue;
      if (!given->is_within({place, at(second), at(third)}, error)) return false;
    }
    return true;
  }
};

/// Returns the corners of the triangles of a mesh.
std::vector<std::array<std::uint32_t, 3>> corners_of(const meshops::Connectivity& mesh) {
  std::vector<std::array<std::uint32_t, 3>> all;
  for (const meshops::Face f : meshops::live_faces(mesh)) {
    auto& corners = all.emplace_back();
    meshops::Halfedge h = mesh.halfedge_handle(f);
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    }
  }
  return all;
}

/// Returns a distance from the given triangles that no point of the mesh exceeds.
double distance_of(const meshops::Connectivity& mesh, const std::vector<Point3>& places,
                   const space::SurfaceDistance& given, const GoOn& go_on) {
  meshops::Steps step(go_on);
  std::vector<space::SurfaceDistance::Corners> triangles;
  double least = 0, greatest = 0;
  for (const auto& [a, b, c] : corners_of(mesh)) {
    auto& corners = triangles.emplace_back(std::array{places[a], places[b], places[c]});
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    least = std::max(least, given.least(corners));
    step(64);
  }
  for (const auto& corners : triangles) {
    greatest = std::max(greatest, given.greatest(corners, least));
    step(256);
  }
  return greatest;
}

/// Counts the collapses that are refused.
struct Refusals : meshops::SimplifyVisitor {
  explicit Refusals(Decimation& all) : counts(all) {}
  void refused(const meshops::Connectivity&, meshops::Edge, const meshops::Blocker& why) {
    ++counts.refused[std::string(meshops::name(why.kind))];
  }
  void disallowed(const meshops::Connectivity&, meshops::Edge) { ++counts.refused[Decimation::turned]; }

  Decimation& counts;
};

void require_finite(const meshops::Connectivity& mesh, const std::vector<Point3>& places) {
  meshops::require_one_each("decimate", places.size(), "places", mesh.n_vertices(), "vertices");
  for (const meshops::Vertex v : meshops::live_vertices(mesh))
    if (!is_finite(places[static_cast<std::size_t>(v.idx())]))
      throw InvalidInput("decimate: found coordinates of vertex " + std::to_string(v.idx()) +
                         " that are not finite, expected numbers");
}

}  // namespace

Decimation decimate(meshops::Connectivity& mesh, std::vector<Point3>& places, const DecimationOptions& options,
                    const QuadricOptions& quadrics) {
  meshops::detail::enforce("decimate", meshops::simplify_blocker(mesh));
  require_finite(mesh, places);
  Decimation counts;
  for ([[maybe_unused]] const meshops::Face f : meshops::live_faces(mesh)) ++counts.given;
  counts.left = counts.given;
  meshops::require(!options.error || !std::isnan(*options.error),
                   "decimate: options.error is NaN, expected a distance");
  if (counts.given <= options.faces) {
    if (options.error || options.measured) counts.distance = 0;
    return counts;
  }
  std::optional<space::SurfaceDistance> beginning;
  if (options.error || options.measured) beginning.emplace(places, corners_of(mesh), options.go_on);
  CertifiedPolicy policy(mesh, places, quadrics);
  const meshops::SimplifyOptions limits{.faces = options.faces, .go_on = options.go_on};
  meshops::SimplifyResult made;
  if (options.error) {
    policy.given = &*beginning;
    policy.error = *options.error;
    made = meshops::simplify(mesh, policy, limits, Refusals(counts));
  } else {
    made = meshops::simplify(mesh, static_cast<QuadricPolicy&>(policy), limits, Refusals(counts));
  }
  counts.left = made.faces;
  counts.collapses = made.collapses;
  counts.is_exhausted = made.end == meshops::SimplifyEnd::exhausted;
  if (policy.too_far > 0) {
    counts.refused[Decimation::too_far] = policy.too_far;
    if ((counts.refused[Decimation::turned] -= policy.too_far) == 0) counts.refused.erase(Decimation::turned);
  }
  if (beginning)
    counts.distance =
        std::min(distance_of(mesh, policy.places(), *beginning, options.go_on), options.error.value_or(infinity));
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
  // Vertices ascend with their input indices, so that the order of the triangles stays canonical.
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
