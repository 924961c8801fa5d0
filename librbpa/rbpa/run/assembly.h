// What: what every run has in common: points to sites and an empty front, and a front that has run dry to a complex.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/large_pages.h"
#include "meshops/front/front.h"
#include "rbpa/core/complex.h"
#include "rbpa/run/report.h"
#include "rbpa/search/point_grid.h"

namespace rbpa {

template <typename Real>
class Assembly {
 public:
  /// Keeps references; the complex is empty yet. Asks `progress`, if any, while points are sorted. Throws Cancelled.
  Assembly(std::span<const Point> input, SolidAlphaComplex& complex, Threads& threads,
           const std::function<bool(const Progress&)>& progress = {})
      : grid_(input, threads, asking(progress, input.size())),
        threads_(threads),
        complex_(begin(complex)),
        front_(complex.mesh, grid_.points().size(), elements_at_a_time) {}
  Assembly(const Assembly&) = delete;
  Assembly& operator=(const Assembly&) = delete;

  const PointGrid<Real>& grid() const { return grid_; }
  meshops::Front& front() { return front_; }

  /// Makes the complex of what the front has built. Once.
  void finish() {
    const auto points = grid_.points();
    complex_.isolated = isolated();
    const std::vector<meshops::Site> site = front_.finish();
    complex_.input_index.resize(site.size());
    for_each_part(threads_, site.size(), vertices_at_a_time, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        const auto s = static_cast<std::size_t>(site[v]);
        complex_.input_index[v] = grid_.input_index()[s];
        complex_.mesh.set_point(meshops::Vertex(static_cast<int>(v)), {points[s].x, points[s].y, 0.0});
      }
    });
  }

 private:
  /// The input indices of sites without a triangle, ascending: not sorted but marked, as they may be most.
  std::vector<std::uint32_t> isolated() const {
    const auto index = grid_.input_index();
    const auto is_isolated = [&](std::size_t s) -> std::size_t {
      return front_.is_free(static_cast<meshops::Site>(s)) ? 1 : 0;
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
    std::vector<std::uint64_t> marked((index.size() + grid_.repetitions().size()) / bits + 1);
    for (const std::uint32_t i : found) marked[i / bits] |= std::uint64_t{1} << i % bits;
    count = 0;
    for (std::size_t word = 0; word < marked.size(); ++word)
      for (std::uint64_t left = marked[word]; left != 0; left &= left - 1)
        found[count++] = static_cast<std::uint32_t>(bits * word + static_cast<std::size_t>(std::countr_zero(left)));
    return found;
  }

  static constexpr std::size_t elements_at_a_time = debug ? 1 : 4096;  // 1: what is validated has no spare elements

  SolidAlphaComplex& begin(SolidAlphaComplex& complex) const {
    const std::size_t points = grid_.points().size();
    complex.distinct = points;
    for (const auto& r : grid_.repetitions()) complex.duplicates.push_back({r.index, r.stands_for});
    // A planar triangulation of n points has fewer than 3n edges and 2n faces. Vertices are a few more where fans meet in
    // one point, or wait to grow together: up to a twelfth of scattered points, at 0.7 spacings. What is not used is never
    // touched.
    const std::size_t vertices = points + points / 8 + 64, edges = 3 * points + elements_at_a_time,
                      faces = 2 * points + elements_at_a_time;
    complex.mesh.reserve(vertices, edges, faces);
    meshops::prefer_large_pages(complex.mesh, vertices, edges, faces);
    const auto& coordinates = complex.mesh.property(complex.mesh.points_property_handle()).data_vector();
    meshops::prefer_large_pages(coordinates.data(), coordinates.capacity() * sizeof(coordinates[0]));
    return complex;
  }

  static constexpr std::size_t vertices_at_a_time = 1u << 16;

  PointGrid<Real> grid_;
  Threads& threads_;
  SolidAlphaComplex& complex_;
  meshops::Front front_;
};

}  // namespace rbpa
