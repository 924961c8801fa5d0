// What: the beginning and the end of every run: from points to sites and an empty mesh, and from a mesh on sites to a
//       complex.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/large_pages.h"
#include "meshops/core/reserve.h"
#include "meshops/front/front.h"
#include "meshops/patch/assembler.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/plane/complex.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/mesh/monitor.h"

namespace rbpa {

class Assembly {
 public:
  /// Keeps references to `complex`, which is still empty, and to `threads`. Calls `progress`, if any, while points are
  /// sorted.
  /// Throws: Cancelled.
  Assembly(std::span<const Point> input, SolidAlphaComplex& complex, Threads& threads, const OnProgress& progress = {})
      : sites_(input, threads, checkpoint_of(progress, input.size())), threads_(threads), complex_(begin(complex)) {}
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  const Sites& sites() const { return sites_; }
  Mesh& mesh() { return complex_.mesh; }
  /// Returns whether all points are on a line, so that there is no triangle.
  /// Throws: Cancelled.
  bool are_collinear(const OnProgress& progress) const {
    return rbpa::are_collinear(
        sites_.beyond().empty() ? sites_.grid().points() : std::span<const Point>(sites_.points()),
        go_on_of(progress, sites_.size()));
  }

  /// Returns an assembler for patches on an empty mesh, a front on an empty mesh, or a front on assembled patches.
  meshops::PatchAssembler assembler() { return {complex_.mesh, sites_.size()}; }
  meshops::Front front() { return {complex_.mesh, sites_.size(), elements_at_a_time}; }
  meshops::Front front(meshops::AssembledPatches&& assembled) {
    return meshops::Front(std::move(assembled), elements_at_a_time);
  }

  /// Makes the complex from AssembledPatches or a Front; called once.
  template <typename Built>
  void finish(Built&& built) {
    complex_.isolated = isolated(built);
    std::vector<meshops::Site> site = std::forward<Built>(built).finish();
    const auto index = sites_.input_index();
    for_each_part(threads_, site.size(), vertices_at_a_time, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        const Point at = sites_.at(site[v]);
        complex_.mesh.set_point(meshops::Vertex(static_cast<int>(v)), {at.x, at.y, 0.0});
        site[v] = index[site[v]];
      }
    });
    complex_.input_index = std::move(site);  // `site` holds input indices now
    complex_.input_index.shrink_to_fit();
  }

 private:
  /// Returns the input indices of sites without a triangle, ascending. Marks the indices instead of sorting them, as
  /// most sites may be isolated.
  template <typename Built>
  std::vector<std::uint32_t> isolated(const Built& built) const {
    const auto index = sites_.input_index();
    const auto is_isolated = [&](std::size_t s) -> std::size_t {
      return built.is_free(static_cast<meshops::Site>(s)) ? 1 : 0;
    };
    std::size_t count = 0;
    for (std::size_t s = 0; s < index.size(); ++s) count += is_isolated(s);
    if (count == 0) return {};
    std::vector<std::uint32_t> found(count + 1);
    count = 0;
    for (std::size_t s = 0; s < index.size(); ++s) {
      found[count] = index[s];
      count += is_isolated(s);
    }
    found.resize(count);
    constexpr std::size_t bits = 64;
    std::vector<std::uint64_t> marked((index.size() + complex_.duplicates.size()) / bits + 1);
    for (const std::uint32_t i : found) marked[i / bits] |= std::uint64_t{1} << i % bits;
    count = 0;
    for (std::size_t word = 0; word < marked.size(); ++word)
      for (std::uint64_t left = marked[word]; left != 0; left &= left - 1)
        found[count++] = static_cast<std::uint32_t>(bits * word + static_cast<std::size_t>(std::countr_zero(left)));
    return found;
  }

  // 1 in the debug build, where meshes are validated: a validated mesh must have no spare elements
  static constexpr std::size_t elements_at_a_time = debug ? 1 : 4096;

  SolidAlphaComplex& begin(SolidAlphaComplex& complex) const {
    const std::size_t points = sites_.size();
    complex.distinct = points;
    complex.duplicates = sites_.duplicates();
    // A planar triangulation of n points has fewer than 3n edges and 2n faces. There are a few more vertices than
    // points, as each fan at a point has a vertex, also before fans are joined: up to a twelfth more for scattered
    // points, at an alpha of 0.7 spacings. Unused memory is never touched.
    const std::size_t vertices = points + points / 8 + 64, edges = 3 * points + elements_at_a_time,
                      faces = 2 * points + elements_at_a_time;
    meshops::reserve(complex.mesh, vertices, edges, faces);
    const auto& coordinates = complex.mesh.property(complex.mesh.points_property_handle()).data_vector();
    meshops::prefer_large_pages(coordinates.data(), coordinates.capacity() * sizeof(coordinates[0]));
    return complex;
  }

  static constexpr std::size_t vertices_at_a_time = 1u << 16;

  Sites sites_;
  Threads& threads_;
  SolidAlphaComplex& complex_;
};

}  // namespace rbpa
