#include "meshops/stellar/triangulate_face.h"

#include <algorithm>

#include "meshops/core/add_elements.h"
#include "meshops/stellar/relink.h"

namespace meshops {
namespace detail {
namespace {

struct Corner {
  int vertex;
  std::size_t number;
  friend auto operator<=>(const Corner&, const Corner&) = default;
};

}  // namespace

Polygon::Polygon(const Connectivity& mesh, Face face, Keep keep) : reason_(BlockerKind::no_triangulation, face) {
  if (!is_live(mesh, face)) {
    reason_ = Blocker(BlockerKind::missing, face);
    return;
  }
  const Halfedge first = mesh.halfedge_handle(face);
  std::vector<Corner> sorted;
  Halfedge h = first;
  do {
    sorted.push_back({mesh.from_vertex_handle(h).idx(), sides_.size()});
    sides_.push_back(h);
    corners_.push_back(mesh.from_vertex_handle(h));
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  std::sort(sorted.begin(), sorted.end());
  const auto same_vertex = [](const Corner& a, const Corner& b) { return a.vertex == b.vertex; };
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end(), same_vertex);
  if (keep == Keep::simplicial && repeated != sorted.end()) {
    // Two diagonals could join the same two vertices, which the table of parts cannot detect.
    reason_ = Blocker(BlockerKind::corner_repeated, Vertex(repeated->vertex));
    sides_.clear();
    return;
  }

  allowed_.assign(size() * size(), true);
  const auto forbid = [&](std::size_t i, Vertex v) {
    for (auto at = std::lower_bound(sorted.begin(), sorted.end(), Corner{v.idx(), 0});
         at != sorted.end() && at->vertex == v.idx(); ++at)
      allowed_[i * size() + at->number] = false;
  };
  for (std::size_t i = 0; i < size(); ++i) {
    forbid(i, corners_[i]);
    if (keep == Keep::manifold) continue;
    Halfedge out = sides_[i];
    do {
      forbid(i, mesh.to_vertex_handle(out));
      out = cw(mesh, out);
    } while (out != sides_[i]);
  }
}

TriangulateFaceEffect Polygon::cut(Connectivity& mesh, const std::vector<std::uint32_t>& apex) const {
  struct Part {
    std::size_t first, last;
    Halfedge closing;  // from the last corner to the first
  };
  TriangulateFaceEffect effect;
  AddedElements elements(mesh, 0, size() - 3, size() - 3);
  std::vector<Part> parts = {{0, size() - 1, sides_.back()}};
  /// Draws the diagonal of a part. Returns: the new halfedge from the last corner of the part to the first.
  const auto draw = [&](std::size_t first, std::size_t last, Halfedge from, Halfedge to) {
    const Halfedge diagonal = elements.edge(corners_[first], corners_[last]);
    effect.faces.push_back(elements.face());
    effect.diagonals.push_back(cut_face(mesh, from, to, diagonal, effect.faces.back()));
    return mesh.opposite_halfedge_handle(diagonal);
  };
  while (!parts.empty()) {
    const auto [first, last, closing] = parts.back();
    parts.pop_back();
    if (last - first < 2) continue;
    const std::size_t top = apex[first * size() + last];
    if (top - first > 1) parts.push_back({first, top, draw(first, top, sides_[first], sides_[top])});
    if (last - top > 1) parts.push_back({top, last, draw(top, last, sides_[top], closing)});
  }
  return effect;
}

}  // namespace detail

std::optional<Blocker> triangulate_face_blocker(const Connectivity& mesh, Face face, Keep keep) {
  const detail::Polygon polygon(mesh, face, keep);
  const auto any = [](Vertex, Vertex, Vertex) { return 0; };
  return detail::least_triangulation(polygon, any) ? std::nullopt : std::optional(polygon.reason());
}

}  // namespace meshops
