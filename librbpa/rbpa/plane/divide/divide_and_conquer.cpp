#include "rbpa/plane/divide/divide_and_conquer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/parallel/in_order.h"
#include "rbpa/plane/divide/delaunay_edges.h"

namespace rbpa {
namespace {

using Edge = QuadEdges::Edge;
using Corner = QuadEdges::Corner;

/// Reads the triangles off the edges, and asks of each whether it is kept. Parts of the edges are given to different threads.
class Extraction {
 public:
  Extraction(std::span<const SitePoint> places, QuadEdges& edges, Threads& threads)
      : places_(places), edges_(edges), threads_(threads) {}

  /// Loops have no unpredictable branch, and read what is still in a cache.
  void extract(const Fate& fate, meshops::Patch& patch) {
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
    for_each_part(threads_, kept, triangles_at_once, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t)
        for (int& side : patch.across[t]) side = edges_.number(QuadEdges::sym(static_cast<Edge>(side)));
    });
  }

 private:
  /// Triangles that have their least edges among some, and are kept.
  struct Found {
    std::vector<Edge> least;
    std::vector<std::array<Edge, 3>> edges;
    std::vector<std::array<Corner, 3>> corners;
    std::size_t size = 0, first = 0;  // how many; where in the patch
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
      const int number = fate(places_[corners[0]], places_[corners[1]], places_[corners[2]]);
      for (const Edge edge : {s, t, u}) edges_.number(edge, number);
      found.size += number >= 0;
    }
  }

  /// As `across` the edges of each triangle, until all have their numbers.
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

  static constexpr std::size_t edges_at_once = 1u << 13, triangles_at_once = 1u << 14;
  std::span<const SitePoint> places_;
  QuadEdges& edges_;
  Threads& threads_;
};

}  // namespace

template <typename Real>
meshops::Patch divide_and_conquer(std::span<SitePoint> places, const Fate& fate, Threads& threads,
                                  const std::function<void()>& working) {
  meshops::Patch patch;
  if (places.size() < 3) return patch;
  static_assert(DelaunayEdges<Real>::no_triangle == meshops::Patch::nothing);
  DelaunayEdges<Real> delaunay(places, &threads, working);
  Extraction(places, delaunay.edges(), threads).extract(fate, patch);
  return patch;
}

template meshops::Patch divide_and_conquer<double>(std::span<SitePoint>, const Fate&, Threads&,
                                                   const std::function<void()>&);
template meshops::Patch divide_and_conquer<long double>(std::span<SitePoint>, const Fate&, Threads&,
                                                        const std::function<void()>&);

}  // namespace rbpa
