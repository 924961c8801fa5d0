// What: the apex left of a front edge, remembered: a ball that finds none on this level need not look again on the next.
// Law:  the apex is a function of the points alone (docs/pivot.md, section 2), so it is sought once, without a radius;
//       each level only asks whether its circumradius is small enough.
// Cost: one pivot per edge in the whole run; 4 bytes per edge of the mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meshops/core/large_pages.h"
#include "meshops/front/front.h"
#include "rbpa/pivot/front_pivot.h"
#include "rbpa/pivot/pivot.h"

namespace rbpa {

template <typename Real>
class Apexes {
 public:
  using Site = std::uint32_t;

  /// Keeps a reference.
  explicit Apexes(const Pivot<Real>& pivot) : pivot_(pivot) {}

  /// The Delaunay apex left of a boundary halfedge; nothing on the convex hull.
  std::optional<Site> operator()(const meshops::Front& front, meshops::Halfedge h) const {
    const std::size_t edge = edge_of(h);
    if (edge >= of_edge_.size() || of_edge_[edge] == unknown) return pivot_on(pivot_, front, h);
    return of_edge_[edge] == none ? std::nullopt : std::optional(of_edge_[edge]);
  }

  /// The apex is remembered, so that keep() would change nothing.
  bool is_kept(meshops::Halfedge h) const {
    const std::size_t edge = edge_of(h);
    return edge < of_edge_.size() && of_edge_[edge] != unknown;
  }

  /// Keeps the apex beyond a boundary halfedge, or that there is none, which somebody else has found.
  void remember(const meshops::Front& front, meshops::Halfedge h, std::optional<Site> apex) {
    at(front, h) = apex.value_or(none);
  }

  /// Keeps what was found for a halfedge that is frozen: the triangle left of it waits for a later level. Where its
  /// other sides are on the front as well, their apexes are known with it.
  void keep(const meshops::Front& front, meshops::Halfedge h, std::optional<Site> apex) {
    at(front, h) = apex.value_or(none);
    if (!apex) return;
    const meshops::Site a = front.from_site(h), b = front.to_site(h), c = meshops::Site(*apex);
    if (const auto next = front.boundary_out_of(b, c); next.is_valid()) at(front, next) = static_cast<Site>(a);
    if (const auto before = front.boundary_into(c, a); before.is_valid()) at(front, before) = static_cast<Site>(b);
  }

 private:
  static constexpr Site unknown = ~Site{0}, none = unknown - 1;

  static std::size_t edge_of(meshops::Halfedge h) { return static_cast<std::size_t>(h.idx()) / 2; }

  Site& at(const meshops::Front& front, meshops::Halfedge h) {
    const std::size_t edge = edge_of(h);
    if (edge >= of_edge_.size()) {
      if (of_edge_.empty()) {
        of_edge_.reserve(3 * front.sites());  // all the edges that there can be; what is not used is never touched
        meshops::prefer_large_pages(of_edge_.data(), of_edge_.capacity() * sizeof(Site));
      }
      of_edge_.resize(edge + 4096, unknown);
    }
    return of_edge_[edge];
  }

  const Pivot<Real>& pivot_;
  std::vector<Site> of_edge_;
};

}  // namespace rbpa
