// What: the apex left of a front edge, remembered: a ball that finds none on this level need not look again on the next.
// Law:  the apex is a function of the points alone (docs/pivot.md, section 2), so it is sought once, without a radius;
//       each level only asks whether its circumradius is small enough.
// Cost: one pivot per edge in the whole run; 4 bytes per edge of the mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/pivot/front_pivot.h"
#include "rbpa/pivot/pivot.h"

namespace rbpa {

class Apexes {
 public:
  using Site = meshops::Site;

  /// Keeps a reference.
  explicit Apexes(const Pivot<long double>& pivot) : pivot_(pivot) {}

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

  /// Keeps what was found for a halfedge that is frozen: the triangle left of it waits for a later level. Where its
  /// other sides are on the front as well, their apexes are known with it.
  void keep(const meshops::Front& front, meshops::Halfedge h, std::optional<Site> apex) {
    at(h) = apex.value_or(none);
    if (!apex) return;
    const meshops::Site a = front.from_site(h), b = front.to_site(h), c = *apex;
    if (const auto next = front.boundary_out_of(b, c); next.is_valid()) at(next) = a;
    if (const auto before = front.boundary_into(c, a); before.is_valid()) at(before) = b;
  }

 private:
  static constexpr Site unknown = ~Site{0}, none = unknown - 1;

  static std::size_t edge_of(meshops::Halfedge h) { return static_cast<std::size_t>(h.idx()) / 2; }

  Site& at(meshops::Halfedge h) {
    const std::size_t edge = edge_of(h);
    if (edge >= of_edge_.size()) of_edge_.resize(edge + 4096, unknown);
    return of_edge_[edge];
  }

  const Pivot<long double>& pivot_;
  std::vector<Site> of_edge_;
};

}  // namespace rbpa
