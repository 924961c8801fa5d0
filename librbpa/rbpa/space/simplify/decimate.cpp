#include "rbpa/space/simplify/decimate.h"

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/live_range.h"
#include "meshops/simplify/simplify.h"
#include "rbpa/base/error.h"
#include "rbpa/space/simplify/decimate_mesh.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {
namespace {

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
  if (counts.given <= options.faces) return counts;
  QuadricPolicy policy(mesh, places, quadrics);
  const meshops::SimplifyResult made =
      meshops::simplify(mesh, policy, {.faces = options.faces, .go_on = options.go_on}, Refusals(counts));
  counts.left = made.faces;
  counts.collapses = made.collapses;
  counts.is_exhausted = made.end == meshops::SimplifyEnd::exhausted;
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
