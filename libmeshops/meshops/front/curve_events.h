// What: reports to a visitor how the insertion or detachment of a triangle changed the boundary curves of a front.
// Law:  begun − joined + split − closed, as numbers of events, is the change of the number of boundary curves.
#pragma once

#include <array>
#include <cstddef>

#include "meshops/core/reach.h"
#include "meshops/front/engine_side.h"
#include "meshops/front/front.h"

namespace meshops::detail {

/// Set of boundary curves, each given by one of its halfedges.
class DistinctCurves {
 public:
  /// Holds the curves through the valid halfedges of `through`.
  DistinctCurves(const Connectivity& mesh, const std::array<Halfedge, 3>& through) : mesh_(mesh) {
    for (const Halfedge h : through)
      if (h.is_valid()) add(h);
  }
  /// Holds the curves through the boundary vertices of `through`.
  DistinctCurves(const Connectivity& mesh, const std::array<Vertex, 3>& through) : mesh_(mesh) {
    for (const Vertex v : through)
      if (mesh.is_boundary(v)) add(mesh.halfedge_handle(v));
  }
  std::size_t count() const { return count_; }
  Halfedge operator[](std::size_t i) const { return curve_[i]; }

 private:
  void add(Halfedge h) {
    for (std::size_t i = 0; i < count_; ++i)
      if (on_same_curve(mesh_, curve_[i], h)) return;
    curve_[count_++] = h;
  }
  const Connectivity& mesh_;
  std::array<Halfedge, 3> curve_;
  std::size_t count_ = 0;
};

inline std::array<Vertex, 3> corners(const Connectivity& mesh, Face triangle) {
  const Halfedge first = mesh.halfedge_handle(triangle), second = mesh.next_halfedge_handle(first);
  return {mesh.from_vertex_handle(first), mesh.from_vertex_handle(second), mesh.to_vertex_handle(second)};
}

/// Reports the events that lead from `before` curves to the curves `now`: first the joins, then the splits.
template <typename Visitor>
void notify_of_curves(Front& changed, std::size_t before, const DistinctCurves& now, Visitor& visitor,
                      AllSteps& steps) {
  const Front& front = changed;
  const auto notify = [&](auto event) { steps([&] { EngineSide(changed).notify(event); }); };
  if (before == 0 && now.count() > 0) notify([&] { visitor.curve_begun(front, now[0]); });
  for (; before > 1; --before) notify([&] { visitor.curves_joined(front, now.count() > 0 ? now[0] : Halfedge()); });
  for (std::size_t i = 1; i < now.count(); ++i) notify([&] { visitor.curve_split(front, now[i - 1], now[i]); });
  if (now.count() == 0) notify([&] { visitor.curve_closed(front); });
}

}  // namespace meshops::detail
