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
#include "rbpa/space/simplify/distance/distance_of_mesh.h"
#include "rbpa/space/simplify/moving/moved_triangles.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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
    if (record != nullptr)
      record->push_back({effect, places()[static_cast<std::size_t>(effect.survivor.idx())], place});
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
  const meshops::SimplifyOptions limits{.faces = std::max(options.faces, of_share), .go_on = options.go_on};
  const bool is_measured = options.error || options.measured;
  if (counts.given <= limits.faces) {
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
  const meshops::SimplifyResult made = meshops::simplify(mesh, policy, limits, Refusals(counts, policy));
  counts.left = made.faces;
  counts.collapses = made.collapses;
  counts.is_exhausted = made.end == meshops::SimplifyEnd::exhausted;
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
