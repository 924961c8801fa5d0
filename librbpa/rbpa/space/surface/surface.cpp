#include "rbpa/space/surface/surface.h"

#include <functional>
#include <mutex>
#include <utility>

#include "rbpa/base/parallel/in_order.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/cells/scaled_points.h"
#include "rbpa/space/predicate/agreement.h"
#include "rbpa/space/surface/star/find_rings.h"
#include "rbpa/space/surface/star/surface_assembly.h"

namespace rbpa {
namespace {

/// Assembles the triangles of sites for which keep(v, x, y) returns true (SurfaceAssembly::add()):
///   1. find the rings of a part of the sites, in any thread (find_rings());
///   2. add the triangles of the part that are kept, and the rings that are needed for their neighbors;
///   3. report progress, part by part in order;
///   4. when all parts are added, number the triangles and look up their neighbors;
///   5. list the points that are equal to another one.
template <typename Keep, typename IsNeeded>
void assemble(const space::Cells& cells, bool fits_double, std::size_t input_points, Threads& threads,
              const SurfaceOptions& options, Keep keep, IsNeeded is_needed, Surface& surface) {
  struct Workspace {
    space::Rings rings;
    space::SurfaceAssembly::Part scratch;
    std::size_t triangles;
  };
  static_assert(space::SurfaceAssembly::none == Surface::none);
  space::SurfaceAssembly assembly(cells);
  std::mutex one_call;
  std::size_t triangles = 0;
  const GoOn go_on = [&] {
    const std::lock_guard<std::mutex> lock(one_call);
    return !options.progress || options.progress({triangles, cells.sites().size()});
  };
  in_order<Workspace>(
      threads, assembly.parts(),
      [&](std::size_t part, Workspace& w) {
        meshops::Steps step(go_on);
        space::find_rings(cells, fits_double, assembly.first_in(part), assembly.end_of(part), w.rings, step);
        w.triangles = assembly.add(part, w.rings, keep, is_needed, w.scratch);
      },
      [&](std::size_t, Workspace& w) {
        {
          const std::lock_guard<std::mutex> lock(one_call);
          triangles += w.triangles;
        }
        stop_if_cancelled(go_on);
      },
      [](std::size_t, Workspace&) {});
  assembly.finish(input_points, threads, surface.triangles, surface.neighbors);

  surface.distinct = cells.sites().size();
  surface.duplicates = cells.duplicates();
}

/// Returns the threads to use. Few points are left to one thread, as another would start too late.
Threads threads_for_sites(std::size_t points, unsigned wanted) { return Threads(points < 1000 ? 1 : wanted); }

}  // namespace

Surface exposed_triangles(std::span<const Point3> points, double radius, const SurfaceOptions& options) {
  space::check_radius(radius);
  space::check_points(points);
  Threads threads = threads_for_sites(points.size(), options.threads);
  const space::ScaledPoints scaled(points, radius);
  const space::Cells cells(scaled.points(), scaled.radius(), threads);
  Surface surface;
  assemble(
      cells, scaled.fits_double(), points.size(), threads, options, [](auto, auto, auto) { return true; },
      [](auto, const auto&) { return true; }, surface);
  return surface;
}

Surface surface(std::span<const Point3> points, std::span<const Point3> normals, double radius,
                const SurfaceOptions& options) {
  space::check_radius(radius);
  space::check_points(points);
  space::check_normals(points, normals);
  Threads threads = threads_for_sites(points.size(), options.threads);
  const space::ScaledPoints scaled(points, radius);
  const space::Cells cells(scaled.points(), scaled.radius(), threads);
  std::vector<Point3> own(cells.sites().size());  // for each site, the normal of its point of lowest index
  for_each_part(threads, own.size(), 1u << 14, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) own[i] = normals[cells.input_index()[i]];
  });
  std::vector<space::Agreement::Further> further;
  for (const auto& [site, index] : cells.equals()) further.push_back({site, normals[index]});
  const space::Agreement agrees(cells.sites(), own, std::move(further), scaled.fits_double());
  Surface surface;
  assemble(
      cells, scaled.fits_double(), points.size(), threads, options, std::cref(agrees),
      [&](space::Site v, std::span<const space::Site> cycle) { return agrees.may_agree(v, cycle); }, surface);
  return surface;
}

}  // namespace rbpa
