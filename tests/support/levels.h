// What: checks the laws of the levels of a hierarchy.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "rbpa/hrbpa.h"
#include "rbpa/paper.h"
#include "support/triangle.h"

namespace rbpa_test {

inline rbpa::Hierarchy hierarchy(std::span<const rbpa::Point> points, double alpha, std::size_t leaf_capacity) {
  return rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = {}});
}

inline rbpa::Hierarchy hierarchy_by_paper(std::span<const rbpa::Point> points, double alpha,
                                          std::size_t leaf_capacity) {
  return rbpa::paper::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = {}});
}

inline std::size_t sum_of_taking_part(const rbpa::Hierarchy& h) {
  std::size_t sum = h.looked_in_vain;
  for (const rbpa::Level& level : h.levels) sum += level.taking_part;
  return sum;
}

/// Returns the first broken law of the numbers of the levels, "" when none is broken.
inline std::string wrong_numbers(const rbpa::Hierarchy& h, double alpha) {
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < h.levels.size(); ++i) {
    const rbpa::Level& level = h.levels[i];
    const std::string at = " at level " + std::to_string(i);
    if (!(level.alpha > 0) || level.alpha > alpha) return "alpha" + at;
    if (i > 0 && !(level.alpha > h.levels[i - 1].alpha && level.number > h.levels[i - 1].number)) return "order" + at;
    if (i + 1 < h.levels.size() && level.alpha != std::ldexp(h.least_radius, level.number)) return "radius" + at;
    if (level.taking_part > level.transferred || level.transferred > h.complex.distinct) return "points" + at;
    if (i == 0 && (level.transferred != h.complex.distinct || level.advancing != 0)) return "the beginning";
    if (level.triangles < triangles) return "triangles" + at;
    triangles = level.triangles;
    if (!(level.seconds >= 0)) return "seconds" + at;
  }
  if (triangles != h.complex.mesh.n_faces()) return "triangles of the last level";
  return "";
}

/// Returns the triangles that existed when a level ended, in canonical order.
inline std::vector<Triangle> triangles_after(const rbpa::Hierarchy& h, std::size_t level) {
  std::vector<Triangle> found;
  for (const auto face : h.complex.mesh.faces()) {
    if (rbpa::level_of(h, static_cast<std::size_t>(face.idx())) > level) continue;
    Triangle corners{};
    std::size_t i = 0;
    for (const auto v : face.vertices()) corners[i++] = h.complex.input_index[static_cast<std::size_t>(v.idx())];
    found.push_back(corners);
  }
  return canonical(std::move(found));
}

/// Checks that every face was inserted on the first level whose radius admits it: admits(a, b, c, alpha). If the final
/// mesh is the complex of alpha, this means that each level was the complex of its radius. Returns "" when it holds.
template <typename Admits>
std::string wrong_level(const rbpa::Hierarchy& h, std::span<const rbpa::Point> points, Admits admits) {
  for (const auto face : h.complex.mesh.faces()) {
    std::array<rbpa::Point, 3> corner;
    std::size_t i = 0;
    for (const auto v : face.vertices()) corner[i++] = points[h.complex.input_index[static_cast<std::size_t>(v.idx())]];
    const std::size_t f = static_cast<std::size_t>(face.idx()), at = rbpa::level_of(h, f);
    if (at >= h.levels.size()) return "face " + std::to_string(f) + " has no level";
    if (f >= h.levels[at].triangles || (at > 0 && f < h.levels[at - 1].triangles))
      return "level_of face " + std::to_string(f);
    if (!admits(corner[0], corner[1], corner[2], h.levels[at].alpha)) return "face " + std::to_string(f) + " too early";
    if (at > 0 && admits(corner[0], corner[1], corner[2], h.levels[at - 1].alpha))
      return "face " + std::to_string(f) + " too late";
  }
  return "";
}

}  // namespace rbpa_test
