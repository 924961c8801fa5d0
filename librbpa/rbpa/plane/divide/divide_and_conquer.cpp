#include "rbpa/plane/divide/divide_and_conquer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/core/large_pages.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/plane/divide/delaunay_edges.h"

namespace rbpa {
namespace {

using Edge = QuadEdges::Edge;
using Corner = QuadEdges::Corner;

/// Reads the triangles off the edges, and calls `fate` for each. Parts of the edges are processed by different threads.
class Extraction {
 public:
  Extraction(std::span<const SitePoint> places, QuadEdges& edges, Threads& threads)
      : places_(places), edges_(edges), threads_(threads) {}

  /// Extracts the triangles. Loops have no unpredictable branch, and read data that is still in a cache.
  void extract(const Fate& fate, meshops::Patch& patch, meshops::Outline* outline) {
    meshops::reserve_in_large_pages(patch.triangles, 2 * places_.size());
    meshops::reserve_in_large_pages(patch.across, 2 * places_.size());
    patch.triangles.resize(2 * places_.size());
    patch.across.resize(2 * places_.size());
    std::size_t kept = 0;
    in_order<Found>(
        threads_, (edges_.size() + edges_at_once - 1) / edges_at_once,
        [&](std::size_t part, Found& found) { find(part * edges_at_once, fate, found); },
        [&](std::size_t, Found& found) {
          found.first = kept;
          kept += found.size;
        },
        [&](std::size_t, const Found& found) { enter(found, patch); });
    patch.triangles.resize(kept);
    patch.across.resize(kept);
    meshops::FreshVector<std::array<Corner, 3>> corners(outline ? kept : 0);
    for_each_part(threads_, kept, triangles_at_once, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        for (std::size_t i = 0; i < 3; ++i) {
          const auto edge = static_cast<Edge>(patch.across[t][i]);
          if (outline) corners[t][i] = edges_.org(edge);
          patch.across[t][i] = edges_.number(QuadEdges::sym(edge));
        }
    });
    if (outline) draw(patch, corners, *outline);
  }

 private:
  /// The kept triangles whose least edges are in a part of the edges.
  struct Found {
    std::vector<Edge> least;
    std::vector<std::array<Edge, 3>> edges;
    std::vector<std::array<Corner, 3>> corners;
    std::size_t size = 0, first = 0;  // number of triangles; their position in the patch
  };

  void find(std::size_t first, const Fate& fate, Found& found) {
    const std::size_t last = std::min(first + edges_at_once, edges_.size());
    found.least.resize(last - first);
    found.edges.resize(last - first);
    found.corners.resize(last - first);
    std::size_t triangles = 0;
    for (auto s = static_cast<Edge>(first); s < last; ++s) {
      const Edge t = edges_.lnext(s), u = edges_.lnext(t);
      found.least[triangles] = s;
      triangles += static_cast<std::size_t>(s < t) & static_cast<std::size_t>(s < u);
    }
    found.size = 0;
    for (std::size_t k = 0; k < triangles; ++k) {
      const Edge s = found.least[k], t = edges_.lnext(s), u = edges_.lnext(t);
      const std::array corners = {edges_.org(s), edges_.org(t), edges_.org(u)};
      found.edges[found.size] = {s, t, u};
      found.corners[found.size] = corners;
      const int number = fate ? fate(places_[corners[0]], places_[corners[1]], places_[corners[2]]) : 0;
      for (const Edge edge : {s, t, u}) edges_.number(edge, number);
      found.size += number >= 0;
    }
  }

  /// Enters triangles into the patch; patch.across holds the edges of each triangle until all edges have their numbers.
  void enter(const Found& found, meshops::Patch& patch) {
    for (std::size_t k = 0; k < found.size; ++k) {
      const std::size_t t = found.first + k;
      for (std::size_t i = 0; i < 3; ++i) {
        patch.triangles[t][i] = places_[found.corners[k][i]].site;
        patch.across[t][i] = static_cast<int>(found.edges[k][i]);
        edges_.number(found.edges[k][i], static_cast<int>(3 * t + i));
      }
    }
  }

  /// Computes the outline of the patch; `corners` are the corners of its triangles.
  void draw(const meshops::Patch& patch, std::span<const std::array<Corner, 3>> corners,
            meshops::Outline& outline) const {
    outline.clear();
    constexpr int no_side = -1;
    std::vector<int> last(places_.size() + 1, no_side);  // last side of each corner v, at v + 1
    std::vector<int> outer;
    int side = 0;
    for (std::size_t t = 0; t < corners.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i, ++side) {
        const int beyond = patch.across[t][i];
        const std::size_t comes_first = side < beyond;  // no branch, as the result is unpredictable
        last[(corners[t][i] + 1) & (0 - comes_first)] = side;
        if (beyond < 0) [[unlikely]]
          outer.push_back(side);
      }
    for (const int s : outer) {
      const std::size_t t = static_cast<std::size_t>(s) / 3, i = static_cast<std::size_t>(s) % 3;
      (patch.across[t][i] == meshops::Patch::nothing ? outline.holes : outline.rim).push_back(s);
      last[corners[t][i] + 1] = no_side;
    }
    for (const int hole : outline.holes) outline.next_hole.push_back(meshops::next_hole(patch, hole));
    for (std::size_t v = 1; v < last.size(); ++v)
      if (last[v] != no_side) outline.inside.push_back(last[v]);
  }

  static constexpr std::size_t edges_at_once = 1u << 13, triangles_at_once = 1u << 14;
  std::span<const SitePoint> places_;
  QuadEdges& edges_;
  Threads& threads_;
};

}  // namespace

template <typename Real>
meshops::Patch divide_and_conquer(std::span<SitePoint> places, const Fate& fate, Threads& threads,
                                  const Checkpoint& working, meshops::Outline* outline) {
  meshops::Patch patch;
  if (outline) outline->clear();
  if (places.size() < 3) return patch;
  static_assert(DelaunayEdges<Real>::no_triangle == meshops::Patch::nothing);
  DelaunayEdges<Real> delaunay(places, &threads, working);
  Extraction(places, delaunay.edges(), threads).extract(fate, patch, outline);
  return patch;
}

template meshops::Patch divide_and_conquer<double>(std::span<SitePoint>, const Fate&, Threads&, const Checkpoint&,
                                                   meshops::Outline*);
template meshops::Patch divide_and_conquer<long double>(std::span<SitePoint>, const Fate&, Threads&, const Checkpoint&,
                                                        meshops::Outline*);

}  // namespace rbpa
