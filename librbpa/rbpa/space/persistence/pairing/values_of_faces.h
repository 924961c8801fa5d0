// What: finds the value at which each triangle and edge of a triangulation enters a filtration, from the values of its
//       tetrahedra.
// How:  a face is alone if no other corner of the simplices around the face conflicts with it. A face that is alone has
//       a value of its own, any other the least value of the simplices around it. A rule decides conflicts and values:
//
//         rule.triangle(triangle).conflicts(corner), .value()       conflicts with, and value of, a triangle
//         rule.conflicts(triangle)       bit k is set if corner k conflicts with the edge across from it
//         rule.value(edge)
//
// Cost: linear; shared among threads.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/base/run/side_by_side.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/number_faces.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

inline constexpr std::size_t faces_at_a_time = 1u << 12;

/// Returns the value of each triangle. Requires: `delaunay` has neighbors; `values` are those of its tetrahedra;
/// `triangles` is number_triangles() of `delaunay`.
template <typename Rule>
std::vector<double> values_of_triangles(const Rule& rule, const Solid& delaunay, std::span<const double> values,
                                        const NumberedTriangles& triangles, Threads& threads, const GoOn& go_on) {
  const auto& simplices = delaunay.simplices;
  const auto& neighbors = delaunay.neighbors;
  const auto value = [&](std::uint32_t number, std::uint32_t t, std::size_t k) {
    const auto face = rule.triangle(triangles.corners[number]);
    double least = values[t];
    bool is_alone = !face.conflicts(simplices[t][k]);
    if (const std::uint32_t beyond = neighbors[t][k]; beyond != Solid::none) {
      least = std::min(least, values[beyond]);
      const auto back = static_cast<std::size_t>(std::find(neighbors[beyond].begin(), neighbors[beyond].end(), t) -
                                                 neighbors[beyond].begin());
      is_alone = is_alone && !face.conflicts(simplices[beyond][back]);
    }
    return is_alone ? face.value() : least;
  };
  std::vector<double> result(triangles.corners.size());
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, triangles.of.size(), faces_at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
      for (std::size_t k = 0; k < 4; ++k)
        if (neighbors[t][k] == Solid::none || t < neighbors[t][k])
          result[triangles.of[t][k]] = value(triangles.of[t][k], t, k);
  });
  return result;
}

/// Fills in filtration.edge_alpha. Requires: the edges, the triangles and the values of triangles are filled in.
template <typename Rule>
void find_values_of_edges(const Rule& rule, Threads& threads, const GoOn& go_on, SolidFiltration& filtration) {
  const auto& triangles = filtration.triangles;
  std::vector<std::uint8_t> is_alone(filtration.edges.size(), 1);
  auto& alpha = filtration.edge_alpha;
  alpha.assign(filtration.edges.size(), std::numeric_limits<double>::infinity());
  const auto find_least = [&](Steps& step, const GoOn&) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      step();
      for (const std::uint32_t edge : filtration.edges_of[i])
        alpha[edge] = std::min(alpha[edge], filtration.triangle_alpha[i]);
    }
  };
  const auto find_conflicts = [&](Steps&, const GoOn& goes_on) {
    for_each_part(threads, triangles.size(), faces_at_a_time, [&](std::size_t begin, std::size_t end) {
      stop_if_cancelled(goes_on);
      for (std::size_t i = begin; i < end; ++i)
        for (unsigned bits = rule.conflicts(triangles[i]), k = 0; bits != 0; bits >>= 1U, ++k)
          if ((bits & 1U) != 0)
            std::atomic_ref(is_alone[filtration.edges_of[i][k]]).store(0, std::memory_order_relaxed);
    });
  };
  side_by_side(threads, go_on, find_least, find_conflicts);
  CheckpointOfThreads checkpoint(go_on);
  for_each_part(threads, alpha.size(), faces_at_a_time, [&](std::size_t begin, std::size_t end) {
    checkpoint();
    for (std::size_t i = begin; i < end; ++i)
      if (is_alone[i] != 0) alpha[i] = rule.value(filtration.edges[i]);
  });
}

/// Fills in triangles, edges, and the values of tetrahedra and triangles; find_values_of_edges() fills in the values of
/// edges. Faces are numbered in one thread while the others compute values; values(go_on) returns the values of
/// tetrahedra. Requires: tetrahedra with neighbors.
template <typename Rule, typename Values>
void find_faces(const Rule& rule, std::size_t points, const Values& values, Threads& threads, const GoOn& go_on,
                SolidFiltration& filtration) {
  NumberedTriangles triangles;
  NumberedEdges edges;
  side_by_side(
      threads, go_on, [&](Steps& step, const GoOn&) { triangles = number_triangles(filtration.delaunay, step); },
      [&](Steps&, const GoOn& goes_on) { filtration.tetrahedron_alpha = values(goes_on); });
  side_by_side(
      threads, go_on, [&](Steps& step, const GoOn&) { edges = number_edges(points, triangles.corners, step); },
      [&](Steps&, const GoOn& goes_on) {
        filtration.triangle_alpha =
            values_of_triangles(rule, filtration.delaunay, filtration.tetrahedron_alpha, triangles, threads, goes_on);
      });
  filtration.triangles = std::move(triangles.corners);
  filtration.triangles_of = std::move(triangles.of);
  filtration.edges = std::move(edges.ends);
  filtration.edges_of = std::move(edges.of);
}

}  // namespace rbpa::space
