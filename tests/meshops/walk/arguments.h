// What: random arguments of steps: mostly valid ones, and all others too.
#pragma once

#include <vector>

#include "meshops/core/live.h"
#include "meshops/stellar/keep.h"
#include "support/meshes.h"
#include "walk/choices.h"

namespace meshops::test {

class Arguments {
 public:
  Arguments(Choices& choices, const TestMesh& mesh) : choices_(choices), mesh_(mesh) {}

  Vertex vertex() {
    return any<Vertex>(mesh_.n_vertices(), [&](Vertex v) { return is_live(mesh_, v); });
  }
  Face face() {
    return any<Face>(mesh_.n_faces(), [&](Face f) { return is_live(mesh_, f); });
  }
  /// Returns a vertex, which has `degree` edges half of the time.
  Vertex vertex(unsigned degree) {
    if (choices_.one_in(2)) return vertex();
    return any<Vertex>(mesh_.n_vertices(), [&](Vertex v) { return is_live(mesh_, v) && mesh_.valence(v) == degree; });
  }
  Edge edge() {
    return any<Edge>(mesh_.n_edges(), [&](Edge e) { return is_live(mesh_, e); });
  }
  Halfedge halfedge() {
    return any<Halfedge>(mesh_.n_halfedges(), [&](Halfedge h) { return is_live(mesh_, h); });
  }
  /// Returns a face with more than three sides, if there is one.
  Face polygon() {
    return any<Face>(mesh_.n_faces(), [&](Face f) { return is_live(mesh_, f) && mesh_.valence(f) > 3; });
  }
  Halfedge boundary() {
    return any<Halfedge>(mesh_.n_halfedges(), [&](Halfedge h) { return is_live(mesh_, h) && mesh_.is_boundary(h); });
  }
  /// Returns another boundary halfedge, near h half of the time: if neighbors matter, two random ones seldom are
  /// neighbors.
  Halfedge boundary_near(Halfedge h) {
    if (!is_live(mesh_, h) || choices_.one_in(2)) return boundary();
    switch (choices_.below(4)) {
      case 0:
        return mesh_.prev_halfedge_handle(h);
      case 1:
        return mesh_.next_halfedge_handle(mesh_.next_halfedge_handle(h));
      default:
        return mesh_.next_halfedge_handle(h);
    }
  }
  /// Returns a halfedge that leaves the same vertex, by the ring; sometimes another.
  Halfedge around(Halfedge h) {
    if (!is_live(mesh_, h) || choices_.one_in(12)) return halfedge();
    for (unsigned turns = choices_.below(5); turns > 0; --turns)
      h = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(h));
    return h;
  }
  Keep keep() { return choices_.one_in(2) ? Keep::manifold : Keep::simplicial; }

 private:
  /// Returns the first good handle from a random place on, if there is any; one time in sixteen, any handle.
  template <typename Handle, typename IsGood>
  Handle any(std::size_t count, IsGood is_good) {
    const auto n = static_cast<unsigned>(count);
    const auto at = static_cast<int>(choices_.below(n + 1));
    switch (choices_.below(64)) {
      case 0:
        return Handle();
      case 1:
        return Handle(static_cast<int>(n));
      case 2:
        return Handle(choices_.one_in(2) ? 1 << 30 : -2);
      case 3:
        return Handle(at);
      default:
        break;
    }
    for (int i = 0; i < static_cast<int>(n); ++i)
      if (const Handle handle((at + i) % static_cast<int>(n)); is_good(handle)) return handle;
    return Handle(at);
  }

  Choices& choices_;
  const TestMesh& mesh_;
};

}  // namespace meshops::test
