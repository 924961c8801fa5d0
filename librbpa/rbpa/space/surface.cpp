#include "rbpa/space/surface.h"

#include <algorithm>
#include <functional>
#include <string>

#include "rbpa/core/error.h"
#include "rbpa/parallel/in_order.h"
#include "rbpa/space/check_input.h"
#include "rbpa/space/predicate/normal_sign.h"
#include "rbpa/space/search/cells.h"
#include "rbpa/space/search/scaled_points.h"
#include "rbpa/space/star/find_rings.h"
#include "rbpa/space/star/surface_assembly.h"

namespace rbpa {
namespace {

/// All triangles of the rings for which keep(v, x, y) holds, of sites; see SurfaceAssembly::add().
template <typename Keep, typename IsNeeded>
void assemble(const space::Cells& cells, bool fits_double, std::size_t input_points, Threads& threads,
              const SurfaceOptions& options, Keep keep, IsNeeded is_needed, Surface& surface) {
  struct Workspace {
    space::Rings rings;
    std::size_t triangles;
  };
  static_assert(space::SurfaceAssembly::none == Surface::none);
  space::SurfaceAssembly assembly(cells);
  std::size_t triangles = 0;
  in_order<Workspace>(
      threads, assembly.parts(),
      [&](std::size_t part, Workspace& w) {
        space::find_rings(cells, fits_double, assembly.first_in(part), assembly.end_of(part), w.rings);
        w.triangles = assembly.add(part, w.rings, keep, is_needed);
      },
      [&](std::size_t, Workspace& w) {
        triangles += w.triangles;
        if (options.progress && !options.progress({triangles, cells.sites().size()})) throw Cancelled();
      },
      [](std::size_t, Workspace&) {});
  assembly.finish(input_points, threads, surface.triangles, surface.neighbors);

  surface.distinct = cells.sites().size();
  for (const auto& [site, index] : cells.equals()) surface.duplicates.push_back({index, cells.input_index()[site]});
  std::sort(surface.duplicates.begin(), surface.duplicates.end(),
            [](const Duplicate& d, const Duplicate& e) { return d.index < e.index; });
}

/// Whether a triangle agrees with the normals at its corners.
class SiteAgreement {
 public:
  SiteAgreement(const space::Cells& cells, std::span<const Point3> normals, bool fits_double, Threads& threads)
      : cells_(cells), normals_(normals), fits_double_(fits_double), own_(cells.sites().size()) {
    for_each_part(threads, own_.size(), 1u << 14, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) own_[i] = normals[cells.input_index()[i]];
    });
  }

  bool operator()(space::Site v, space::Site x, space::Site y) const {
    const Fast fast(*this, v, x, y);
    if (fits_double_ && cells_.equals().empty()) {
      int certain = 0;
      for (const space::Site corner : {v, x, y}) {
        const int sign = fast.sign_along(own_[corner]);
        if (sign < 0) return false;
        certain += sign;
      }
      if (certain == 3) return true;
    }
    const auto sites = cells_.sites();
    const space::TriangleNormal normal(sites[v], sites[x], sites[y]);
    for (const space::Site corner : {v, x, y}) {
      if (normal.sign_along(own_[corner]) <= 0) return false;
      const auto equals = cells_.equals();
      auto e = std::lower_bound(equals.begin(), equals.end(), corner,
                                [](const space::Cells::Equal& equal, space::Site site) { return equal.site < site; });
      for (; e != equals.end() && e->site == corner; ++e)
        if (normal.sign_along(normals_[e->index]) <= 0) return false;
    }
    return true;
  }

  /// Some triangle of a cycle at v may agree.
  bool may_agree(space::Site v, std::span<const space::Site> cycle) const {
    if (!fits_double_) return true;
    for (std::size_t k = 0; k < cycle.size(); ++k)
      if (Fast(*this, v, cycle[k], cycle[k == 0 ? cycle.size() - 1 : k - 1]).sign_along(own_[v]) >= 0) return true;
    return false;
  }

 private:
  /// In double, for points that fit it.
  class Fast {
   public:
    Fast(const SiteAgreement& all, space::Site v, space::Site x, space::Site y) {
      const auto sites = all.cells_.sites();
      const auto u = space::from<double>(sites[v], sites[x]), w = space::from<double>(sites[v], sites[y]);
      normal_ = space::cross(u, w);
      magnitude_ = {std::abs(u.y * w.z) + std::abs(u.z * w.y), std::abs(u.z * w.x) + std::abs(u.x * w.z),
                    std::abs(u.x * w.y) + std::abs(u.y * w.x)};
    }
    /// 0 when it is not certain.
    int sign_along(const Point3& m) const {
      const double product = normal_.x * m.x + normal_.y * m.y + normal_.z * m.z;
      const double bound =
          0x1p-50 * (magnitude_.x * std::abs(m.x) + magnitude_.y * std::abs(m.y) + magnitude_.z * std::abs(m.z));
      if (!(bound > 0x1p-900)) return 0;  // products may have underflown
      return product > bound ? 1 : product < -bound ? -1 : 0;
    }

   private:
    space::Vector3<double> normal_, magnitude_;
  };

  const space::Cells& cells_;
  std::span<const Point3> normals_;
  bool fits_double_;
  std::vector<Point3> own_;  // of each site, the normal of its lowest index
};

/// Few are done before another thread has woken.
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
  const SiteAgreement agrees(cells, normals, scaled.fits_double(), threads);
  Surface surface;
  assemble(
      cells, scaled.fits_double(), points.size(), threads, options, std::cref(agrees),
      [&](space::Site v, std::span<const space::Site> cycle) { return agrees.may_agree(v, cycle); }, surface);
  return surface;
}

}  // namespace rbpa
