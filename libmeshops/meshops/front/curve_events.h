// What: tells a visitor what a triangle has done to the curves of a front.
// Law:  begun − joined + split − closed is the change of the number of boundary curves.
#pragma once

#include <array>
#include <cstddef>

#include "meshops/core/reach.h"
#include "meshops/front/front.h"

namespace meshops::detail {

/// Some boundary halfedges, each on a curve of its own.
class DistinctCurves {
 public:
  void add(const Connectivity& mesh, Halfedge h) {
    for (std::size_t i = 0; i < count_; ++i)
      if (on_same_curve(mesh, curve_[i], h)) return;
    curve_[count_++] = h;
  }
  std::size_t count() const { return count_; }
  Halfedge operator[](std::size_t i) const { return curve_[i]; }

 private:
  std::array<Halfedge, 3> curve_;
  std::size_t count_ = 0;
};

/// How many curves a triangle will be glued to.
inline std::size_t curves_before(const Connectivity& mesh, const TriangleSides& sides) {
  DistinctCurves curves;
  for (const Halfedge h : sides.side)
    if (h.is_valid()) curves.add(mesh, h);
  return curves.count();
}

/// Tells the events of a triangle that has been inserted. Several curves are said to be joined first, and then split.
template <typename Visitor>
void tell_curves(const Front& front, const InsertedTriangle& triangle, std::size_t before, Visitor& visitor) {
  const Connectivity& mesh = front.mesh();
  DistinctCurves now;
  for (const Halfedge side : triangle.side)
    if (const Vertex v = mesh.from_vertex_handle(side); mesh.is_boundary(v)) now.add(mesh, mesh.halfedge_handle(v));
  if (before == 0 && now.count() > 0) visitor.curve_begun(front, now[0]);
  for (; before > 1; --before) visitor.curves_joined(front, now.count() > 0 ? now[0] : Halfedge());
  for (std::size_t i = 1; i < now.count(); ++i) visitor.curve_split(front, now[i - 1], now[i]);
  if (now.count() == 0) visitor.curve_closed(front);
}

}  // namespace meshops::detail
